"""Prices on purses: the sweep, and a bound that holds and is near the truth."""

from __future__ import annotations

from benchmarks.tied_budget import tied_mission
from missiontree.allocation.core import Core, core_of
from missiontree.allocation.flat import flatten
from missiontree.allocation.multipliers import SCALE, relax, sweep
from missiontree.allocation.possible import possible_nodes
from missiontree.allocation.purses import Purses, purses_of
from missiontree.mission.estimate import Weights


def parts(tasks: int, budget: int) -> tuple[Core, Purses]:
    tree, fleet = tied_mission(tasks, {"a": budget})
    flat = flatten(tree, fleet, Weights())
    possible = possible_nodes(flat).possible
    purses = purses_of(flat, possible)
    return core_of(flat, possible, purses), purses


def test_a_sweep_earns_after_prices() -> None:
    core, _ = parts(10, 3)
    # Free: ten times 1. At 0.05 a use a still earns more, 0.95; at 0.2 b does, 0.9.
    assert [sweep(core, [price])[0][-1] for price in (0, 50_000, 200_000)] == [10_000_000, 9_500_000, 9_000_000]


def test_the_bound_is_near_the_best() -> None:
    core, purses = parts(10, 3)
    relaxed = relax(core, purses, lambda picked, bound: None, lambda: False)
    # The best is 3 + 7 * 0.9 = 9.3, which the price 0.1 would prove.
    assert 9_300_000 <= relaxed.bound < 9_310_000
    # Nothing is outside the whole, so a whole way of 9.3 must earn that, less what the budget is worth.
    whole = len(core) - 1
    assert relaxed.least(whole, 9_300_000) == SCALE * 9_300_000 - 3 * relaxed.prices[0]


def test_no_time_gives_the_bound_without_prices() -> None:
    core, purses = parts(10, 3)
    seen: list[list[int]] = []

    def visit(picked: list[int], bound: float) -> None:
        seen.append(picked)

    assert relax(core, purses, visit, lambda: True).bound == 10_000_000
    assert len(seen) == 1
