"""What nothing couples is written down from shared parts, and comes out as if each alternative were written by itself."""

from __future__ import annotations

from random import Random

import pytest

from benchmarks.random_trees import random_case
from missiontree.allocation import first_ways
from missiontree.allocation.arrays.loops import PLAIN, fast_loops
from missiontree.allocation.columns import flat_of_columns
from missiontree.allocation.coupling import couples
from missiontree.allocation.exhaustive import Exhaustive
from missiontree.allocation.flat import Flat, flatten, without_budgets
from missiontree.allocation.kbest import ExactKBest
from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from tests.builders import Spec, and_, grounded, leaf, trivial_fleet, xor_
from tests.formats.tree_files import random_tree, read

TREES = 300


def same_lists(flat: Flat, fleet: Fleet, k: int) -> int:
    """Compare with enumeration; how many are listed."""
    assert not couples(flat)
    exact, truth = (method(flat, fleet, Weights(), k, Control()) for method in (ExactKBest(), Exhaustive()))
    shown = [[(one.utility, one.choices, one.roles) for one in ranking.alternatives] for ranking in (exact, truth)]
    assert shown[0] == shown[1]
    assert exact.status == truth.status
    return len(exact.alternatives)


def test_choices_and_roles_are_those_of_enumeration() -> None:
    listed = [
        same_lists(flat_of_columns(read(random_tree(seed)), budgets=False), trivial_fleet(), 6) for seed in range(TREES)
    ]
    assert sum(count > 1 for count in listed) > TREES // 4


def test_roles_that_several_actions_share_are_counted_once() -> None:
    listed = []
    for seed in range(TREES):
        case = random_case(Random(seed))  # noqa: S311 - luck for tests, not for secrets
        flat = without_budgets(flatten(case.tree, case.fleet, case.weights))
        if not couples(flat):
            listed.append(same_lists(flat, case.fleet, 6))
    assert sum(count > 1 for count in listed) > 20


def test_a_role_stays_while_another_of_its_actions_is_selected() -> None:
    """Role x is filled by leaf a, and by b or c: taking d instead of b leaves x to a; role y comes and goes with d."""
    tree = grounded(and_(leaf("a", "r", "x"), xor_(leaf("b", "r", "x", quality=2), leaf("d", "r", "y")), *_many()))
    first, second = ExactKBest()(tree, trivial_fleet(), Weights(), 2, Control()).alternatives
    assert {role.role for role in second.roles} - {role.role for role in first.roles} != set()
    assert {role.role for role in first.roles} < {role.role for role in second.roles}


def _many() -> list[Spec]:
    """So many other roles that those of the second alternative are made of those of the first."""
    return [leaf(f"other{number}") for number in range(40)]


def test_compiled_sweeps_write_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    for seed in range(60):
        flat = flat_of_columns(read(random_tree(seed)), budgets=False)
        shown = []
        for loops in (PLAIN, fast_loops()):
            monkeypatch.setattr(first_ways, "_loops", lambda flat, loops=loops: loops)
            shown.append(repr(ExactKBest()(flat, trivial_fleet(), Weights(), 5, Control())))
        assert shown[0] == shown[1], seed
