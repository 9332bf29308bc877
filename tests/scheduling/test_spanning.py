"""The bound by spanning trees against numbers derived by hand; robots go 1 m/s."""

from __future__ import annotations

import pytest

from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.scene import Scene
from missiontree.mission.terms import NO_TERMS, Terms
from missiontree.scheduling.greedy import read_problem
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.spanning import spanning_bound
from tests.scheduling.instances import Instance, Part, at, mission, move, robots, scene, schedule, work


def stops(*at_m: float) -> tuple[Instance, Scene]:
    """A second of work at each of some places on a line."""
    made = mission([Part(f"p{n}", "r", [work(1, at=f"x{n}")]) for n in range(len(at_m))])
    return made, scene(None, **{f"x{n}": where for n, where in enumerate(at_m)})


def bound(made: Instance, world: Scene, kind: RobotType, terms: Terms = NO_TERMS, many: int = 48) -> int:
    """Ticks."""
    problem = read_problem(made.tree, made.alternative, Fleet((kind,)), world, terms)
    assert isinstance(problem, Problem)
    bounds = problem.bounds
    given = (problem.graph, problem.staffing, bounds.duration, bounds.lag, bounds.tails, problem.places)
    return spanning_bound(*given, problem.fleet, problem.trips, problem.chargers, many)


def test_one_robot_goes_all_the_way_and_works_everywhere() -> None:
    """0 to 10, 11 and 20: a tree of 20 m, and 3 s. Single ways into the places tell of 1 + 1 + 9 m."""
    made, world = stops(10, 11, 20)
    assert bound(made, world, robots("r", speed=1, position=at(0))) == 23_000


def test_robots_share_it() -> None:
    """0 to 20 and to -20, each with a place half-way: 40 m and 4 s for two robots."""
    made, world = stops(10, 20, -10, -20)
    assert bound(made, world, robots("r", 2, speed=1, position=at(0))) == 22_000


def test_a_schedule_as_short_is_proven_optimal() -> None:
    """Two pairs of places: 21 m and 4 s. Single ways tell of 1 m each but for the first."""
    made, world = stops(10, 11, 20, 21)
    found = schedule(made, robots("r", speed=1, position=at(0)), world=world)
    assert (found.makespan_s, found.status, found.certificate.method) == (25, "optimal", "spanning_tree")


def test_no_more_of_them_than_may_be_in_use() -> None:
    made, world = stops(10, 20, -10, -20)
    assert bound(made, world, robots("r", 2, speed=1, position=at(0), max_in_use=1)) == 44_000


def test_they_start_when_they_come_and_the_nearest_way_home_follows() -> None:
    """There from 5 s on, 20 m and 3 s, and at least 10 m home from wherever the last of it is."""
    made, world = stops(10, 11, 20)
    kind = robots("r", speed=1, position=at(0), available_from_s=5)
    assert bound(made, world, kind, Terms(return_home=True)) == 38_000


def test_a_move_that_begins_a_role_is_the_way_there() -> None:
    """To 10 with nothing in hand, and 2 s of work there: 12 s, not 22 s."""
    made = mission([Part("p", "r", [move("x0"), work(2, at="x0")])])
    assert bound(made, scene(x0=10), robots("r", speed=1, position=at(0))) == 12_000


def test_what_is_done_anywhere_is_work_without_a_way() -> None:
    made = mission([Part("p", "r", [work(1, at="x0")]), Part("q", "r", [work(7)])])
    assert bound(made, scene(x0=10), robots("r", speed=1, position=at(0))) == 18_000


@pytest.mark.parametrize("kind", [robots("r", speed=1), robots("r", position=at(0))])
def test_of_unknown_starts_and_speeds_nothing_is_told(kind: RobotType) -> None:
    made, world = stops(10, 11, 20)
    assert bound(made, world, kind) == 0


def test_of_more_places_than_there_is_time_for_nothing_is_told() -> None:
    """Three places and a start are four."""
    made, world = stops(10, 11, 20)
    kind = robots("r", speed=1, position=at(0))
    assert [bound(made, world, kind, many=many) for many in (3, 4)] == [0, 23_000]
