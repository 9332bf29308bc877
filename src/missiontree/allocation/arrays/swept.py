"""A tree after the sweeps: its best way, and the few options that can matter for the k best."""

from __future__ import annotations

from typing import Any, NamedTuple

from missiontree.allocation.arrays.column import as_list
from missiontree.allocation.arrays.loops import Loops
from missiontree.allocation.kernel.sweeping import BLOCKED, NOTHING
from missiontree.mission.columns import XOR


class Region(NamedTuple):
    """
    Where the best way below a node stands in the columns of what was followed.

    Parameters
    ----------
    choices_from, choices_until
        Its choices, in preorder.
    leaves_from, leaves_until
        Its leaves, in preorder.
    """

    choices_from: int
    choices_until: int
    leaves_from: int
    leaves_until: int


class Swept:
    """
    A tree after the sweep up.

    Parameters
    ----------
    loops
        The sweeps.
    kind, parent, utility
        The tree, as the sweeps take it.
    taken
        Column to write what is taken into; holds ``BLOCKED`` for ANDs that are ruled out, else ``NOTHING``. Default: none is.

    Attributes
    ----------
    possible
        Whether there is a way through it.
    value, taken, child, sibling
        As :func:`missiontree.allocation.kernel.sweeping.best_below` leaves them.
    xors, until, leaf_from, leaf_until, leaves, at
        What was followed; as in :func:`missiontree.allocation.kernel.sweeping.follow_best`. ``at`` is per node.
    choices_followed, leaves_followed
        How much was followed so far.
    """

    def __init__(self, loops: Loops, kind: Any, parent: Any, utility: Any, taken: Any = None) -> None:
        self.kind, self.parent, self.loops = kind, parent, loops
        self.value = loops.column(utility)
        self.taken = self._blank(NOTHING) if taken is None else taken
        self.child, self.sibling = self._blank(NOTHING), self._blank(NOTHING)
        self.possible = bool(loops.best_below(self.kind, self.parent, self.value, self.taken, self.child, self.sibling))
        self.xors, self.until, self.leaf_from, self.leaf_until, self.leaves, self.at = (self._blank() for _ in range(6))
        self.choices_followed, self.leaves_followed = 0, 0

    def _blank(self, number: int = 0) -> Any:
        return self.loops.filled(len(self.kind), number)

    def follow(self, top: int) -> Region:
        """Follow the best way below a node, which must have one and must not have been followed."""
        choices, leaves = self.choices_followed, self.leaves_followed
        known = (self.xors, self.until, self.leaf_from, self.leaf_until, self.leaves, self.at)
        ends = self.loops.follow_best(*self._ways(), top, choices, leaves, *known)
        self.choices_followed, self.leaves_followed = int(ends[0]), int(ends[1])
        return Region(choices, self.choices_followed, leaves, self.leaves_followed)

    def able(self) -> list[bool]:
        """Per node, whether there is a way to do it."""
        kinds, taken = as_list(self.kind), as_list(self.taken)
        return [at >= 0 if kind == XOR else at != BLOCKED for kind, at in zip(kinds, taken, strict=True)]

    def chosen(self) -> Any:
        """Option taken at each XOR that was followed, as they stand in ``xors``."""
        return self.loops.gathered(self.taken, self.xors[: self.choices_followed])

    def options(self, count: int) -> list[int]:
        """
        The first options that are not taken, in the order of the best ways through them.

        So many, or all if there are fewer; in no particular order. Must be asked for before anything is followed.
        """
        if not count:
            return []
        loops = self.loops
        loss, option, lost = self._blank(NOTHING), self._blank(), self._blank()
        there = int(loops.losses(self.kind, self.parent, self.value, self.taken, loss, option, lost))
        option, lost = option[:there], lost[:there]
        if there <= count:
            return list(map(int, option))
        most = loops.smallest(lost, count - 1)
        less, equal = loops.parted(option, lost, most)
        if len(less) + len(equal) > count:
            equal = self._first_of_equals(loss, most, count - len(less))
        return less + equal

    def _first_of_equals(self, loss: Any, most: int, wanted: int) -> list[int]:
        stack, low, first = self.loops.filled(len(self.kind) + 1, 0), self._blank(), self._blank()
        scratch = (self.xors, self.until, self.leaf_from, self.leaf_until, self.leaves, self.at)
        found = self.loops.first_in_order(*self._ways(), loss, most, wanted, stack, low, *scratch, first)
        return list(map(int, first[:found]))

    def _ways(self) -> tuple[Any, ...]:
        return self.kind, self.parent, self.taken, self.child, self.sibling
