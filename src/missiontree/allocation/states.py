"""
What every part can earn in every state of use, by one sweep from the leaves up.

A state is what is taken from each purse. A part keeps, per state, the best way of doing it that takes just this; a pair keeps the
sums of its parts' states that overdraw no purse. States that cannot lead to a wanted utility are left out: a way that reaches it
earns, in every part, at least what the prices leave for that part (:meth:`missiontree.allocation.multipliers.Relaxed.least`).

A *worth* is utility after prices and the place in the order of choices in one integer, so the best is unique. The worth of a
whole way, plus the prices of its state, is its score (:class:`missiontree.allocation.order.Order`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from missiontree.allocation.core import Core
from missiontree.allocation.multipliers import SCALE, Relaxed
from missiontree.allocation.order import Order
from missiontree.allocation.purses import Purses

Table = dict[int, int]  # worth by packed state

LOOKS_PER_STATE = 30


@dataclass(frozen=True, slots=True)
class Problem:
    """A core with all that its ways are measured by."""

    core: Core
    purses: Purses
    order: Order
    relaxed: Relaxed

    def score(self, state: int, worth: int) -> int:
        """The score of a whole way."""
        amounts = self.purses.unpacked(state)
        paid = sum(price * amount for price, amount in zip(self.relaxed.prices, amounts, strict=True))
        return worth + paid * self.order.ways

    def utility(self, score: int) -> int:
        """The utility (millionths) of a whole way of that score."""
        return -(-score // (SCALE * self.order.ways))


class TooMany(Exception):
    """There are more states than the cap allows, or somebody said stop."""


@dataclass(frozen=True, slots=True)
class Tables:
    """
    The states of every part.

    Parameters
    ----------
    problem
        What they are states of.
    tables
        By part.
    least
        By part, the worth below which nothing was kept; None if all was.
    """

    problem: Problem
    tables: list[Table]
    least: list[int] | None


def tables_of(problem: Problem, wanted: int | None, cap: int, ended: Callable[[], bool]) -> Tables:
    """
    Sweep.

    Parameters
    ----------
    problem
        The mission.
    wanted
        Utility (millionths) that a whole way must reach; None keeps everything.
    cap
        States kept in all tables together.
    ended
        Asked at every part whether to stop.

    Raises
    ------
    TooMany
        If the cap is reached, or the work was ended.
    """
    core, order = problem.core, problem.order
    least = None
    if wanted is not None:
        # a way with p points after prices has a worth above (p - 1) * ways, whatever its place in the order
        least = [(problem.relaxed.least(part, wanted) - 1) * order.ways + 1 for part in range(len(core))]
    sweeping = _Sweep(problem, least, cap)
    for part in range(len(core)):
        if ended():
            raise TooMany
        sweeping.add(part)
    return Tables(problem, sweeping.tables, least)


class _Sweep:
    def __init__(self, problem: Problem, least: list[int] | None, cap: int) -> None:
        self.problem, self.least = problem, least
        self.tables: list[Table] = []
        self.states_left, self.looks_left = cap, cap * LOOKS_PER_STATE

    def add(self, part: int) -> None:
        """Make the table of the next part."""
        core = self.problem.core
        pair = core.pair[part]
        if pair is not None:
            table = self._pairs(part, self.tables[pair[0]], self.tables[pair[1]])
        elif core.options[part]:
            table = self._picks(part)
        else:
            table = self._settled(part)
        self.tables.append(table)
        self.states_left -= len(table)
        if self.states_left < 0:
            raise TooMany

    def _floor(self, part: int) -> int | None:
        return None if self.least is None else self.least[part]

    def _settled(self, part: int) -> Table:
        core, purses, prices = self.problem.core, self.problem.purses, self.problem.relaxed.prices
        uses = core.uses[part]
        if any(amount > purses.limits[purse] for purse, amount in uses):
            return {}
        points = SCALE * core.utility[part] - sum(prices[purse] * amount for purse, amount in uses)
        worth, floor = points * self.problem.order.ways, self._floor(part)
        return {purses.packed(uses): worth} if floor is None or worth >= floor else {}

    def _picks(self, part: int) -> Table:
        table: Table = {}
        for option in self.problem.core.options[part]:
            offset = self.problem.order.offsets[option.child]
            for state, worth in self.tables[option.part].items():
                if state not in table or worth - offset > table[state]:
                    table[state] = worth - offset
        floor = self._floor(part)
        return table if floor is None else {state: worth for state, worth in table.items() if worth >= floor}

    def _pairs(self, part: int, first: Table, second: Table) -> Table:
        """Best worths first in the inner loop, so that it ends where nothing wanted can follow."""
        slack, guard, floor = self.problem.purses.slack, self.problem.purses.guard, self._floor(part)
        table: Table = {}
        inner = sorted(((worth, state) for state, worth in second.items()), reverse=True)
        for state, worth in first.items():
            needed = None if floor is None else floor - worth
            for other_worth, other in inner:
                self.looks_left -= 1
                if needed is not None and other_worth < needed:
                    break
                both = state + other
                if (both + slack) & guard:
                    continue
                together = worth + other_worth
                if both not in table or together > table[both]:
                    table[both] = together
            if self.looks_left < 0 or len(table) > self.states_left:
                raise TooMany
        return table
