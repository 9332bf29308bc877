"""A floor of the map: labels keep off what is drawn, and where it is crowded those that matter least are left out and counted."""

from __future__ import annotations

import re

import pytest

from missiontree.mission.area import Area, Zone
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.ways import Road, RoadGraph, RoadNode
from missiontree.reporting.maps.boxes import Box
from missiontree.reporting.maps.panel import CROWDED, MOST_NODES
from tests.reporting.map_plans import Doing, by_hand, place, unplanned, walker
from tests.reporting.test_map_view import box, drawn, of_class, words

A, B = Position(0, 0), Position(100, 0)
PLACES = (place("a", 0, 0), place("b", 100, 0))
EDGE = Area(corners=((0, 0), (100, 0), (100, 60), (0, 60)))


def travelled() -> Plan:
    doings = [Doing("walker-1", 0, 9, "b", moves=True, leg=(0, 9, A, B, 100))]
    return by_hand(Scene(places=PLACES), Fleet((walker(place="a"),)), doings)


@pytest.mark.parametrize(
    "made",
    [
        travelled(),
        unplanned(Scene(places=PLACES, roads=RoadGraph(roads=(Road(ends=("a", "b")),)))),
        unplanned(Scene(places=PLACES, zones=(Zone(id="yard", area=EDGE),))),
    ],
    ids=["a route", "a road", "the edge of an area"],
)
def test_a_label_stands_off_a_line_that_begins_at_its_mark(made: Plan) -> None:
    """It would stand right of the mark, where the line runs."""
    svg = drawn(made, 1)
    at = box(of_class(svg, "mt-map-place")[0])
    level = (at.top + at.bottom) / 2
    cards = [box(card) for card in of_class(svg, "mt-map-card")]
    (first,) = (card for card in cards if abs(card.left - at.left) < 90 and card.meets(at.grown(60)))
    assert first.right <= at.left or not first.top < level < first.bottom


def test_alone_it_stands_right_of_its_mark() -> None:
    svg = drawn(unplanned(Scene(places=PLACES)))
    at, card = box(of_class(svg, "mt-map-place")[0]), box(of_class(svg, "mt-map-card")[0])
    assert card.left >= at.right
    assert card.top < (at.top + at.bottom) / 2 < card.bottom


def test_a_label_leaves_room_for_the_question_mark_of_whoever_is_missed() -> None:
    """It stands right above the middle of the mark's right edge, where the label would begin."""
    scene = Scene(places=PLACES, entities=(Entity(id="Mia", kind="person", last_seen=Position(50, 10)),))
    svg = drawn(unplanned(scene))
    asks = [
        Box(x - 3, y - 8, x + 3, y)
        for one in of_class(svg, "mt-map-unsure")
        if one.text == "?" and (x := float(one.get("x", "0"))) and (y := float(one.get("y", "0")))
    ]
    assert len(asks) == 2  # on the map, and in the box beside it
    assert not any(box(card).meets(ask) for card in of_class(svg, "mt-map-card") for ask in asks)


def rows(count: int) -> Plan:
    """So many places in the middle of much free ground, in columns of ten, each as near to the next as marks may be."""
    near = [
        place(f"p{number}", 3.1 * (number // 10), 3.1 * (number % 10), label=f"place {number}")
        for number in range(count)
    ]
    return unplanned(Scene(places=(*near, place("far", 100, 60), place("back", -60, -40))))


def test_where_it_is_crowded_no_plain_place_gets_a_label_with_a_line_to_it() -> None:
    assert of_class(drawn(rows(CROWDED - 10)), "mt-map-leader")
    assert not of_class(drawn(rows(CROWDED + 10)), "mt-map-leader")


def test_names_of_areas_that_find_no_room_are_counted() -> None:
    """Sixty zones, each a tenth of a metre wide, at one spot."""
    tiny = Area(corners=((50, 0), (50.1, 0), (50.1, 0.1), (50, 0.1)))
    zones = tuple(Zone(id=f"zone{number}", area=tiny) for number in range(60))
    said = words(drawn(unplanned(Scene(places=PLACES, zones=zones))))
    named = sum(word.startswith("zone") and word != "zone" for word in said)
    (remark,) = (word for word in said if "left out" in word)
    assert named >= 1
    assert named + int(re.findall(r"\d+", remark)[0]) == 60


@pytest.mark.parametrize(("count", "named"), [(MOST_NODES, True), (MOST_NODES + 1, False)])
def test_road_nodes_are_named_as_long_as_they_are_few(count: int, named: bool) -> None:
    nodes = tuple(
        RoadNode(id=f"node{number}", position=Position(20.0 * (number % 7), 20.0 * (number // 7)))
        for number in range(count)
    )
    said = words(drawn(unplanned(Scene(roads=RoadGraph(nodes=nodes)))))
    assert any(word.startswith("node") for word in said) == named
