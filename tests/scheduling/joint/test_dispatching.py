"""Dispatching gives schedules in which nobody idles while something waits, and closes chains of many equal robots at once."""

from __future__ import annotations

import json
from random import Random

import pytest

from benchmarks.chains import chains
from missiontree.checking.columns import check_tree
from missiontree.formats.importers.tree_json import columns_of
from missiontree.formats.reader import parse
from missiontree.mission.certificate import Certificate
from missiontree.mission.columns import LEAF, TreeColumns
from missiontree.mission.control import Control
from missiontree.mission.tree_schedule import TreeSchedule
from missiontree.scheduling.joint.dispatching import dispatched
from missiontree.scheduling.joint.joint import schedule_tree
from missiontree.scheduling.joint.listing import Listed
from missiontree.scheduling.joint.problem import problem_of
from tests.scheduling.joint.small_trees import chosen_by_chance, drawn


def in_columns(tasks: int, types: int, robots: int, seed: int) -> TreeColumns:
    return columns_of(parse(json.dumps(chains(tasks, types, robots, seed)), "chains.json"))


def faults(tree: TreeColumns, found: Listed) -> tuple[object, ...]:
    certificate = Certificate(claim="bounded", method="load", bound=0.0)
    return check_tree(
        tree, TreeSchedule("feasible", certificate, found.chosen, found.start, found.robot, found.makespan)
    )


def test_what_is_dispatched_passes_the_checker_whatever_is_chosen_and_urgent() -> None:
    """Small trees of every form, precedence across choices included; children and urgencies by chance."""
    made = 0
    for seed in range(300):
        tree, luck = drawn(seed), Random(seed)  # noqa: S311 - luck for tests, not for secrets
        problem = problem_of(tree)
        chosen = chosen_by_chance(problem, luck)
        if chosen is None:
            continue
        found = dispatched(problem, [luck.random() for _ in problem.kind], chosen)
        assert faults(tree, found) == ()
        made += 1
    assert made >= 100


def test_nobody_idles_while_something_waits() -> None:
    """Chains: an action waits from the end of the one before; from then to its start all robots of its type are busy."""
    tree = in_columns(200, 3, 4, 1)
    problem = problem_of(tree)
    found = dispatched(problem, [0.0] * len(problem.kind), {})
    ends = {leaf: begun + problem.duration[leaf] for leaf, begun in found.start.items()}
    for leaf in problem.leaves:
        waits_from = max((ends[other] for other in problem.before[leaf]), default=0)
        for moment in range(waits_from, found.start[leaf]):
            busy = sum(
                problem.robot[other] == problem.robot[leaf] and begun <= moment < ends[other]
                for other, begun in found.start.items()
            )
            assert busy == 4
    assert all(problem.kind[leaf] == LEAF for leaf in found.start)


@pytest.mark.parametrize("seed", range(6))
def test_chains_of_twenty_equal_robots_meet_the_load_bound(seed: int) -> None:
    """The published family: all that the fullest type has to do, divided by twenty and rounded up, and no more."""
    tree = in_columns(1_200, 4, 20, seed)
    problem, load = problem_of(tree), [0] * 4
    for leaf in problem.leaves:
        load[problem.robot[leaf]] += problem.duration[leaf]
    found = schedule_tree(tree, Control(time_limit_s=100.0, clock=lambda: 0.0), solver=False)
    assert found.makespan_s == -(-max(load) // 20)
    assert (found.status, found.certificate.claim) == ("optimal", "proven")
    assert check_tree(tree, found) == ()
