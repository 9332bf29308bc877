"""
The pooled budgets that can be broken at all, in the smallest whole units.

What all robots of a type together may use of a budget is a purse, and so is what all robots of the mission may use. One that no way
through the tree can overdraw is left out, so a generous fleet leaves no purse; whether each single robot keeps its own limit is
decided elsewhere, see :mod:`feasibility`. That a type must take part is kept in a purse as well: what choices fall short of the most
roles that it could fill, see :mod:`turnout`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from math import gcd

from missiontree.allocation.flat import Flat, Purse
from missiontree.allocation.turnout import Turnout, turnouts

Uses = tuple[tuple[int, int], ...]  # (index of the purse, amount), amounts above 0
TAKING_PART = ""
"""Stands in a purse for what a required type falls short of, where other purses name a budget."""


@dataclass(frozen=True)
class Purses:
    """
    Purses with what they hold and what each leaf takes from them.

    Parameters
    ----------
    names
        Robot type (empty: all robots of the mission) and budget (empty: it must take part) of each purse, in order.
    limits
        What each holds, in its own unit.
    units
        Billionths in the unit of each: the greatest that divides every use, so that amounts stay small. For roles: 1.
    turnouts
        Of required types, in the order of their purses, which stand last. Default none.
    """

    names: tuple[Purse, ...]
    limits: tuple[int, ...]
    units: tuple[int, ...]
    turnouts: tuple[Turnout, ...] = field(default=(), repr=False)

    @cached_property
    def _index(self) -> dict[Purse, int]:
        return {name: index for index, name in enumerate(self.names)}

    def of_leaf(self, flat: Flat, leaf: int) -> Uses:
        """What the leaf takes from which purse: its type's, the mission's, or both."""
        index, units, found = self._index, self.units, list[tuple[int, int]]()
        for purse, amount in flat.charges(leaf) if flat.uses[leaf] else ():
            place = index.get(purse)
            if place is not None:
                found.append((place, amount // units[place]))
        return tuple(found)

    def of_choice(self, xor: int, child: int) -> Uses:
        """What taking the child of an XOR takes from which purse, beside what is below it."""
        first = len(self.names) - len(self.turnouts)
        found = ((index, turnout.shortfall(xor, child)) for index, turnout in enumerate(self.turnouts, start=first))
        return tuple((index, amount) for index, amount in found if amount)


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
    doubtful = tuple(turnout for turnout in turnouts(flat, possible) if not turnout.certain)
    return Purses(
        names=(*binding, *((turnout.type_id, TAKING_PART) for turnout in doubtful)),
        limits=(*(limit // units[purse] for purse, limit in binding.items()), *(turnout.spare for turnout in doubtful)),
        units=(*units.values(), *(1 for _ in doubtful)),
        turnouts=doubtful,
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
        together = flat.kind[node] == "and"
        for part in below:
            if part is use:
                continue
            for purse, amount in part.items():
                before = use.get(purse, 0)
                if together:
                    use[purse] = before + amount
                elif amount > before:
                    use[purse] = amount
        if use:
            most[node] = use
    return most.get(0, {})
