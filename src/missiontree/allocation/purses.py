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
from math import gcd

from missiontree.allocation.flat import Flat, Purse, Uses
from missiontree.allocation.turnout import Turnout, turnouts

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

    def of_leaves(self, flat: Flat) -> list[Uses]:
        """By node, what a leaf takes from which purse: its type's, the mission's, or both."""
        charges, index = flat.charges, {name: place for place, name in enumerate(self.names)}
        places = [index.get(purse, -1) for purse in charges.purses]
        return [
            tuple((place, amount // self.units[place]) for purse, amount in uses if (place := places[purse]) >= 0)
            if uses
            else ()
            for uses in charges.of_leaf
        ]

    def of_choice(self, xor: int, child: int) -> Uses:
        """What taking the child of an XOR takes from which purse, beside what is below it."""
        first = len(self.names) - len(self.turnouts)
        found = ((index, turnout.shortfall(xor, child)) for index, turnout in enumerate(self.turnouts, start=first))
        return tuple((index, amount) for index, amount in found if amount)


def purses_of(flat: Flat, possible: Sequence[bool]) -> Purses:
    """The purses that some way through the possible nodes overdraws, or might."""
    charges, most = flat.charges, _most(flat, possible)
    binding: dict[Purse, int] = {}
    units: dict[int, int] = {}
    for name, purse in sorted((charges.purses[purse], purse) for purse in most):
        limit = flat.held(name)
        if limit is not None and most[purse] > limit:
            binding[name], units[purse] = limit, 0
    for node, uses in enumerate(charges.of_leaf):
        if uses and possible[node]:
            for purse, amount in uses:
                if purse in units:
                    units[purse] = gcd(units[purse], amount)
    doubtful = tuple(turnout for turnout in turnouts(flat, possible) if not turnout.certain)
    return Purses(
        names=(*binding, *((turnout.type_id, TAKING_PART) for turnout in doubtful)),
        limits=(
            *(limit // unit for limit, unit in zip(binding.values(), units.values(), strict=True)),
            *(turnout.spare for turnout in doubtful),
        ),
        units=(*units.values(), *(1 for _ in doubtful)),
        turnouts=doubtful,
    )


def _most(flat: Flat, possible: Sequence[bool]) -> Mapping[int, int]:
    """What the whole tree uses at most: a sum at an AND, a maximum over the possible children at an XOR."""
    most: dict[int, dict[int, int]] = {}
    of_leaf = flat.charges.of_leaf if flat.charges.purses else ()
    for node in range(len(of_leaf) - 1, -1, -1):
        children = flat.children[node]
        if not children:
            if of_leaf[node] and possible[node]:
                most[node] = dict(of_leaf[node])
            continue
        below = [most.pop(child) for child in children if child in most]
        if not below or not possible[node]:
            continue
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
        most[node] = use
    return most.get(0, {})
