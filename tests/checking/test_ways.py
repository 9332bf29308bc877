"""The checker's own distances, against distances worked out by hand."""

from __future__ import annotations

import math
import random

import pytest

from missiontree.checking.ways import Ways
from missiontree.estimation.leg import Leg
from missiontree.estimation.travel import TravelModel, travel_time_s
from missiontree.mission.area import Area, KeepOut, Zone
from missiontree.mission.fleet import RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.ways import Lift, OccupancyGrid, Road, RoadGraph, RoadNode
from tests.checking.missions import point, random_scene

ROBOT = RobotType(id="robot", count=1)
POOL = KeepOut(id="pool", area=Area(corners=((15, -5), (25, -5), (25, 5), (15, 5))))


def metres(
    scene: Scene, origin: tuple[float, float], destination: tuple[float, float], robot: RobotType = ROBOT
) -> float:
    return Ways(scene).shortest_m(robot, Position(*origin), Position(*destination))


def test_open_ground_is_crossed_straight() -> None:
    """A 3-4-5 triangle."""
    assert metres(Scene(), (0, 0), (3, 4)) == 5


def test_no_way_leads_to_another_floor_without_a_lift() -> None:
    assert math.isinf(Ways(Scene()).shortest_m(ROBOT, Position(0, 0), Position(0, 0, "upper")))


def test_a_keep_out_is_gone_round_by_its_corners() -> None:
    """From (10, 0) to (30, 0) by (15, 5) and (25, 5): two slants of sqrt(50) and an edge of 10."""
    assert metres(Scene(keep_outs=(POOL,)), (10, 0), (30, 0)) == pytest.approx(2 * math.sqrt(50) + 10)


def test_the_edge_of_a_keep_out_may_be_touched() -> None:
    """Along the upper edge, 20 m."""
    assert metres(Scene(keep_outs=(POOL,)), (10, 5), (30, 5)) == 20


def test_nobody_gets_out_of_a_keep_out() -> None:
    assert math.isinf(metres(Scene(keep_outs=(POOL,)), (20, 0), (30, 0)))


def test_nobody_slips_between_two_keep_outs_that_touch() -> None:
    """From (0, 5) to (10, 5) along the shared edge y = 5 there is no way; round (2, 0) and (8, 0) it is 2 * sqrt(29) + 6."""
    low = KeepOut(id="low", area=Area(corners=((2, 0), (8, 0), (8, 5), (2, 5))))
    high = KeepOut(id="high", area=Area(corners=((2, 5), (8, 5), (8, 20), (2, 20))))
    assert metres(Scene(keep_outs=(low, high)), (0, 5), (10, 5)) == pytest.approx(2 * math.sqrt(29) + 6)


def test_a_keep_out_for_others_is_open() -> None:
    keep_out = KeepOut(id="pool", area=POOL.area, types=("truck",))
    assert metres(Scene(keep_outs=(keep_out,)), (10, 0), (30, 0)) == 20


def test_a_zone_with_an_area_is_closed_to_types_that_may_not_enter_it() -> None:
    scene = Scene(zones=(Zone(id="pool", area=POOL.area), Zone(id="deck")))
    deckhand = RobotType(id="deckhand", count=1, zones=("deck",))
    assert metres(scene, (10, 0), (30, 0)) == 20
    assert metres(scene, (10, 0), (30, 0), deckhand) == pytest.approx(2 * math.sqrt(50) + 10)


def cross(*roads: Road, lifts: tuple[Lift, ...] = ()) -> Scene:
    nodes = (
        ("west", 0, 0, "ground"),
        ("middle", 10, 0, "ground"),
        ("north", 10, 10, "ground"),
        ("top", 10, 0, "upper"),
    )
    return Scene(
        roads=RoadGraph(
            nodes=tuple(RoadNode(id=name, position=Position(x_m, y_m, floor)) for name, x_m, y_m, floor in nodes),
            roads=roads,
            lifts=lifts,
        )
    )


WEST, NORTH = Road(ends=("west", "middle")), Road(ends=("middle", "north"), length_m=12)


def test_points_off_the_road_join_their_nearest_nodes() -> None:
    """1 m to west, 10 m to middle, 12 m (stated) to north, 2 m to the goal."""
    assert metres(cross(WEST, NORTH), (0, 1), (12, 10)) == 25


def test_one_way_roads_lead_one_way() -> None:
    scene = cross(Road(ends=("west", "middle"), one_way=True))
    assert metres(scene, (0, 0), (10, 0)) == 10
    assert math.isinf(metres(scene, (10, 0), (0, 0)))


@pytest.mark.parametrize(
    "closed",
    [
        Road(ends=("west", "middle"), blocked=True),
        Road(ends=("west", "middle"), types=("truck",)),
        Road(ends=("west", "middle"), zone="wing"),
    ],
)
def test_closed_roads_are_no_way(closed: Road) -> None:
    robot = RobotType(id="robot", count=1, zones=())
    assert math.isinf(metres(cross(closed), (0, 0), (10, 0), robot))


def test_a_road_through_a_keep_out_is_no_way() -> None:
    scene = Scene(
        keep_outs=(KeepOut(id="pit", area=Area(corners=((4, -1), (6, -1), (6, 1), (4, 1)))),), roads=cross(WEST).roads
    )
    assert math.isinf(metres(scene, (0, 0), (10, 0)))


def test_a_lift_takes_time_and_no_metres() -> None:
    """10 m at 2 m/s and a ride of 7 s: 12 s."""
    ways = Ways(cross(WEST, lifts=(Lift(id="lift", stops=("middle", "top"), ride_s=7),)))
    start, goal = Position(0, 0), Position(10, 0, "upper")
    assert ways.shortest_m(ROBOT, start, goal) == 10
    assert ways.quickest_s(ROBOT, start, goal, 2.0) == 12


def grid(*rows: str) -> Scene:
    return Scene(grid=OccupancyGrid(rows=rows, cell_m=2.0))


def test_a_grid_is_crossed_from_centre_to_centre() -> None:
    """Two diagonal steps of 2 * sqrt(2) m between the centres (1, 1) and (5, 5)."""
    assert metres(grid("...", "...", "..."), (1, 1), (5, 5)) == pytest.approx(4 * math.sqrt(2))


def test_no_corner_is_cut() -> None:
    """The first row has the largest y: with (3, 3) closed the way from (1, 1) to (5, 5) is 4 + 4 m along two sides."""
    assert metres(grid("...", ".#.", "..."), (1, 1), (5, 5)) == 8


def test_walls_are_no_way() -> None:
    assert math.isinf(metres(grid("#.", ".#"), (1, 1), (3, 3)))
    assert math.isinf(metres(grid("#.", ".."), (1, 3), (3, 1)))


def test_points_of_one_cell_are_joined_straight_and_others_by_the_centres() -> None:
    """0.5 m within the cell; else 0.5 m to the centre, 2 m, 0.5 m from the centre."""
    assert metres(grid(".."), (0.5, 1), (1, 1)) == 0.5
    assert metres(grid(".."), (0.5, 1), (3.5, 1)) == 3


@pytest.mark.parametrize("batch", range(4))
def test_the_travel_model_finds_no_way_shorter_than_the_checker_does(batch: int) -> None:
    """Two programs that share no code, on random maps: the travel model's legs are never understated."""
    compared = 0
    for seed in range(batch * 40, batch * 40 + 40):
        rng = random.Random(seed)  # noqa: S311 - variation, not secrecy
        scene = random_scene(rng) or Scene()
        model, ways = TravelModel(scene), Ways(scene)
        robot = RobotType(id="t0", count=1, limits={"max_speed_mps": 2.0})
        for _ in range(8):
            origin, goal = point(rng), point(rng)
            leg = model.leg(robot, origin, goal)
            if isinstance(leg, Leg):
                compared += 1
                assert leg.distance_m >= ways.shortest_m(robot, origin, goal) - 1e-6, f"seed {seed}: {origin} to {goal}"
                assert travel_time_s(leg, 2.0) >= ways.quickest_s(robot, origin, goal, 2.0) - 1e-6, f"seed {seed}"
                if scene.roads is None:  # on roads the checker may join any of several nodes that are equally near
                    assert leg.distance_m == pytest.approx(ways.shortest_m(robot, origin, goal)), f"seed {seed}"
            elif scene.roads is None:
                assert math.isinf(ways.shortest_m(robot, origin, goal)), f"seed {seed}: {origin} to {goal}"
    assert compared > 50
