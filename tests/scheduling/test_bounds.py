"""Lower bounds, derived by hand."""

from __future__ import annotations

from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.scene import Scene
from missiontree.scheduling.bounds import Bounds, lower_bounds
from missiontree.scheduling.chargers import NO_CHARGERS, Chargers, Station
from missiontree.scheduling.places import Places
from missiontree.scheduling.precedence import task_graph
from missiontree.scheduling.staffing import staffing_of
from missiontree.scheduling.trips import Trips
from tests.scheduling.instances import Instance, Part, at, mission, move, robots, scene, work


def bounds_of(
    made: Instance, *types: RobotType, world: Scene | None = None, chargers: Chargers = NO_CHARGERS
) -> Bounds:
    graph = task_graph(made.tree, made.alternative.choices)
    order = graph.order()
    assert order is not None
    fleet = Fleet(types)
    trips = Trips(fleet, world or Scene())
    places = Places(graph, order, trips)
    return lower_bounds(graph, order, staffing_of(graph), places, fleet, trips, chargers=chargers)


def test_the_longest_chain_bounds() -> None:
    """a (2 + 3) before c (4): 9 s; b (6) beside them does not matter."""
    made = mission(
        [Part("a", "x", [work(2), work(3)]), Part("b", "y", [work(6)]), Part("c", "z", [work(4)])], [("a", "c")]
    )
    bounds = bounds_of(made, robots("x"), robots("y"), robots("z"))
    assert (bounds.makespan, bounds.method) == (9_000, "critical_path")


def test_load_is_shared_between_heads_and_tails() -> None:
    """Three roles of 5 s for two robots, all after h (2 s) and before t (1 s): 2 + 15 / 2 + 1 = 10.5 s."""
    parts = [Part("h", "x", [work(2)]), *(Part(n, "r", [work(5)]) for n in "abc"), Part("t", "y", [work(1)])]
    links = [("h", n) for n in "abc"] + [(n, "t") for n in "abc"]
    bounds = bounds_of(mission(parts, links), robots("x"), robots("r", 2), robots("y"))
    assert (bounds.makespan, bounds.method) == (10_500, "load")


def test_travel_counts_where_both_ends_are_certain() -> None:
    """From 0 to p at 4 (2 s at 2 m/s), 1 s of work, on to q at 10 (3 s), 1 s: 7 s."""
    made = mission([Part("a", "r", [work(1, at="p"), work(1, at="q")])])
    assert bounds_of(made, robots("r", speed=2, position=at(0)), world=scene(p=4, q=10)).makespan == 7_000
    # nobody knows where the robot starts: the approach counts 0
    assert bounds_of(made, robots("r", speed=2), world=scene(p=4, q=10)).makespan == 5_000


def test_an_approach_counts_from_the_nearest_robot() -> None:
    """near (1 m away) could go: 1 + 1 s, whatever far would need."""
    made = mission([Part("a", "r", [work(1, at="p")])])
    kind = RobotType(
        id="r",
        capabilities={"work": 1.0},
        limits={"max_speed_mps": 1},
        robots=(_robot("far", 50), _robot("near", 9)),
    )
    assert bounds_of(made, kind, world=scene(p=10)).makespan == 2_000


def test_a_place_that_may_have_moved_counts_the_least_of_all_it_may_be() -> None:
    """box is at 9 or, if m comes first, at 3: without an order between m and a, the approach of a counts 3 s only."""
    parts = [Part("m", "x", [move("q", "box", nominal_s=0)]), Part("a", "r", [work(1, at="box")])]
    kinds = (robots("x"), robots("r", speed=1, position=at(0)))
    assert bounds_of(mission(parts), *kinds, world=scene(box=9, q=3)).makespan == 4_000
    assert bounds_of(mission(parts, [("a", "m")]), *kinds, world=scene(box=9, q=3)).makespan == 10_000


def test_the_load_of_one_robot_counts_the_way_into_each_place() -> None:
    """
    From 0, p at 10 and q at -10 with 1 s of work each, 1 m/s. Nobody starts at p or q, and each is visited once: p is entered from 0
    or from q, by 10 s at least, and so is q. Load: 11 + 11 = 22 s; it ends 1 s after 10 + 1 + 20, at 32 s.
    """
    made = mission([Part("a", "r", [work(1, at="p")]), Part("b", "r", [work(1, at="q")])])
    bounds = bounds_of(made, robots("r", speed=1, position=at(0)), world=scene(p=10, q=-10))
    assert (bounds.makespan, bounds.method) == (22_000, "load")
    # a second role at p may find the robot there: then the ways to p and to q are certain, 10 m each, and 3 s of work
    made = mission([Part(name, "r", [work(1, at=place)]) for name, place in (("a", "p"), ("c", "p"), ("b", "q"))])
    assert bounds_of(made, robots("r", speed=1, position=at(0)), world=scene(p=10, q=-10)).makespan == 23_000


def test_a_move_into_a_role_is_no_longer_than_the_joint_move_that_it_is() -> None:
    """a goes 5 m to p, together with b, which comes from q, 5 m off as well: the way into a is that move, and not added to it."""
    made = mission(
        [Part("a", "x", [move("p", sync=0)]), Part("b", "y", [work(1, at="q"), move("p", sync=0)])],
    )
    kinds = robots("x", speed=1, position=at(0)), robots("y", speed=1, position=at(0))
    # b: 10 m to q, 1 s, 5 m back to p = 16 s; a's own way of 5 s lies within the last 5 s
    assert bounds_of(made, *kinds, world=scene(p=5, q=10)).makespan == 16_000


def test_the_way_of_a_role_that_begins_anywhere_counts_from_where_its_robot_can_be() -> None:
    """
    b waits for a (5 s), takes 2 s wherever its robot is, and then works at p, 10 m off, 1 s: nothing else takes its robot anywhere, so
    5 + 2 + 10 + 1 = 18 s. If another role of the type ends at p, or a charger stands there, b's robot may be there when b begins: then
    only the way from the start counts, 2 s of standing still, 10 + 1 = 13 s; with the 1 s of the other role, 14 s.
    """
    a, b = Part("a", "x", [work(5)]), Part("b", "r", [work(2), work(1, at="p")])
    kinds, world = (robots("x"), robots("r", speed=1, position=at(0))), scene(p=10)
    bounds = bounds_of(mission([a, b], [("a", "b")]), *kinds, world=world)
    assert (bounds.makespan, bounds.method) == (18_000, "critical_path")
    c = Part("c", "r", [work(1, at="p")])
    assert bounds_of(mission([a, b, c], [("a", "b")]), *kinds, world=world).makespan == 14_000
    station = Chargers({"r": (Station("dock", at(10), "energy_j", 1.0, 1),)})
    assert bounds_of(mission([a, b], [("a", "b")]), *kinds, world=world, chargers=station).makespan == 13_000


def test_a_move_that_begins_a_role_takes_the_way_from_where_its_robot_can_be() -> None:
    """b waits for a (5 s) and goes 10 m to q: 15 s. Where c, of the same type, ends at q, b's robot may be there: 10 s, c's own way."""
    a, b = Part("a", "x", [work(5)]), Part("b", "r", [move("q")])
    kinds, world = (robots("x"), robots("r", speed=1, position=at(0))), scene(q=10)
    assert bounds_of(mission([a, b], [("a", "b")]), *kinds, world=world).makespan == 15_000
    c = Part("c", "r", [move("q")])
    assert bounds_of(mission([a, b, c], [("a", "b")]), *kinds, world=world).makespan == 10_000


def _robot(name: str, x_m: float) -> Robot:
    return Robot(id=name, position=at(x_m))
