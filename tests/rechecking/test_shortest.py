"""The least length of a way, against lengths worked out by hand."""

from __future__ import annotations

import math

import pytest

from missiontree.mission.area import Area, KeepOut
from missiontree.mission.fleet import RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.ways import Lift, OccupancyGrid, Road, RoadGraph, RoadNode
from missiontree.rechecking.shortest import Ways

CART = RobotType(id="cart", count=1)
WEST, EAST = Position(0, 3), Position(10, 4)


def roads(*given: Road, lifts: tuple[Lift, ...] = ()) -> RoadGraph:
    """Nodes a (0, 0), b (10, 0), c (10, 100) and, upstairs, d (10, 0)."""
    nodes = (
        RoadNode(id="a", position=Position(0, 0)),
        RoadNode(id="b", position=Position(10, 0)),
        RoadNode(id="c", position=Position(10, 100)),
        RoadNode(id="d", position=Position(10, 0, floor="upper")),
    )
    return RoadGraph(nodes=nodes, roads=given, lifts=lifts)


def test_without_roads_it_is_the_straight_line() -> None:
    """(3, 4, 5); at 2 m/s, 2.5 s."""
    ways = Ways(Scene())
    assert ways.least(CART, Position(0, 0), Position(3, 4)) == 5
    assert ways.least(CART, Position(0, 0), Position(3, 4), 2.0) == 2.5
    assert ways.least(CART, Position(0, 0), Position(0, 0, floor="upper")) == math.inf


def test_on_a_grid_it_may_be_shorter_by_the_diagonal_of_a_cell() -> None:
    """Each end is at most half a diagonal from the middle of its cell."""
    ways = Ways(Scene(grid=OccupancyGrid(rows=("." * 20,), cell_m=1.0)))
    assert ways.least(CART, Position(0, 0), Position(10, 0)) == pytest.approx(10 - math.sqrt(2))
    assert ways.least(CART, Position(0, 0), Position(1, 0)) == 0


def test_roads_are_joined_at_the_nearest_node() -> None:
    """3 m down to a, 10 m to b, 4 m up."""
    ways = Ways(Scene(roads=roads(Road(ends=("a", "b")))))
    assert ways.least(CART, WEST, EAST) == 17


def test_a_road_may_be_shorter_than_it_looks() -> None:
    ways = Ways(Scene(roads=roads(Road(ends=("a", "b"), length_m=1))))
    assert ways.least(CART, WEST, EAST) == 8


@pytest.mark.parametrize("closed", [{"blocked": True}, {"one_way": True}, {"types": ("tram",)}])
def test_a_road_that_is_closed_is_gone_round(closed: dict[str, bool | tuple[str, ...]]) -> None:
    """From b to a only by c: 100 m and the 300 m of the long road, where the short one is blocked, one-way or for others."""
    graph = roads(
        Road(ends=("a", "b"), **closed),  # type: ignore[arg-type]
        Road(ends=("b", "c")),
        Road(ends=("c", "a"), length_m=300),
    )
    assert Ways(Scene(roads=graph)).least(CART, Position(10, 0), Position(0, 0)) == 400


def test_a_lift_takes_time_and_no_metres() -> None:
    """10 m to b at 2 m/s are 5 s; the ride takes 7 s more."""
    graph = roads(Road(ends=("a", "b")), lifts=(Lift(id="lift", stops=("b", "d"), ride_s=7),))
    ways = Ways(Scene(roads=graph))
    assert ways.least(CART, Position(0, 0), Position(10, 0, floor="upper")) == 10
    assert ways.least(CART, Position(0, 0), Position(10, 0, floor="upper"), 2.0) == 12


def test_where_something_may_stand_between_any_node_may_be_joined() -> None:
    """
    The nodes nearest to the ends are a and b, and no road joins them. With a keep-out somewhere, the nearest might not be seen: then
    the way by a alone, 3 m and sqrt(116) m, is the shortest, before that by b alone, sqrt(109) m and 4 m.
    """
    graph = roads(Road(ends=("b", "c")))
    shut = KeepOut(id="shut", area=Area(corners=((50, 50), (51, 50), (51, 51))))
    assert Ways(Scene(roads=graph)).least(CART, WEST, EAST) == math.inf
    assert Ways(Scene(roads=graph, keep_outs=(shut,))).least(CART, WEST, EAST) == pytest.approx(3 + math.sqrt(116))
