"""Lower and lower utilities: no gap in what is drawn, and a bound on the rest whenever it ends."""

from __future__ import annotations

from itertools import islice

from benchmarks.tied_budget import tied_mission
from missiontree.allocation.core import core_of
from missiontree.allocation.deepening import Deepening, least_utility
from missiontree.allocation.feasibility import Feasibility
from missiontree.allocation.flat import flatten
from missiontree.allocation.multipliers import relax
from missiontree.allocation.order import order_of
from missiontree.allocation.pool import Pool
from missiontree.allocation.possible import possible_nodes
from missiontree.allocation.purses import purses_of
from missiontree.allocation.states import Problem
from missiontree.mission.estimate import Weights


def rounds(tasks: int, cap: int = 10**6, last: int | None = None) -> Deepening:
    tree, fleet = tied_mission(tasks, {"a": 1})
    flat = flatten(tree, fleet, Weights())
    possible = possible_nodes(flat).possible
    purses = purses_of(flat, possible)
    core, order = core_of(flat, possible, purses), order_of(flat, possible)
    assert order is not None
    relaxed = relax(core, purses, lambda picked, bound: None, lambda: False)
    pool = Pool(flat, possible, Feasibility(flat), 1)
    return Deepening(Problem(core, purses, order, relaxed), pool, cap, lambda: False, last)


def test_all_ways_come_once_and_then_nothing_is_left() -> None:
    deepening = rounds(4)
    # One a and three b in four ways, then four b.
    assert [utility for utility, _ in deepening.candidates()] == [3_700_000] * 4 + [3_600_000]
    assert deepening.bound is None


def test_what_was_looked_at_before_is_left_out() -> None:
    first = rounds(4)
    list(islice(first.candidates(), 2))
    assert first.last is not None
    assert [utility for utility, _ in rounds(4, last=first.last).candidates()] == [3_700_000] * 2 + [3_600_000]


def test_too_many_states_leave_the_bound_of_the_prices() -> None:
    deepening = rounds(4, cap=1)
    assert list(deepening.candidates()) == []
    assert deepening.bound == deepening.problem.relaxed.bound


def test_the_least_utility() -> None:
    assert least_utility(rounds(4).problem.core) == 3_600_000
