"""
Alternatives of a problem in which nothing couples the choices, written down with what they have in common shared.

Of ten alternatives with 30,000 choices each, the second to the tenth differ from the best in a few. So a choice and a role are made into
values once, and the tuples of an alternative are put together from stretches of those of the best.
"""

from __future__ import annotations

from bisect import bisect_left
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice

from missiontree.allocation.arrays.ways import BestWays, Draft, Stretch
from missiontree.allocation.first_ways import swept_of
from missiontree.allocation.flat import Flat
from missiontree.mission.alternative import Choice, RoleType

FEW = 8  # roles are changed one by one while fewer than one in so many leaves changes

_Filled = tuple[int, str]  # a role and the type that fills it


class Uncoupled:
    """
    The sweep over a problem that nothing couples.

    Parameters
    ----------
    flat
        The problem.

    Attributes
    ----------
    possible
        Per node, whether some alternative could select it.
    """

    def __init__(self, flat: Flat) -> None:
        self._flat, self._swept = flat, swept_of(flat)
        self.possible = self._swept.able()

    def best(self, k: int) -> Written | None:
        """The k best alternatives; None if there is none."""
        return Written(self._flat, BestWays(self._swept, k), k) if self._swept.possible else None


class Written:
    """
    The k best alternatives, best first, and their parts as values.

    Parameters
    ----------
    flat
        The problem.
    best
        Its best ways.
    k
        How many are wanted.
    """

    def __init__(self, flat: Flat, best: BestWays, k: int) -> None:
        self._flat, self._best, self._k = flat, best, k
        swept = best.swept
        self._leaves = list(map(int, swept.leaves[: swept.leaves_followed]))
        self._choices = [Choice(int(xor), int(child)) for xor, child in zip(swept.xors, swept.chosen(), strict=False)]
        self._best_leaves = best.regions[0].leaves_until
        filled = self._filled(self._leaves[: self._best_leaves])
        self._count = Counter(filled)
        self._order = sorted(self._count)
        self._known = {pair: RoleType(*pair) for pair in self._order}
        self._roles = [self._known[pair] for pair in self._order]

    def __iter__(self) -> Iterator[Draft]:
        return islice(self._best, self._k)

    def parts(self, draft: Draft) -> tuple[tuple[Choice, ...], tuple[RoleType, ...]]:
        """Choices in preorder, and roles in order with their types."""
        stretches = list(self._best.stretches(draft))
        choices: list[Choice] = []
        for stretch in stretches:
            choices += self._choices[stretch.choices]
            if stretch.option >= 0:
                choices.append(Choice(self._flat.parent[stretch.option], stretch.option))
        return tuple(choices), self._roles_of(stretches)

    def _filled(self, leaves: Sequence[int]) -> Iterator[_Filled]:
        return zip(
            map(self._flat.role.__getitem__, leaves), map(self._flat.robot_type.__getitem__, leaves), strict=True
        )

    def _roles_of(self, stretches: Sequence[Stretch]) -> tuple[RoleType, ...]:
        """The roles of the best, those of leaves that are not selected taken out, those of leaves that are selected put in."""
        gone, new = self._changes(stretches)
        if len(gone) + len(new) > len(self._order) // FEW:
            every = (leaf for stretch in stretches for leaf in self._leaves[stretch.leaves])
            return tuple(map(self._role, sorted(set(self._filled(list(every))))))
        change = Counter(self._filled(new))
        change.subtract(self._filled(gone))
        order, roles = self._order.copy(), self._roles.copy()
        for pair, more in change.items():
            before = self._count[pair]
            if bool(before) == bool(before + more):
                continue
            at = bisect_left(order, pair)
            if before:
                del order[at], roles[at]
            else:
                order.insert(at, pair)
                roles.insert(at, self._role(pair))
        return tuple(roles)

    def _changes(self, stretches: Iterable[Stretch]) -> tuple[list[int], list[int]]:
        """Leaves of the best that are not selected, and selected leaves that are none of the best's."""
        gone: list[int] = []
        new: list[int] = []
        last = 0
        for _, leaves, _ in stretches:
            if leaves.start >= self._best_leaves:
                new += self._leaves[leaves]
            else:
                gone += self._leaves[last : leaves.start]
                last = leaves.stop
        gone += self._leaves[last : self._best_leaves]
        return gone, new

    def _role(self, pair: _Filled) -> RoleType:
        if pair not in self._known:
            self._known[pair] = RoleType(*pair)
        return self._known[pair]
