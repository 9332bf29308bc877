"""What missiontree plans, the checker passes: random missions over every kind of map. A finding means that one of the two is wrong."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree.checking import check
from tests.checking.missions import random_mission, ruled_mission
from tests.checking.plans import made

BATCH = 20


@pytest.mark.parametrize("batch", range(5))
def test_plans_of_random_missions_have_no_findings(batch: int) -> None:
    """A hundred missions, ranked exactly and scheduled greedily."""
    travelled = 0
    for seed in range(batch * BATCH, (batch + 1) * BATCH):
        plan = made(*random_mission(seed))
        assert check(plan) == (), f"seed {seed}"
        travelled += sum(len(schedule.legs) for schedule in plan.schedules)
    assert travelled > 0, "no robot of the batch moves: the missions test nothing"


@pytest.mark.parametrize("batch", range(5))
def test_plans_under_rules_for_the_whole_mission_have_no_findings(batch: int) -> None:
    """A hundred missions more, of which some are delivered, and some are not."""
    outcomes = set()
    for seed in range(batch * BATCH, (batch + 1) * BATCH):
        plan = made(*ruled_mission(seed))
        assert check(plan) == (), f"seed {seed}"
        outcomes.add(plan.outcome)
    assert {"delivered", "cannot_be_done"} <= outcomes


def test_plans_whose_robots_go_home_have_no_findings() -> None:
    """Thirty missions, some of them with a deadline that the ways home must keep."""
    ways = 0
    for seed in range(600, 630):
        tree, brief = random_mission(seed)
        plan = made(tree, replace(brief, return_home=True, deadline_s=200.0 if seed % 3 == 0 else None))
        assert check(plan) == (), f"seed {seed}"
        ways += sum(len(schedule.returns) for schedule in plan.schedules)
    assert ways > 0, "no robot goes home: the missions test nothing"


@pytest.mark.parametrize("allocator", ["exhaustive", "pruned"])
def test_plans_of_the_other_allocators_have_no_findings(allocator: str) -> None:
    """Thirty missions each."""
    for seed in range(500, 530):
        assert check(made(*random_mission(seed), allocator=allocator)) == (), f"seed {seed}"
