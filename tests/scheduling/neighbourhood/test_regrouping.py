"""Large neighbourhood search: its longest paths are those of the schedule, what it finds is a schedule, and it never loses what it had."""

from __future__ import annotations

from pathlib import Path
from random import Random

import pytest

from benchmarks.random_missions import write_mission
from benchmarks.schedule_cases import FEATURES, ScheduleCase, random_schedule_case
from benchmarks.schedule_oracle import TooMuchError, least_makespan
from missiontree.briefing import request_from
from missiontree.checking import check
from missiontree.mission.control import Control, Progress
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet
from missiontree.mission.scene import Scene
from missiontree.mission.terms import Terms
from missiontree.planner import plan_request
from missiontree.scheduling.course import Course, along
from missiontree.scheduling.greedy import read_problem
from missiontree.scheduling.neighbourhood import search, shortly
from missiontree.scheduling.neighbourhood.network import Network
from missiontree.scheduling.neighbourhood.stops import stops_of
from missiontree.scheduling.problem import Draft, Problem
from missiontree.scheduling.replay import replay
from missiontree.scheduling.runs import Runs
from tests.scheduling.instances import Part, at, mission, robots, work

PLAIN = frozenset({"travel", "joint", "links", "apart", "idle", "times", "comings", "home"})
"""Features of which the longest paths know all there is."""


def drafted(
    seed: int, features: frozenset[str] = frozenset(FEATURES) | {"travel"}
) -> tuple[ScheduleCase, Problem, Draft] | None:
    case = random_schedule_case(Random(f"neighbourhood {seed}"))  # noqa: S311 - luck for tests, not for secrets
    if not case.features <= features:
        return None
    problem = read_problem(case.tree, case.alternative, case.fleet, case.scene, case.terms)
    if not isinstance(problem, Problem):
        return None
    runs = Runs(problem, case.alternative, Control(), most=3)
    runs.go(3)
    return None if runs.best is None else (case, problem, runs.best)


def tours_of(problem: Problem, draft: Draft) -> dict[str, list[int]]:
    start = {one.leaf: (one.start, one.end) for one in draft.done}
    roles = problem.graph.roles
    tours: dict[str, list[int]] = {robot.id: [] for kind in problem.fleet.types for robot in kind.members}
    for role in sorted(roles, key=lambda role: (start[roles[role][0]][0], start[roles[role][-1]][1], role)):
        tours[draft.robot_of[role]].append(role)
    return tours


def test_longest_paths_are_as_long_as_the_schedule_that_is_played_through() -> None:
    """Played through with all rules, the same tours end when the longest path does, where nothing but order, ways and times counts."""
    compared = 0
    for seed in range(2500):
        found = drafted(seed, PLAIN)
        if found is None:
            continue
        _, problem, draft = found
        stops = stops_of(problem)
        if stops is None:
            continue
        tours = tours_of(problem, draft)
        paths = Network(problem, stops).measured(tours)
        played = replay(problem, Course({role: name for name, roles in tours.items() for role in roles}, tours))
        if played is None:
            continue
        assert paths is not None
        assert paths.makespan == played.makespan
        compared += 1
    assert compared >= 20


def test_no_rule_is_broken_and_nothing_below_the_least_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    """Small missions with every rule: what is found is never longer than what was there, nor shorter than the least there is."""
    monkeypatch.setattr(search, "FEWEST_ROLES", 2)
    better = 0
    for seed in range(250):
        found = drafted(seed)
        if found is None:
            continue
        case, problem, draft = found
        how = search.Regrouping(seed, 15, patient=seed % 2 == 0)
        best = search.regrouped(problem, draft, how, lambda: False, lambda one: None)
        assert best.makespan <= draft.makespan
        if best.makespan < draft.makespan:
            better += 1
            try:
                least = least_makespan(case)
            except TooMuchError:
                continue
            assert least is not None
            assert best.makespan >= least
    assert better >= 1


@pytest.mark.parametrize("home", [False, True])
def test_tours_are_mended_in_the_middle_and_back_home(home: bool) -> None:
    """
    Twelve stops of a second each at 1 to 12 m, one robot at 0, 1 m/s: past all of them takes 24 s, and 36 s with the way back.

    From a tour that goes to and fro, with every second stop on the far side of the one before.
    """
    made = mission([Part(f"p{n}", "r", [work(1, at=f"x{n}")]) for n in range(12)])
    world = Scene(entities=tuple(Entity(id=f"x{n}", kind="place", position=at(n + 1)) for n in range(12)))
    kind = robots("r", speed=1, position=at(0))
    terms = Terms(return_home=home)
    problem = read_problem(made.tree, made.alternative, Fleet((kind,)), world, terms)
    assert isinstance(problem, Problem)
    roles = [*problem.graph.roles]
    first = replay(
        problem, along({"r-1": [role for pair in zip(roles[:6], roles[::-1], strict=False) for role in pair]})
    )
    assert first is not None
    assert first.makespan > 60_000
    best = search.regrouped(problem, first, search.Regrouping(0, 200), lambda: False, lambda one: None)
    assert best.makespan == (36_000 if home else 24_000)


@pytest.mark.parametrize("name", ["greedy", "auto"])
def test_a_large_mission_gets_shorter_and_passes_the_checker(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, name: str
) -> None:
    """30 goals: large neighbourhoods are searched, and each step on the way down is told of."""
    file = write_mission(tmp_path, 30, 9, 4)
    with monkeypatch.context() as without:
        without.setattr(shortly, "ROUNDS", 0)
        plain = plan_request(request_from(file, k=1), Control())
    news: list[Progress] = []
    made = plan_request(request_from(file, k=1, scheduler=name), Control(clock=lambda: 0.0, report=news.append))
    assert made.schedules[0].makespan_s < plain.schedules[0].makespan_s
    assert check(made) == ()
    best = [one.best for one in news if one.stage == "scheduling" and one.best is not None]
    assert best[-1] == made.schedules[0].makespan_s
    assert best == sorted(best, reverse=True)
