"""Lines of routes say which way they go, and whose they are."""

from __future__ import annotations

import re

import pytest

from missiontree.mission.fleet import Fleet
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.ways import OccupancyGrid, Road, RoadGraph
from tests.reporting.map_plans import Doing, by_hand, place, unplanned, walker
from tests.reporting.test_map_view import drawn, of_class, words

A, B = Position(0, 0), Position(100, 0)
SCENE = Scene(places=(place("a", 0, 0), place("b", 100, 0)))


def walks(robot: str, *ends: tuple[Position, Position], start_s: float = 0.0) -> list[Doing]:
    return [
        Doing(
            robot, start_s + 9 * n, start_s + 9 * n + 9, "ba"[n % 2], moves=True, leg=(9.0 * n, 9.0 * n + 9, *way, 100)
        )
        for n, way in enumerate(ends)
    ]


def planned(*doings: Doing, robots: int = 1) -> Plan:
    return by_hand(SCENE, Fleet((walker(robots, place="a"),)), doings)


def heads(svg: str) -> list[list[tuple[float, float]]]:
    """Tips of the arrow heads of every route."""
    return [
        [(float(x), float(y)) for x, y in re.findall(r"M([\d.]+) ([\d.]+)l", part.get("d", ""))]
        for group in of_class(svg, "mt-map-route")
        for part in group
        if part.get("class") == "mt-fill"
    ]


def test_a_way_that_is_taken_twice_has_its_arrows_once() -> None:
    once = drawn(planned(*walks("walker-1", (A, B), (B, A))), 1)
    twice = drawn(planned(*walks("walker-1", (A, B), (B, A), (A, B), (B, A))), 1)
    assert heads(once) == heads(twice)
    assert len(heads(once)[0]) >= 4


def test_arrows_of_two_side_by_side_stand_one_past_the_other() -> None:
    first, second = heads(drawn(planned(*walks("walker-1", (A, B)), *walks("walker-2", (A, B)), robots=2), 1))
    assert len(first) == len(second) >= 2
    assert all(one[0] + 5 < other[0] for one, other in zip(first, second, strict=True))


def test_a_way_of_short_stretches_still_tells_its_direction() -> None:
    """A staircase of walls: no stretch between two corners is long enough for an arrow of its own."""
    size = 24
    rows = tuple(
        "".join("." if column - row in {0, 1} else "#" for column in range(size)) for row in range(size)
    )  # the first row is the top one
    scene = Scene(places=(place("a", 0.5, 23.5), place("b", 23.5, 0.5)), grid=OccupancyGrid(rows=rows, cell_m=1.0))
    there = (Position(0.5, 23.5), Position(23.5, 0.5))
    made = by_hand(scene, Fleet((walker(place="a"),)), walks("walker-1", there))
    (tips,) = heads(drawn(made, 1))
    assert tips


def test_the_eleventh_robot_of_the_fleet_has_the_hue_of_the_first_and_dashes() -> None:
    first, last = walks("walker-1", (A, B)), walks("walker-11", (A, B))
    svg = drawn(planned(*first, *last, robots=11), 1)
    dashes = [line.get("stroke-dasharray") for line in of_class(svg, "mt-line")]
    assert dashes == [None, "9 4"] * 2  # on the map, and in the key


@pytest.mark.parametrize(
    ("length_m", "rules", "arrows", "crosses"),
    [
        (100.0, {"one_way": True}, True, False),
        (100.0, {"one_way": True, "blocked": True}, False, True),
        (1.0, {"one_way": True}, False, False),
    ],
    ids=["one-way", "one-way and blocked", "too short for an arrow"],
)
def test_a_one_way_road_has_arrows_unless_nobody_can_use_it_or_there_is_no_room(
    length_m: float, rules: dict[str, bool], arrows: bool, crosses: bool
) -> None:
    road = Road(ends=("a", "near"), **rules)  # type: ignore[arg-type]
    places = (place("a", 0, 0), place("near", length_m, 0), place("far", 100, 50))
    svg = drawn(unplanned(Scene(places=places, roads=RoadGraph(roads=(road,)))))
    panel = of_class(svg, "mt-map-panel")[0]
    classes = {part.get("class") for part in panel.iter()}
    assert ("mt-map-one-way" in classes, "mt-map-blocked" in classes) == (arrows, crosses)
    assert ("one-way" in words(svg)) == (not rules.get("blocked", False))
