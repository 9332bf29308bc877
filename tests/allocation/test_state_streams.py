"""States of use: all ways within the purses, in the exact order, with and without a wanted utility."""

from __future__ import annotations

from itertools import islice

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from benchmarks.random_trees import Case
from benchmarks.tied_budget import tied_mission
from missiontree.allocation.core import core_of
from missiontree.allocation.exhaustive import every_selection
from missiontree.allocation.flat import Flat, flatten
from missiontree.allocation.multipliers import SCALE, relax
from missiontree.allocation.order import order_of
from missiontree.allocation.possible import possible_nodes
from missiontree.allocation.purses import purses_of
from missiontree.allocation.selection import Selection, select
from missiontree.allocation.state_streams import best_first
from missiontree.allocation.states import Problem, TooMany, tables_of
from missiontree.mission.estimate import Weights
from tests.strategies import cases


def problem_of(flat: Flat) -> Problem | None:
    possible = possible_nodes(flat).possible
    if not possible[0]:
        return None
    purses = purses_of(flat, possible)
    core, order = core_of(flat, possible, purses), order_of(flat, possible)
    assert order is not None
    return Problem(core, purses, order, relax(core, purses, lambda picked, bound: None, lambda: False))


def within(flat: Flat, way: Selection) -> bool:
    used: dict[tuple[str, str], int] = {}
    for node in way.leaves:
        for name, amount in flat.uses[node].items():
            used[flat.robot_type[node], name] = used.get((flat.robot_type[node], name), 0) + amount
    limits = {purse: flat.stocks[purse[0]].pooled(purse[1]) for purse in used}
    return all(limit is None or used[purse] <= limit for purse, limit in limits.items())


def oracle(flat: Flat) -> list[tuple[int, tuple[tuple[int, int], ...]]]:
    possible = possible_nodes(flat).possible
    ways = [way for way in every_selection(flat) if way is not None and within(flat, way)]
    ways = [way for way in ways if all(possible[node] for node in way.nodes)]  # one role may want too much of one robot
    ways.sort(key=lambda way: -sum(flat.utility[node] for node in way.leaves))
    return [(sum(flat.utility[node] for node in way.leaves), way.choices) for way in ways]


@settings(max_examples=300)
@given(cases(), st.floats(0, 1))
def test_all_ways_within_the_purses_and_all_above_a_wanted_utility(case: Case, share: float) -> None:
    flat = flatten(case.tree, case.fleet, case.weights)
    problem, expected = problem_of(flat), oracle(flat)
    if problem is None:
        assert expected == []
        return
    possible = possible_nodes(flat).possible
    if expected:
        # No way that the oracle finds is above the bound of the prices.
        assert expected[0][0] <= problem.relaxed.bound
    for wanted in (None, expected[int(share * (len(expected) - 1))][0] if expected else 0):
        tables = tables_of(problem, wanted, 10**6, lambda: False)
        drawn = []
        for score, way in best_first(tables):
            choices = select(flat, problem.core.taken(way), possible).choices
            assert score == problem.order.score(SCALE * problem.utility(score), choices)
            drawn.append((problem.utility(score), choices))
        reaching = [entry for entry in expected if wanted is None or entry[0] >= wanted]
        assert [entry for entry in drawn if wanted is None or entry[0] >= wanted] == reaching


def test_states_are_few_where_ways_are_countless() -> None:
    tree, fleet = tied_mission(30, {"a": 3})
    problem = problem_of(flatten(tree, fleet, Weights()))
    assert problem is not None
    tables = tables_of(problem, None, 10**6, lambda: False)
    # Zero to three uses, for every one of 2**30 ways.
    assert len(tables.tables[-1]) == 4
    drawn = [problem.utility(score) for score, _ in islice(best_first(tables), 4_062)]
    # C(30, 3) = 4,060 ways with three a, then 435 with two.
    assert (drawn[0], drawn[4_059], drawn[4_060]) == (27_300_000, 27_300_000, 27_200_000)


def test_a_cap_and_a_stop_end_the_sweep() -> None:
    tree, fleet = tied_mission(30, {"a": 3})
    problem = problem_of(flatten(tree, fleet, Weights()))
    assert problem is not None
    with pytest.raises(TooMany):
        tables_of(problem, None, 20, lambda: False)
    with pytest.raises(TooMany):
        tables_of(problem, None, 10**6, lambda: True)
