"""The lean way from columns to allocation's form, against the way over values."""

from __future__ import annotations

from missiontree.allocation.columns import flat_of_columns
from missiontree.allocation.exhaustive import Exhaustive
from missiontree.allocation.flat import flatten, without_budgets
from missiontree.allocation.kbest import ExactKBest
from missiontree.formats.importers.tree_grounded import fleet_of, grounded_of
from missiontree.mission.columns import WEIGHTS
from missiontree.mission.control import Control
from tests.formats.tree_files import random_tree, read, small

TREES = 300


def test_both_ways_end_at_the_same_problem() -> None:
    for seed in range(TREES):
        columns = read(random_tree(seed))
        for budgets in (True, False):
            for disjoint in (True, False):
                tree, fleet = grounded_of(columns, disjoint=disjoint), fleet_of(columns, budgets=budgets)
                lean = flat_of_columns(columns, budgets=budgets, disjoint=disjoint)
                assert lean == flatten(tree, fleet, WEIGHTS), seed


def test_budgets_left_out_are_budgets_taken_away() -> None:
    for seed in range(TREES):
        columns = read(random_tree(seed))
        assert flat_of_columns(columns, budgets=False) == without_budgets(flat_of_columns(columns)), seed


def test_what_is_flat_is_taken_as_it_is() -> None:
    columns = read(small())
    flat = flat_of_columns(columns)
    assert flatten(flat, fleet_of(columns), WEIGHTS) is flat


def test_the_best_of_random_trees_are_those_that_enumeration_finds() -> None:
    """Negative utilities, gates without children and XORs of one child among them."""
    feasible = 0
    for seed in range(TREES):
        columns = read(random_tree(seed))
        tree, fleet = grounded_of(columns, disjoint=True), fleet_of(columns)
        exact = ExactKBest()(tree, fleet, WEIGHTS, 5, Control())
        truth = Exhaustive()(tree, fleet, WEIGHTS, 5, Control())
        values = [one.utility for one in truth.alternatives]
        assert [one.utility for one in exact.alternatives] == values, seed
        feasible += bool(values)
    assert feasible > TREES // 4
