"""What missiontree plans, the checker passes: random missions over every kind of map. A finding means that one of the two is wrong."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree.checking import check
from tests.checking.driven_missions import crowded_mission, driven_mission, part_mission
from tests.checking.few_runs import few_runs
from tests.checking.missions import random_mission, ruled_mission
from tests.checking.plans import made, part_made

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


def test_plans_with_what_is_rare_have_no_findings() -> None:
    """Twenty missions of each kind: ways home and to chargers, waits at them, hand-overs, and shared resources on ways."""
    visits, waits, homes, over = 0, 0, 0, 0
    for seed in range(20):
        for mission in (driven_mission, crowded_mission):
            plan = made(*mission(seed), k=2, scheduler=few_runs)
            assert check(plan) == (), f"{mission.__name__} {seed}"
            ways = [one for schedule in plan.schedules for one in schedule.recharges]
            visits += len(ways)
            waits += sum(one.leg is not None and one.start_s > one.leg.end_s for one in ways)
            homes += sum(len(schedule.returns) for schedule in plan.schedules)
            over += plan.tree is not None and any(link.kind == "hand_over" for link in plan.tree.links)
    assert min(visits, waits, homes, over) > 0, "the missions lack what they are for"


def test_plans_for_a_part_have_no_findings() -> None:
    """Five missions one part of which is due too early."""
    for seed in range(5):
        plan = part_made(*part_mission(seed))
        assert plan is not None
        assert (plan.outcome, check(plan)) == ("partial", ()), f"seed {seed}"
