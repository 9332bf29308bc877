"""
The pooled budgets that can be broken at all, in the smallest whole units.

What all robots of a type together may use of a budget is a purse, and so is what all robots of the mission may use. One that no way
through the tree can overdraw is left out, so a generous fleet leaves no purse; whether each single robot keeps its own limit is
decided elsewhere, see :mod:`feasibility`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from math import gcd

from missiontree.allocation.flat import Flat, Purse

Uses = tuple[tuple[int, int], ...]  # (index of the purse, amount), amounts above 0


@dataclass(frozen=True)
class Purses:
    """
    Purses with what they hold and what each leaf takes from them.

    Parameters
    ----------
    names
        Robot type (empty: all robots of the mission) and budget of each purse, in order.
    limits
        What each holds, in its own unit.
    units
        Billionths in the unit of each: the greatest that divides every use, so that amounts stay small.
    """

    names: tuple[Purse, ...]
    limits: tuple[int, ...]
    units: tuple[int, ...]

    @cached_property
    def _index(self) -> dict[Purse, int]:
        return {name: index for index, name in enumerate(self.names)}

    @cached_property
    def shifts(self) -> tuple[int, ...]:
        """Where each purse stands in a packed amount, with room for the sum of two amounts and a bit to tell that it is too much."""
        ends = [0]
        for limit in self.limits:
            ends.append(ends[-1] + limit.bit_length() + 2)
        return tuple(ends)

    @cached_property
    def guard(self) -> int:
        """The bits that are set in ``packed + slack`` if and only if some purse is overdrawn."""
        return sum(1 << (end - 1) for end in self.shifts[1:])

    @cached_property
    def slack(self) -> int:
        """What lifts an amount above its limit into the guard bit."""
        pairs = zip(pairwise(self.shifts), self.limits, strict=True)
        return sum(((1 << (end - begin - 1)) - 1 - limit) << begin for (begin, end), limit in pairs)

    def of_leaf(self, flat: Flat, leaf: int) -> Uses:
        """What the leaf takes from which purse: its type's, the mission's, or both."""
        found = ((self._index.get(purse, -1), amount) for purse, amount in flat.charges(leaf))
        return tuple((index, amount // self.units[index]) for index, amount in found if index >= 0)

    def packed(self, uses: Uses) -> int:
        """All amounts in one number; the sum of two packed amounts within the limits is the packed sum."""
        return sum(amount << self.shifts[index] for index, amount in uses)

    def unpacked(self, packed: int) -> list[int]:
        """The amount of every purse."""
        return [(packed >> begin) & ((1 << (end - begin)) - 1) for begin, end in pairwise(self.shifts)]


def purses_of(flat: Flat, possible: Sequence[bool]) -> Purses:
    """The purses that some way through the possible nodes overdraws, or might."""
    most = _most(flat, possible)
    limits = {purse: flat.held(purse) for purse in most}
    binding = {purse: limit for purse, limit in sorted(limits.items()) if limit is not None and most[purse] > limit}
    units = dict.fromkeys(binding, 0)
    for node, uses in enumerate(flat.uses):
        if possible[node]:
            for purse, amount in flat.charges(node) if uses else ():
                if purse in units:
                    units[purse] = gcd(units[purse], amount)
    return Purses(
        names=tuple(binding),
        limits=tuple(limit // units[purse] for purse, limit in binding.items()),
        units=tuple(units.values()),
    )


def _most(flat: Flat, possible: Sequence[bool]) -> Mapping[Purse, int]:
    """What the whole tree uses at most: a sum at an AND, a maximum over the possible children at an XOR."""
    if not any(flat.uses):
        return {}
    most: dict[int, dict[Purse, int]] = {}
    for node in range(len(flat.kind) - 1, -1, -1):
        below = [most.pop(child) for child in flat.children[node] if child in most]
        if not possible[node]:
            continue
        use = dict(flat.charges(node)) if flat.uses[node] else {}
        if below:
            use = max(below, key=len)  # the smaller go into the larger, so that deep trees stay cheap
        for part in below:
            if part is use:
                continue
            for purse, amount in part.items():
                before = use.get(purse, 0)
                use[purse] = before + amount if flat.kind[node] == "and" else max(before, amount)
        if use:
            most[node] = use
    return most.get(0, {})
