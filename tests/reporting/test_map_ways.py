"""The line of a leg is the way that was charged: as long, and in time."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.estimation.travel import Leg, TravelModel
from missiontree.mission.area import Area, KeepOut
from missiontree.mission.fleet import RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import TravelLeg
from missiontree.mission.ways import Lift, OccupancyGrid, Road, RoadGraph, RoadNode
from missiontree.reporting.maps.ways import WayFinder, Waypoint, without_straight
from tests.reporting.map_plans import place, walker

HALL = Scene(
    places=(place("door", 0, 0), place("desk", 4, 3), place("roof", 4, 3, "first")),
    roads=RoadGraph(
        nodes=(RoadNode(id="bend", position=Position(4, 0)),),
        roads=(Road(ends=("door", "bend")), Road(ends=("bend", "desk"))),
        lifts=(Lift(id="lift", stops=("desk", "roof"), ride_s=10),),
    ),
)
DOOR, DESK, ROOF = Position(0, 0), Position(4, 3), Position(4, 3, floor="first")


def leg(origin: Position, destination: Position, start_s: float, end_s: float, metres: float, *via: str) -> TravelLeg:
    return TravelLeg(
        robot="walker-1",
        leaf=1,
        start_s=start_s,
        end_s=end_s,
        origin=origin,
        destination=destination,
        distance_m=metres,
        via=via,
    )


def at(line: tuple[Waypoint, ...], t_s: float) -> tuple[float, float]:
    """Where a robot is on a line at a time."""
    for before, after in pairwise(line):
        if before.t_s <= t_s <= after.t_s and after.t_s > before.t_s:
            share = (t_s - before.t_s) / (after.t_s - before.t_s)
            return before.x_m + share * (after.x_m - before.x_m), before.y_m + share * (after.y_m - before.y_m)
    raise AssertionError(t_s)


def length(line: tuple[Waypoint, ...]) -> float:
    return math.fsum(math.dist((a.x_m, a.y_m), (b.x_m, b.y_m)) for a, b in pairwise(line) if a.floor == b.floor)


def test_at_one_metre_per_second_a_robot_is_three_metres_on_after_three_seconds() -> None:
    """4 m to the bend and 3 m up: 7 s. After 3 s at (3, 0); after 5 s a metre past the bend."""
    line = WayFinder(HALL).line(leg(DOOR, DESK, 0, 7, 7, "door", "bend", "desk"), walker())
    assert at(line, 3) == pytest.approx((3, 0))
    assert at(line, 5) == pytest.approx((4, 1))
    assert [(one.t_s, one.x_m, one.y_m) for one in line if one.t_s == 4] == [(4, 4, 0)]


def test_a_lift_takes_its_ride_and_the_rest_of_the_time_is_walked() -> None:
    """7 m at 0.5 m/s take 14 s, from 100 s on; the ride takes 10 s more."""
    line = WayFinder(HALL).line(leg(DOOR, ROOF, 100, 124, 7, "door", "bend", "desk", "roof"), walker(speed_mps=0.5))
    assert [(round(one.t_s, 6), one.floor) for one in line][-3:] == [(114, "ground"), (124, "first"), (124, "first")]
    assert at(line, 104) == pytest.approx((2, 0))


def test_between_a_road_and_a_lift_the_quicker_is_drawn() -> None:
    """A road of 30 m beside a lift of 10 s, then 10 m of road. At 1 m/s by lift: at b after 10 s. At 5 m/s by road: after 6 s."""
    scene = Scene(
        places=(place("a", 0, 0), place("b", 30, 0), place("c", 40, 0)),
        roads=RoadGraph(
            roads=(Road(ends=("a", "b")), Road(ends=("b", "c"))),
            lifts=(Lift(id="belt", stops=("a", "b"), ride_s=10),),
        ),
    )
    ways, start, goal = WayFinder(scene), Position(0, 0), Position(40, 0)
    ride = ways.line(leg(start, goal, 0, 20, 10, "a", "b", "c"), walker(speed_mps=1))
    walk = ways.line(leg(start, goal, 0, 8, 40, "a", "b", "c"), walker(speed_mps=5))
    assert [one.t_s for one in ride if one.x_m == 30] == [10]
    assert [one.t_s for one in walk if one.x_m == 30] == [6]


def test_a_closed_way_is_not_taken_for_the_quicker_one() -> None:
    """The short road is blocked, so 9 of 10 s go to the 90 m from a to b, one to the 10 m from b to c."""
    scene = Scene(
        places=(place("a", 0, 0), place("b", 9, 0), place("c", 10, 0)),
        roads=RoadGraph(
            roads=(
                Road(ends=("a", "b"), blocked=True),
                Road(ends=("a", "b"), length_m=90),
                Road(ends=("b", "c"), length_m=10),
            )
        ),
    )
    line = WayFinder(scene).line(leg(Position(0, 0), Position(10, 0), 0, 10, 100, "a", "b", "c"), walker(speed_mps=10))
    assert [round(one.t_s, 6) for one in line if one.x_m == 9] == [9]


def test_without_a_known_speed_the_time_is_shared_out_by_metres() -> None:
    """A move of nominal 60 s: after half of it, half of the 7 m."""
    line = WayFinder(HALL).line(leg(DOOR, DESK, 0, 60, 7, "door", "bend", "desk"), walker(speed_mps=None))
    assert at(line, 30) == pytest.approx((3.5, 0))


def test_a_leg_that_takes_no_time_is_there_at_once() -> None:
    line = WayFinder(HALL).line(leg(DOOR, ROOF, 5, 5, 7, "door", "bend", "desk", "roof"), walker(speed_mps=None))
    assert {one.t_s for one in line} == {5}
    assert (line[-1].x_m, line[-1].y_m, line[-1].floor) == (4, 3, "first")


@pytest.mark.parametrize("kind", [walker(), None])
def test_a_leg_that_the_map_does_not_have_is_drawn_all_the_same(kind: RobotType | None) -> None:
    """Of a plan changed by hand: nodes that are not there, a step that no road makes, a floor that nothing leads to."""
    ways = WayFinder(HALL)
    for odd in (
        leg(DOOR, DESK, 0, 7, 7, "nowhere", "bend"),
        leg(DOOR, DESK, 0, 7, 7, "door", "roof"),
        leg(DOOR, ROOF, 0, 7, 7),
    ):
        line = ways.line(odd, kind)
        assert (line[0].t_s, line[-1].t_s) == (0, 7)
        assert (line[-1].x_m, line[-1].y_m) == (4, 3)
        assert all(a.t_s <= b.t_s for a, b in pairwise(line))


@st.composite
def grids(draw: st.DrawFn) -> Scene:
    rows = draw(st.lists(st.text("..#", min_size=7, max_size=7), min_size=4, max_size=7))
    return Scene(grid=OccupancyGrid(rows=tuple(rows), cell_m=0.5))


@given(grids(), st.tuples(*[st.floats(0, 3.4)] * 2), st.tuples(*[st.floats(0, 1.9)] * 2))
def test_on_a_grid_the_drawn_way_is_as_long_as_the_charged_one(
    scene: Scene, across: tuple[float, float], up: tuple[float, float]
) -> None:
    start, goal = Position(across[0], up[0]), Position(across[1], up[1])
    charged = TravelModel(scene).leg(walker(), start, goal)
    if isinstance(charged, Leg) and charged.distance_m > 0:
        metres = charged.distance_m
        there = WayFinder(scene).line(leg(start, goal, 0, metres, metres), walker())
        assert length(there) == pytest.approx(metres)
        back = WayFinder(scene).line(leg(goal, start, 0, metres, metres), walker())
        assert [(one.x_m, one.y_m) for one in there] == [(one.x_m, one.y_m) for one in back][::-1]


@given(
    st.lists(st.tuples(st.floats(1, 9), st.floats(1, 9), st.floats(0.5, 4), st.floats(0.5, 4)), max_size=3),
    st.tuples(st.floats(0, 12), st.floats(0, 12)),
)
def test_round_keep_outs_the_drawn_way_is_as_long_as_the_charged_one(
    boxes: list[tuple[float, float, float, float]], end: tuple[float, float]
) -> None:
    areas = [Area(corners=((x, y), (x + w, y), (x + w, y + h), (x, y + h))) for x, y, w, h in boxes]
    scene = Scene(keep_outs=tuple(KeepOut(id=f"k{number}", area=area) for number, area in enumerate(areas)))
    start, goal = Position(0, 0), Position(*end)
    charged = TravelModel(scene).leg(walker(), start, goal)
    if isinstance(charged, Leg) and charged.distance_m > 0:
        line = WayFinder(scene).line(leg(start, goal, 0, 1, charged.distance_m), walker())
        assert length(line) == pytest.approx(charged.distance_m)


def test_points_on_a_straight_line_and_repeated_ones_are_left_out() -> None:
    assert without_straight([(0, 0), (1, 0), (1, 0), (2, 0), (2, 1), (2, 3), (1, 3)]) == [
        (0, 0),
        (2, 0),
        (2, 3),
        (1, 3),
    ]
    assert without_straight([(0, 0), (2, 0), (1, 0)]) == [(0, 0), (2, 0), (1, 0)]  # back again is no straight line
    assert without_straight([(1, 1), (1, 1)]) == [(1, 1), (1, 1)]
