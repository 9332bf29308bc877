"""The travel model: which map counts, what is remembered, speeds and starts."""

import pytest

from missiontree.estimation.travel import Blocked, Leg, TravelModel, speed_of, start_of, travel_model, travel_time_s
from missiontree.mission.area import Area, KeepOut, Zone
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Robot, RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Frame, Scene
from missiontree.mission.ways import Lift, OccupancyGrid, Road, RoadGraph, RoadNode

CART = RobotType(id="cart", count=2, limits={"max_speed_mps": 2})
HERE, THERE = Position(0.5, 0.5), Position(3.5, 0.5)


def roads() -> RoadGraph:
    nodes = (RoadNode(id="A", position=HERE), RoadNode(id="B", position=THERE))
    return RoadGraph(nodes=nodes, roads=(Road(ends=("A", "B"), length_m=7),))


def test_roads_before_grid_before_straight_lines() -> None:
    assert TravelModel(Scene(roads=roads())).leg(CART, HERE, THERE) == Leg(7, 0, ("A", "B"))
    # one diagonal, two along the upper row, one down: the wall's corners are not cut
    grid = OccupancyGrid(rows=("....", "..#."), cell_m=1)
    assert TravelModel(Scene(grid=grid)).leg(CART, HERE, THERE) == Leg(3 + 2**0.5)
    assert TravelModel(Scene()).leg(CART, HERE, THERE) == Leg(3)


def test_who_is_there_already_travels_nowhere() -> None:
    for scene in (Scene(roads=roads()), Scene(grid=OccupancyGrid(rows=("#",), cell_m=1)), Scene()):
        assert TravelModel(scene).leg(CART, HERE, HERE) == Leg(0)


def test_frames_are_turned_into_the_map() -> None:
    scene = Scene(frames=(Frame(id="dock", x_m=10, y_m=0, yaw_deg=90),))
    # (3, 0) of the dock is (10, 3) of the map: 3-4-5 from (6, 0)
    found = TravelModel(scene).leg(CART, Position(6, 0), Position(3, 0, frame="dock"))
    assert isinstance(found, Leg)
    assert found.distance_m == pytest.approx(5)
    assert TravelModel(scene).leg(CART, Position(10, 0), Position(0, 0, frame="dock")) == Leg(0)


def test_closures_hold_for_their_types_only_and_reasons_name_the_type() -> None:
    wall = Area(corners=((3, 0), (4, 0), (4, 1), (3, 1)))
    model = TravelModel(Scene(keep_outs=(KeepOut(id="wall", area=wall, types=("cart", "tank")),)))
    assert model.leg(RobotType(id="drone", count=1), HERE, THERE) == Leg(3)
    for name in ("cart", "tank"):
        found = model.leg(RobotType(id=name, count=1), HERE, THERE)
        assert isinstance(found, Blocked)
        assert found.reason.robot == name
        assert found.reason.found == "keep-out wall"


def test_types_differ_by_the_zones_they_may_enter() -> None:
    ward = Zone(id="ward", area=Area(corners=((1, 0), (2, 0), (2, 1), (1, 1))))
    model = TravelModel(Scene(zones=(ward,)))
    assert model.leg(RobotType(id="cart", count=1), HERE, THERE) == Leg(3)
    round_it = model.leg(RobotType(id="cart", count=1, zones=()), HERE, THERE)
    assert isinstance(round_it, Leg)
    # from (0.5, 0.5) to the corner (1, 0), 1 along the edge, and from (2, 0) to (3.5, 0.5)
    assert round_it.distance_m == pytest.approx(0.5**0.5 + 1 + 2.5**0.5)


def test_legs_are_found_once_for_all_types_with_equal_ways(monkeypatch: pytest.MonkeyPatch) -> None:
    model = TravelModel(Scene(roads=roads()))
    first = model.leg(CART, HERE, THERE)
    monkeypatch.setattr("missiontree.estimation.roads.RoadWays.leg", lambda *given: Leg(99))
    assert model.leg(CART, HERE, THERE) == first
    assert model.leg(RobotType(id="tank", count=1, zones=()), HERE, THERE) == first
    assert model.leg(CART, THERE, HERE) == Leg(99)  # the way back was not known yet


def test_the_way_is_quickest_at_the_speed_asked_for() -> None:
    nodes = [RoadNode(id=f"n{x}{floor}", position=Position(x, 0, floor=floor)) for floor in ("g", "u") for x in (0, 10)]
    lifts = (Lift(id="near", stops=("n0g", "n0u"), ride_s=30), Lift(id="far", stops=("n10g", "n10u"), ride_s=5))
    graph = RoadGraph(nodes=tuple(nodes), roads=(Road(ends=("n0g", "n10g")), Road(ends=("n0u", "n10u"))), lifts=lifts)
    model = TravelModel(Scene(roads=graph))
    start, goal = Position(0, 0, floor="g"), Position(0, 0, floor="u")
    # 20 m and 5 s by the far lift against 30 s by the near one: 15 s at the cart's 2 m/s, 25 s at 1 m/s, 45 s at 0.5 m/s
    assert model.leg(CART, start, goal) == Leg(20, 5, ("n0g", "n10g", "n10u", "n0u"))
    assert model.leg(RobotType(id="snail", count=1), start, goal) == Leg(20, 5, ("n0g", "n10g", "n10u", "n0u"))
    assert model.leg(CART, start, goal, speed_mps=0.5) == Leg(0, 30, ("n0g", "n0u"))


def test_travel_time_is_distance_over_speed_and_the_ride() -> None:
    # 12 / 1.5 + 20
    assert travel_time_s(Leg(12, 20), 1.5) == 28


def test_the_slowest_sets_the_pace() -> None:
    child = Entity(id="child", kind="person", max_speed_mps=0.8)
    racer = Entity(id="racer", kind="person", max_speed_mps=9)
    crate = Entity(id="crate")
    assert speed_of(CART) == 2
    assert speed_of(CART, (racer, crate)) == 2
    assert speed_of(CART, (racer, child)) == 0.8
    assert speed_of(RobotType(id="still", count=1), (child,)) is None


def test_where_robots_start() -> None:
    scene = Scene(
        frames=(Frame(id="dock", x_m=10),),
        places=(Entity(id="bay", position=Position(1, 2)), Entity(id="nowhere")),
    )
    assert start_of(Robot(id="r", position=Position(3, 0, frame="dock")), scene) == Position(13, 0)
    assert start_of(Robot(id="r", place="bay"), scene) == Position(1, 2)
    assert start_of(Robot(id="r", place="nowhere"), scene) is None
    assert start_of(Robot(id="r"), scene) is None


def test_ways_are_kept_with_their_scene() -> None:
    scene = Scene(grid=OccupancyGrid(cell_m=1.0, rows=("....",)))
    assert travel_model(scene) is travel_model(scene)
    assert travel_model(Scene()) is not travel_model(Scene())
    assert scene == Scene(grid=scene.grid), "what is kept with a scene is no part of its value"
