"""Ways along the road graph."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.estimation.access import access_of
from missiontree.estimation.leg import Blocked, Leg
from missiontree.estimation.roads import RoadWays
from missiontree.mission.area import Area, KeepOut, Zone
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.ways import Lift, Road, RoadGraph, RoadNode

CART = RobotType(id="cart", count=1, zones=("hall",))
A, B, C, D = (
    RoadNode(id="A", position=Position(0, 0)),
    RoadNode(id="B", position=Position(10, 0)),
    RoadNode(id="C", position=Position(10, 10)),
    RoadNode(id="D", position=Position(0, 10)),
)
RING = (Road(ends=("A", "B")), Road(ends=("B", "C")), Road(ends=("C", "D")), Road(ends=("D", "A")))


def ways(
    *roads: Road,
    nodes: tuple[RoadNode, ...] = (A, B, C, D),
    lifts: tuple[Lift, ...] = (),
    keep_outs: tuple[KeepOut, ...] = (),
    zones: tuple[Zone, ...] = (),
    places: tuple[Entity, ...] = (),
) -> RoadWays:
    graph = RoadGraph(nodes=nodes, roads=roads, lifts=lifts)
    scene = Scene(roads=graph, keep_outs=keep_outs, zones=zones, places=places)
    return RoadWays(graph, scene.road_points, access_of(CART, scene))


def leg(model: RoadWays, origin: Position, destination: Position, speed_mps: float = 1.0) -> Leg:
    found = model.leg(origin, destination, speed_mps)
    assert isinstance(found, Leg), found
    return found


def why(model: RoadWays, origin: Position, destination: Position) -> str:
    found = model.leg(origin, destination)
    assert isinstance(found, Blocked)
    assert found.reason.rule == "unreachable"
    return found.reason.message


def test_points_join_the_nearest_node_straight() -> None:
    # (0, -2) to A is 2, A to B is 10, B to (13, 4) is a 3-4-5 triangle: 5
    assert leg(ways(*RING), Position(0, -2), Position(13, 4)) == Leg(17, 0, ("A", "B"))


def test_between_nodes_nothing_is_added() -> None:
    assert leg(ways(*RING), A.position, C.position) == Leg(20, 0, ("A", "B", "C"))


def test_two_points_at_one_node_meet_there() -> None:
    # 2 to A and 3 from A, although the points are but 1 m apart
    assert leg(ways(*RING), Position(-2, 0), Position(-3, 0)) == Leg(5, 0, ("A",))


def test_of_nodes_equally_near_the_first_listed_counts() -> None:
    # (5, 0) is 5 m from A and from B
    assert leg(ways(*RING), Position(5, 0), B.position) == Leg(15, 0, ("A", "B"))
    assert leg(ways(*RING, nodes=(B, A, C, D)), Position(5, 0), B.position) == Leg(5, 0, ("B",))


def test_a_given_length_overrides_the_straight_distance() -> None:
    winding = Road(ends=("A", "B"), length_m=31)
    # by the road itself 31, the other way round the ring 30
    assert leg(ways(winding, *RING[1:]), A.position, B.position) == Leg(30, 0, ("A", "D", "C", "B"))


def test_the_shorter_of_parallel_roads_is_taken() -> None:
    assert leg(ways(Road(ends=("A", "B"), length_m=12), *RING), A.position, B.position).distance_m == 10


def test_one_way_roads_hold_in_one_direction() -> None:
    model = ways(Road(ends=("A", "B"), one_way=True), *RING[1:])
    assert leg(model, A.position, B.position).distance_m == 10
    assert leg(model, B.position, A.position).distance_m == 30


def test_places_named_by_roads_are_nodes_and_other_places_are_not() -> None:
    shed = Entity(id="shed", position=Position(0, 3))
    yard = Entity(id="yard", position=Position(0, 5))
    model = ways(*RING, Road(ends=("A", "shed")), places=(shed, yard))
    # the yard joins the shed (2 m), not itself
    assert leg(model, Position(0, 5), A.position) == Leg(5, 0, ("shed", "A"))


def test_a_lift_takes_its_ride_and_no_metres() -> None:
    up = RoadNode(id="U", position=Position(10, 0, floor="first"))
    model = ways(*RING, nodes=(A, B, C, D, up), lifts=(Lift(id="lift", stops=("B", "U"), ride_s=20),))
    # 10 m to B, the ride, 4 m on the first floor
    assert leg(model, A.position, Position(10, 4, floor="first")) == Leg(14, 20, ("A", "B", "U"))


def test_the_quickest_way_depends_on_speed_where_lifts_are() -> None:
    nodes = (
        A,
        B,
        RoadNode(id="A1", position=Position(0, 0, floor="first")),
        RoadNode(id="B1", position=Position(10, 0, floor="first")),
    )
    lifts = (Lift(id="slow", stops=("A", "A1"), ride_s=30), Lift(id="quick", stops=("B", "B1"), ride_s=5))
    model = ways(Road(ends=("A", "B")), Road(ends=("A1", "B1")), nodes=nodes, lifts=lifts)
    top = nodes[2].position
    # at 1 m/s: 30 by the slow lift, 10 + 5 + 10 = 25 by the quick one; at 0.5 m/s: 30 against 20 + 5 + 20 = 45
    assert leg(model, A.position, top, 1.0) == Leg(20, 5, ("A", "B", "B1", "A1"))
    assert leg(model, A.position, top, 0.5) == Leg(0, 30, ("A", "A1"))


@pytest.mark.parametrize(
    ("road", "said"),
    [
        (Road(ends=("A", "B"), blocked=True), "the road A - B is blocked"),
        (Road(ends=("A", "B"), types=("drone",)), "the road A - B is closed to this robot type"),
        (Road(ends=("A", "B"), zone="ward"), "the road A - B runs through zone ward, closed to this robot type"),
        (Road(ends=("B", "A"), one_way=True), "the road B - A is one-way"),
    ],
)
def test_what_cuts_off_is_named(road: Road, said: str) -> None:
    zones = (Zone(id="ward"), Zone(id="hall"))
    model = ways(road, Road(ends=("B", "C")), zones=zones)
    assert why(model, A.position, C.position) == f"No way from (0, 0) to (10, 10): {said}."


def test_an_allowed_zone_is_open() -> None:
    model = ways(Road(ends=("A", "B"), zone="hall"), zones=(Zone(id="ward"), Zone(id="hall")))
    assert leg(model, A.position, B.position).distance_m == 10


def test_keep_outs_close_the_roads_through_them_on_their_floor() -> None:
    middle = Area(corners=((4, -1), (6, -1), (6, 1), (4, 1)))
    assert leg(ways(*RING, keep_outs=(KeepOut(id="pit", area=middle),)), A.position, B.position).distance_m == 30
    above = Area(corners=middle.corners, floor="first")
    assert leg(ways(*RING, keep_outs=(KeepOut(id="pit", area=above),)), A.position, B.position).distance_m == 10
    beside = Area(corners=((4, 0), (6, 0), (6, 1), (4, 1)))  # the road runs along its edge
    assert leg(ways(*RING, keep_outs=(KeepOut(id="pit", area=beside),)), A.position, B.position).distance_m == 10
    only = ways(Road(ends=("A", "B")), keep_outs=(KeepOut(id="pit", area=middle),))
    assert (
        why(only, A.position, B.position)
        == "No way from (0, 0) to (10, 0): the road A - B passes through keep-out pit."
    )


def test_forbidden_zone_areas_close_roads_as_well() -> None:
    middle = Area(corners=((4, -1), (6, -1), (6, 1), (4, 1)))
    model = ways(*RING, zones=(Zone(id="ward", area=middle), Zone(id="hall")))
    assert leg(model, A.position, B.position).distance_m == 30


def test_a_point_joins_the_nearest_node_that_it_sees() -> None:
    wall = Area(corners=((-1, 1), (1, 1), (1, 2), (-1, 2)))
    model = ways(*RING, keep_outs=(KeepOut(id="wall", area=wall),))
    # (0, 4) is 4 m from A, behind the wall, and 6 m from D
    assert leg(model, Position(0, 4), D.position) == Leg(6, 0, ("D",))


def test_points_in_closed_areas_and_behind_them_are_blocked() -> None:
    pit = (KeepOut(id="pit", area=Area(corners=((4, 4), (6, 4), (6, 6), (4, 6)))),)
    assert why(ways(*RING, keep_outs=pit), Position(5, 5), A.position).startswith("(5, 5) is inside keep-out pit")
    only = ways(nodes=(A,), keep_outs=pit)
    assert why(only, A.position, Position(8, 8)) == "(8, 8) is cut off from every road node by keep-out pit."


def test_floors_without_nodes_or_without_lifts_are_said_so() -> None:
    up = RoadNode(id="U", position=Position(10, 0, floor="first"))
    model = ways(*RING, nodes=(A, B, C, D, up))
    assert why(model, A.position, up.position) == (
        "No way from (0, 0) to (10, 0) on floor first: nothing joins floor ground and floor first."
    )
    assert "floor second has no road node" in why(model, A.position, Position(0, 0, floor="second"))
    broken = ways(*RING, nodes=(A, B, C, D, up), lifts=(Lift(id="lift", stops=("B", "U"), ride_s=20, blocked=True),))
    assert why(broken, A.position, up.position).endswith("the lift lift is out of order.")


def test_nodes_that_no_road_joins() -> None:
    assert why(ways(), A.position, B.position) == "No way from (0, 0) to (10, 0): no roads join the nodes A and B."


numbers = st.integers(0, 7)
drawn_roads = st.lists(
    st.builds(
        lambda start, end, length, one_way, blocked: Road(
            ends=(f"n{start}", f"n{end}"), length_m=length, one_way=one_way, blocked=blocked
        ),
        numbers,
        numbers,
        st.none() | st.integers(20, 40),
        st.booleans(),
        st.booleans(),
    ),
    max_size=16,
)
NODES = tuple(RoadNode(id=f"n{i}", position=Position(i % 3 * 5, i // 3 * 5)) for i in range(8))
off_road = st.builds(Position, st.integers(-4, 14), st.integers(-4, 14))


@given(drawn_roads, off_road, off_road)
def test_distances_agree_with_bellman_ford(roads: list[Road], origin: Position, destination: Position) -> None:
    spots = [(node.position.x_m, node.position.y_m) for node in NODES]
    ends = [(position.x_m, position.y_m) for position in (origin, destination)]
    first, last = (min(range(8), key=lambda i: (math.dist(end, spots[i]), i)) for end in ends)
    best = {first: 0.0}
    for _ in range(8):
        for road in roads:
            start, end = (int(name[1:]) for name in road.ends)
            length = road.length_m if road.length_m is not None else math.dist(spots[start], spots[end])
            for here, there in [(start, end)] + [(end, start)] * (not road.one_way):
                if not road.blocked and here in best:
                    best[there] = min(best.get(there, math.inf), best[here] + length)
    found = ways(*roads, nodes=NODES).leg(origin, destination)
    if last not in best:
        assert isinstance(found, Blocked)
    else:
        assert isinstance(found, Leg)
        total = math.dist(ends[0], spots[first]) + best[last] + math.dist(ends[1], spots[last])
        assert found.distance_m == pytest.approx(total)
        assert (found.via[0], found.via[-1]) == (f"n{first}", f"n{last}")


@given(drawn_roads, off_road, off_road, off_road)
def test_two_way_roads_are_symmetric_no_shorter_than_euclid_and_keep_the_triangle_inequality(
    roads: list[Road], a: Position, b: Position, c: Position
) -> None:
    both_ways = [Road(ends=road.ends, length_m=road.length_m, blocked=road.blocked) for road in roads]
    model = ways(*both_ways, nodes=NODES)
    there, back, on, whole = (model.leg(*ends) for ends in ((a, b), (b, a), (b, c), (a, c)))
    if isinstance(there, Leg):
        assert isinstance(back, Leg)
        assert there.distance_m == pytest.approx(back.distance_m)
        assert there.distance_m >= math.dist((a.x_m, a.y_m), (b.x_m, b.y_m)) - 1e-9
        if isinstance(on, Leg):
            assert isinstance(whole, Leg)
            assert whole.distance_m <= there.distance_m + on.distance_m + 1e-6
    else:
        assert isinstance(back, Blocked)
