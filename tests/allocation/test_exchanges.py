"""Exchanges at the picks of a way: what they are said to change is what they change."""

from __future__ import annotations

import pytest

from missiontree.allocation.exchanges import Around
from tests.allocation.test_rounds import mission

SIZES = [(30, 3, 0), (120, 5, 1), (120, 4, 2)]


@pytest.mark.parametrize(("leaves", "robots", "seed"), SIZES)
def test_an_exchange_changes_what_it_says(leaves: int, robots: int, seed: int) -> None:
    """Differential: the way after it, added up anew."""
    problem = mission(leaves, robots, seed)
    core, top = problem.core, len(problem.core) - 1
    first, last = ([turn * (len(options) - 1) for options in core.options] for turn in (0, 1))
    around = Around(core, problem.purses, first)
    changed = list(around.exchanges())
    assert len(changed) == sum(len(core.options[pick]) - 1 for pick in around.way) > 0
    for advised in (first, last):
        near = Around(core, problem.purses, advised, around.way)
        for exchange in near.exchanges():
            _, utility, used = core.way_under(top, near.after(exchange))
            assert utility - core.way_under(top, near.way)[1] == exchange.gain
            after = {purse: near.used[purse] + by for purse, by in exchange.change.items()}
            assert after == {purse: used.get(purse, 0) for purse in after}


@pytest.mark.parametrize(("leaves", "robots", "seed"), SIZES[1:])
def test_no_pick_that_could_relieve_a_purse_is_passed_over(leaves: int, robots: int, seed: int) -> None:
    problem = mission(leaves, robots, seed)
    around = Around(problem.core, problem.purses, [0] * len(problem.core))
    overdrawn = around.overdrawn()
    assert overdrawn
    every = {(one.pick, one.option) for one in around.exchanges() if around.relief(one.change) > 0}
    near = {(one.pick, one.option) for one in around.exchanges(overdrawn) if around.relief(one.change) > 0}
    assert near == every != set()
