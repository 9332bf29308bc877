"""Lower bounds, derived by hand."""

from __future__ import annotations

from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.scene import Scene
from missiontree.scheduling.bounds import Bounds, lower_bounds
from missiontree.scheduling.places import Places
from missiontree.scheduling.precedence import task_graph
from missiontree.scheduling.staffing import staffing_of
from missiontree.scheduling.trips import Trips
from tests.scheduling.instances import Instance, Part, at, mission, move, robots, scene, work


def bounds_of(made: Instance, *types: RobotType, world: Scene | None = None) -> Bounds:
    graph = task_graph(made.tree, made.alternative.choices)
    order = graph.order()
    assert order is not None
    fleet = Fleet(types)
    trips = Trips(fleet, world or Scene())
    return lower_bounds(graph, order, staffing_of(graph), Places(graph, order, trips), fleet, trips)


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


def _robot(name: str, x_m: float) -> Robot:
    return Robot(id=name, position=at(x_m))
