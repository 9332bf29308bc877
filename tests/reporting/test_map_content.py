"""What there is to show on a map: who stands where and what holds there, in words for those who point at it."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree.mission.area import Area, KeepOut
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.ways import Lift, Road, RoadGraph
from missiontree.reporting.maps.content import content_of
from missiontree.reporting.maps.things import MapContent, Thing
from tests.reporting.map_plans import place, unplanned, walker
from tests.reporting.test_map_view import drawn, of_class, words

AREA = Area(corners=((0, 0), (20, 0), (20, 20), (0, 20)))


def shown(scene: Scene) -> MapContent:
    return content_of(unplanned(scene))


def called(scene: Scene, name: str) -> list[Thing]:
    return [thing for thing in shown(scene).things if thing.id == name]


@pytest.mark.parametrize(
    ("known", "note"),
    [
        ({"position": Position(1, 1)}, ""),
        ({"last_seen": Position(1, 1)}, "position unknown, planned where it was seen last"),
        ({"search_area": AREA}, "position unknown, planned in the middle of its search area"),
    ],
)
def test_who_points_at_somebody_is_told_how_sure_it_is_that_it_stands_there(
    known: dict[str, Position | Area], note: str
) -> None:
    (thing,) = called(Scene(entities=(Entity(id="Mia", kind="person", **known),)), "Mia")  # type: ignore[arg-type]
    assert (thing.note, thing.sure) == (note, not note)


def test_traits_are_told_four_at_most() -> None:
    traits = ("blue", "heavy", "hot", "wet", "old")
    (thing,) = called(Scene(entities=(Entity(id="box", position=Position(0, 0), traits=traits),)), "box")
    assert thing.note == "is blue, is heavy, is hot, is wet"


def storeys(*, lifts: tuple[Lift, ...] = (), roads: tuple[Road, ...] = ()) -> Scene:
    return Scene(
        places=(place("hall", 0, 0), place("gate", 40, 0), place("top", 0, 0, "first")),
        roads=RoadGraph(lifts=lifts, roads=(Road(ends=("hall", "gate")), *roads)),
    )


def test_a_lift_that_is_out_of_order_says_so_and_stands_where_it_is() -> None:
    """Its position is known: nothing on the map, in the legend or in the terminal may call it unsure."""
    scene = storeys(lifts=(Lift(id="lift", stops=("hall", "top"), ride_s=5, blocked=True),))
    assert [(thing.label, thing.sure) for thing in called(scene, "lift")] == [
        ("lift to first, out of order", True),
        ("lift to ground, out of order", True),
    ]
    assert not any("position unknown" in word for word in words(drawn(unplanned(scene))))


def test_a_stop_that_is_named_twice_is_shown_once() -> None:
    scene = storeys(lifts=(Lift(id="lift", stops=("hall", "top", "hall"), ride_s=5),))
    assert [thing.spot.floor for thing in called(scene, "lift")] == ["ground", "first"]


def test_a_road_from_floor_to_floor_is_named_at_both_ends_and_is_no_line() -> None:
    scene = storeys(roads=(Road(ends=("gate", "top"), length_m=30),))
    ends = called(scene, "ramp gate - top")
    assert [(thing.label, thing.spot.floor, thing.note) for thing in ends] == [
        ("ramp to first", "ground", "ramp gate - top, 30 m long"),
        ("ramp to ground", "first", "ramp gate - top, 30 m long"),
    ]
    svg = drawn(unplanned(scene))
    assert len(of_class(svg, "mt-map-road")) == 1
    assert {"ramp to first", "ramp to ground", "lift or ramp"} <= set(words(svg))


@pytest.mark.parametrize(
    ("rule", "labels"),
    [
        ({"one_way": True}, ["ramp to first", "ramp from ground"]),
        ({"blocked": True}, ["ramp to first, blocked", "ramp to ground, blocked"]),
    ],
)
def test_a_ramp_tells_its_rule_where_it_begins(rule: dict[str, bool], labels: list[str]) -> None:
    scene = storeys(roads=(Road(ends=("gate", "top"), length_m=30, **rule),))  # type: ignore[arg-type]
    assert [thing.label for thing in called(scene, "ramp gate - top")] == labels


def pit_road(keep_out: KeepOut, **rules: object) -> tuple[bool, bool, str]:
    """Whether a road of 40 m whose middle is in the pit, or beside it, is blocked, or for some only; its note."""
    road = Road(ends=("a", "b"), **rules)  # type: ignore[arg-type]
    scene = Scene(
        places=(place("a", -10, 10), place("b", 30, 10)), roads=RoadGraph(roads=(road,)), keep_outs=(keep_out,)
    )
    fleet = Fleet((walker(1, place="a"), replace(walker(1, place="a"), id="crawler", label="Crawler")))
    (shown_road,) = content_of(unplanned(scene, fleet)).roads
    return shown_road.blocked, shown_road.limited, shown_road.note


def test_a_road_through_a_closed_area_is_as_closed_as_that_area() -> None:
    """The line from (-10, 10) to (30, 10) runs through the square from 0 to 20, and along the edge of the one from 10 to 30."""
    assert pit_road(KeepOut(id="pit", area=AREA)) == (True, False, "road a - b, closed by keep-out pit")
    some = KeepOut(id="pit", area=AREA, types=("crawler",))
    assert pit_road(some) == (False, True, "road a - b, closed to Crawler by keep-out pit")
    beside = Area(corners=((0, 10), (20, 10), (20, 30), (0, 30)))
    assert pit_road(KeepOut(id="pit", area=beside)) == (False, False, "road a - b")
    upstairs = replace(AREA, floor="first")
    assert pit_road(KeepOut(id="pit", area=upstairs)) == (False, False, "road a - b")
    assert pit_road(KeepOut(id="pit", area=AREA), blocked=True)[2] == "road a - b, blocked, closed by keep-out pit"


def test_areas_that_shut_a_road_to_one_type_each_shut_it_to_all() -> None:
    east = Area(corners=((20, 0), (25, 0), (25, 20), (20, 20)))
    scene = Scene(
        places=(place("a", -10, 10), place("b", 30, 10)),
        roads=RoadGraph(roads=(Road(ends=("a", "b")),)),
        keep_outs=(KeepOut(id="pit", area=AREA, types=("crawler",)), KeepOut(id="moor", area=east, types=("walker",))),
    )
    fleet = Fleet((walker(1, place="a"), replace(walker(1, place="a"), id="crawler", label="Crawler")))
    (road,) = content_of(unplanned(scene, fleet)).roads
    assert (road.blocked, road.limited) == (True, False)
    label = fleet.types[0].label
    assert road.note == f"road a - b, closed to {label} by keep-out moor, closed to Crawler by keep-out pit"


def test_robots_that_are_alike_are_one_thing_with_their_number() -> None:
    content = content_of(unplanned(Scene(places=(place("a", 0, 0),)), Fleet((walker(3, place="a"),))))
    assert [(thing.id, thing.count) for thing in content.things if thing.kind == "robot"] == [("walker", 3)]
