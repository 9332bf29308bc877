"""How many runs are made, and what they come to."""

from __future__ import annotations

from missiontree.mission.control import Control, Progress
from missiontree.mission.fleet import Fleet
from missiontree.mission.scene import Scene
from missiontree.mission.terms import NO_TERMS
from missiontree.scheduling.greedy import read_problem
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.runs import Runs
from tests.scheduling.instances import Instance, Part, at, mission, robots, scene, work

ROBOT = robots("r", speed=1, position=at(0))
PLACES = scene(p=4, q=-3)


def two_places(deadline_s: float | None = None) -> Instance:
    """Work at 4 and at -3, 1 s each, for one robot at 0: 12 s at least, and 10 m of travel, so that further runs might find less."""
    made = mission([Part("p", "r", [work(1, at="p")]), Part("q", "r", [work(1, at="q")])])
    return made if deadline_s is None else made.timed(p_0=(0.0, deadline_s), q_0=(0.0, deadline_s))


def runs_of(made: Instance, heard: list[Progress], world: Scene = PLACES) -> Runs:
    problem = read_problem(made.tree, made.alternative, Fleet((ROBOT,)), world, NO_TERMS)
    assert isinstance(problem, Problem)
    return Runs(problem, made.alternative, Control(report=heard.append))


def test_runs_go_on_where_they_left_off() -> None:
    heard: list[Progress] = []
    runs = runs_of(two_places(), heard)
    runs.go(6)
    assert [news.done for news in heard] == [1, 2, 3, 4, 5, 6]
    runs.go(40)
    assert [news.done for news in heard] == list(range(1, 41))
    assert runs.best is not None
    assert runs.best.makespan == 12_000


def test_runs_that_find_nothing_better_end_early() -> None:
    heard: list[Progress] = []
    runs = runs_of(two_places(), heard)
    runs.go(40)
    best = runs.best
    again = runs_of(two_places(), heard := [])
    again.best = best
    again.go(40, in_vain=5)
    assert again.best is best
    assert len(heard) == 5


def test_without_a_draft_runs_end_only_if_they_are_to_end_anyway() -> None:
    """Both by 11 s: no bound denies it, and no order does it. Six runs are made if six are enough anyway, else as many as can be."""
    heard: list[Progress] = []
    runs = runs_of(two_places(11.0), heard)
    runs.go(6, anyway=True)
    assert runs.best is None
    assert len(heard) == 6
    assert {reason.rule for reason in runs.failures} == {"deadline_missed"}
    runs.go(40)
    assert runs.best is None
    assert len(heard) > 40
