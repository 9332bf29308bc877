"""Fronts and choices of random missions against all alternatives, each scheduled by trying everything."""

from __future__ import annotations

import random
from dataclasses import replace
from functools import cache
from typing import Any

import pytest

from benchmarks.campaign import made
from benchmarks.choice_cases import ChoiceCase, Written, all_written
from benchmarks.front_agreement import CAMPAIGN
from benchmarks.schedule_cases import ScheduleCase
from missiontree.allocation.kbest import ExactKBest
from missiontree.mission.brief import MissionBrief
from missiontree.mission.control import Control
from missiontree.mission.entity import Entity
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.front import Option
from missiontree.mission.objective import Objective
from missiontree.mission.position import Position
from missiontree.mission.routine import RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.mission.terms import NO_TERMS
from tests.builders import and_, grounded, leaf, xor_
from tests.choosing.asking import asked

SEEDS = range(14)
PLACES = {"p": 0.0, "q": 6.0}


@cache
def drawn(seed: int) -> tuple[ChoiceCase, tuple[Written, ...]]:
    """
    A mission, and every alternative that has a schedule.

    Two or three tasks, each of which some of three types can do, well or fast, some of them at a place on a line; some come one after
    the other.
    """
    rng = random.Random(seed)  # noqa: S311 - variation, not secrecy
    types = tuple(
        RobotType(
            id=name,
            capabilities={"any": 1.0},
            limits={"max_speed_mps": rng.choice((1.0, 2.0))},
            count=rng.choice((1, 1, 2)),
            position=Position(float(rng.randint(-2, 8)), 0.0),
        )
        for name in ("a", "b", "c")
    )
    specs = []
    for number in range(rng.choice((2, 3))):
        at: dict[str, Any] = {"at": rng.choice(tuple(PLACES))} if rng.random() < 0.5 else {}
        ways = [
            leaf(f"{name}{number}", name, quality=rng.randint(2, 9) / 10, duration_s=float(rng.randint(1, 9)), **at)
            for name in rng.sample(("a", "b", "c"), rng.choice((2, 3)))
        ]
        specs.append(xor_(*ways, label=f"task{number}"))
    links = [("task0", "task1")] if rng.random() < 0.4 else []
    tree = grounded(and_(*specs), links)
    scene = Scene(entities=tuple(Entity(id=name, position=Position(x, 0.0)) for name, x in PLACES.items()))
    brief = MissionBrief(
        text="Mission",
        fleet=Fleet(types),
        routines=RoutineLibrary(routines=()),
        scene=scene,
        weights=Weights(1.0, rng.choice((0.02, 0.05))),
    )
    first = ExactKBest()(tree, brief.fleet, brief.weights, 1, Control()).alternatives[0]
    case = ChoiceCase(tree, brief, ScheduleCase(tree, first, brief.fleet, scene, NO_TERMS, frozenset()))
    return case, tuple(all_written(case))


def told(option: Option) -> tuple[int, int]:
    """Utility in millionths, makespan in ticks."""
    return round(option.alternative.utility * 1e6), round(option.schedule.makespan_s * 1000)


def unbeaten(truth: tuple[Written, ...]) -> list[tuple[int, int]]:
    found: list[tuple[int, int]] = []
    for one in sorted(truth, key=lambda one: (-one.utility, one.makespan)):
        if not found or one.makespan < found[-1][1]:
            found.append((one.utility, one.makespan))
    return found


@pytest.mark.parametrize("seed", SEEDS)
def test_the_front_is_what_trying_everything_finds(seed: int) -> None:
    case, truth = drawn(seed)
    front = asked(case.tree, case.brief, front=True).front
    assert front is not None
    assert front.certificate.claim == "proven"
    assert front.found == len(unbeaten(truth))
    found = [told(option) for option in front.options]
    assert found == unbeaten(truth) if front.found <= 7 else set(found) <= set(unbeaten(truth))


def test_most_of_these_missions_have_something_to_choose() -> None:
    assert sum(len(unbeaten(drawn(seed)[1])) > 1 for seed in SEEDS) > len(SEEDS) / 2


@pytest.mark.parametrize("seed", SEEDS)
def test_choices_are_what_trying_everything_finds(seed: int) -> None:
    case, truth = drawn(seed)
    of_a_tick = case.brief.weights.beta * 1000
    best = {
        "makespan": min((one.makespan, -one.utility) for one in truth)[0] / 1000,
        "utility-makespan": min((-one.utility, one.makespan) for one in truth)[1] / 1000,
        "weighted-team": max(one.timeless - of_a_tick * one.makespan for one in truth) / 1e6,
    }
    objectives: tuple[Objective, ...] = ("makespan", "utility-makespan", "weighted-team")
    for objective in objectives:
        chosen = asked(case.tree, replace(case.brief, objective=objective)).chosen
        assert chosen is not None
        assert chosen.option.certificate.claim == "proven"
        assert chosen.worth == pytest.approx(best[objective], abs=1e-5)


@pytest.mark.parametrize("seed", SEEDS)
def test_no_plan_of_the_front_is_worth_more_by_robot_time_than_the_bound(seed: int) -> None:
    """Worths are worked out here from start and end of all actions and legs; a move's leg is the move itself."""
    case, _ = drawn(seed)
    found = asked(case.tree, replace(case.brief, objective="weighted-sum"), front=True)
    assert found.chosen is not None
    assert found.front is not None
    bound = found.chosen.option.certificate.bound
    assert bound is not None
    worths = [worth(case, option) for option in found.front.options]
    assert bound >= found.chosen.worth - 1e-6
    assert found.chosen.worth >= max(worths) - 1e-6
    assert found.chosen.worth == pytest.approx(worth(case, found.chosen.option), abs=1e-5)


def worth(case: ChoiceCase, option: Option) -> float:
    weights, schedule = case.brief.weights, option.schedule
    actions = {done.leaf: case.tree.action(done.leaf) for done in schedule.actions}
    busy_s = sum(done.end_s - done.start_s for done in schedule.actions)
    busy_s += sum(leg.end_s - leg.start_s for leg in schedule.legs if not actions[leg.leaf].moves)
    timeless = sum(weights.alpha * one.estimate.quality - weights.gamma * one.estimate.cost for one in actions.values())
    return timeless - weights.beta * busy_s


def test_the_campaign_of_random_missions_finds_no_false_word() -> None:
    """Six missions with all rules that schedules keep; the full campaign has two thousand."""
    seen = made(CAMPAIGN, 1, 0, 6)
    assert seen.violations == {}
    assert sum(counts["missions"] for counts in seen.rows.values()) == 6
