"""A core as columns: nothing is lost by scaling, prices bound what there is, and narrowing keeps every way that matters."""

from __future__ import annotations

from dataclasses import dataclass, replace

import pytest
from hypothesis import given, settings

from benchmarks.allocation_agreement import numbered_case
from benchmarks.random_trees import Case
from benchmarks.tied_budget import tied_mission
from missiontree.allocation import searched
from missiontree.allocation.compiled import PLAIN
from missiontree.allocation.core import Core, core_of
from missiontree.allocation.exhaustive import every_selection
from missiontree.allocation.flat import Flat, flatten
from missiontree.allocation.possible import possible_nodes
from missiontree.allocation.preorder import preorder
from missiontree.allocation.purses import Purses, purses_of
from missiontree.allocation.searched import Scale, Searched, scale_of
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree
from tests.strategies import cases


@dataclass(frozen=True)
class Boiled:
    flat: Flat
    possible: tuple[bool, ...]
    core: Core
    purses: Purses

    def searched(self, deep: bool = True) -> Searched:
        return Searched(self.core, self.purses, preorder(self.flat), PLAIN, scale_of(self.core), deep=deep)


def boiled(tree: GroundedTree, fleet: Fleet, weights: Weights | None = None) -> Boiled | None:
    flat = flatten(tree, fleet, weights or Weights())
    possible = tuple(possible_nodes(flat).possible)
    if not possible[0]:
        return None
    purses = purses_of(flat, possible)
    return Boiled(flat, possible, core_of(flat, possible, purses), purses)


def ways_within(problem: Boiled) -> list[tuple[int, dict[int, int]]]:
    """Utility and choices of every way that keeps the purses, by plain counting."""
    found, of_leaves = [], problem.purses.of_leaves(problem.flat)
    for selection in every_selection(problem.flat):
        if selection is None or not all(problem.possible[node] for node in selection.nodes):
            continue
        used = [0] * len(problem.purses.limits)
        for leaf in selection.leaves:
            for purse, amount in of_leaves[leaf]:
                used[purse] += amount
        if all(amount <= limit for amount, limit in zip(used, problem.purses.limits, strict=True)):
            places = {xor: problem.flat.children[xor].index(child) for xor, child in selection.choices}
            found.append((sum(problem.flat.utility[leaf] for leaf in selection.leaves), places))
    return found


def test_a_scale_counts_in_the_greatest_common_unit() -> None:
    problem = boiled(*tied_mission(4, {"a": 1}))
    assert problem is not None
    # 1 and 0.9 have 0.1 in common; the sum of all parts, 76 tenths, leaves twenty bits behind the point.
    assert scale_of(problem.core) == Scale(100_000, 1 << 20)


def test_scaling_rounds_bounds_up_and_wanted_utilities_up() -> None:
    scale = Scale(unit=3, factor=4)
    assert [scale.up(utility) for utility in (-3, 0, 1, 3, 4)] == [-4, 0, 4, 4, 8]
    assert [scale.down(scaled) for scaled in (-1, 0, 3, 4, 11)] == [-3, 0, 0, 3, 6]


def test_prices_close_the_gap_where_there_is_none() -> None:
    problem = boiled(*tied_mission(10, {"a": 3}))
    assert problem is not None
    search = problem.searched()
    # 3 + 7 * 0.9, which a price of 0.1 proves.
    assert search.price() == 9_300_000
    assert search.true_prices(problem.purses) == [pytest.approx(100_000, rel=0.05)]


@settings(max_examples=60)
@given(cases())
def test_prices_sought_a_step_at_a_time_are_the_same(case: Case) -> None:
    problem = boiled(case.tree, case.fleet, case.weights)
    if problem is None or not problem.purses.names:
        return
    whole, pieces = problem.searched(), problem.searched()
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(searched.PRICED_IN_ONE_GO, False, 1)
        bound = pieces.price()
    assert (bound, pieces.prices) == (whole.price(), whole.prices)


def test_what_is_advised_is_an_option_also_where_no_way_leads() -> None:
    """Picks that hang in subtrees which cannot be done are parts, too; nobody looks at them when prices are sought."""
    unled = 0
    for index in range(60):
        case = numbered_case(2026, index)
        problem = boiled(case.tree, case.fleet, case.weights)
        if problem is None or not problem.purses.names:
            continue
        core, search = problem.core, problem.searched(deep=False)
        search.price()
        advised = search.advised()
        assert all(advised[pick] in range(len(options)) for pick, options in enumerate(core.options) if options)
        reached = core.picks_under(len(core) - 1, advised)
        unled += any(options and pick not in reached for pick, options in enumerate(core.options))
    assert unled


def test_nobody_waits_longer_for_prices_than_it_takes_to_look_at_so_many_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    """After the word to stop, which falls between two pieces of three steps each, no further piece is begun."""
    tree, fleet = tied_mission(10, {"a": 3})
    problem = boiled(tree, fleet)
    assert problem is not None
    monkeypatch.setitem(searched.PRICED_IN_ONE_GO, False, 3 * len(problem.core))
    search, steps, asked = problem.searched(), list[int](), iter([False, False, True, True, True])
    lower = search.engine.lower

    def counted(*given: object) -> tuple[int, int]:
        steps.append(given[2])  # type: ignore[arg-type]
        return lower(*given)

    search.engine = replace(search.engine, lower=counted)
    search.price(ended=lambda: next(asked))
    assert steps == [3, 3]


@settings(max_examples=150)
@given(cases())
def test_no_way_within_the_purses_is_above_the_bound_or_lost_by_narrowing(case: Case) -> None:
    problem = boiled(case.tree, case.fleet, case.weights)
    if problem is None or not problem.purses.names:
        return
    ways = ways_within(problem)
    search = problem.searched(deep=False)
    bound = search.price()
    assert all(utility <= bound for utility, _ in ways)
    for wanted in sorted({utility for utility, _ in ways})[-3:]:
        core = search.narrowed(wanted)
        assert core is not None
        allowed = [{option.place for option in options} for options in core.options if options]
        by_xor = {options[0].xor: places for options, places in zip(filter(None, core.options), allowed, strict=True)}
        for utility, places in ways:
            if utility >= wanted:
                for xor, place in places.items():
                    assert core.forced.get(xor, place) == place
                    assert place in by_xor.get(xor, {place})
