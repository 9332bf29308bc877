"""
Is there any alternative at all? The exact search, which ends at the first one it finds.

First candidates are those that use the least, as shares of what there is. Then utilities are left aside, so that the prices of
branch and bound have nothing else to do than to show that the budgets do not last.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from missiontree.allocation.core import core_of
from missiontree.allocation.coupling import couples
from missiontree.allocation.feasibility import Feasibility
from missiontree.allocation.flat import Flat
from missiontree.allocation.item import choices_of
from missiontree.allocation.pool import Pool
from missiontree.allocation.possible import possible_nodes
from missiontree.allocation.preorder import preorder
from missiontree.allocation.purses import purses_of
from missiontree.allocation.rounds import Rounds
from missiontree.allocation.streams import best_first, stream_of
from missiontree.mission.control import Control
from missiontree.mission.estimate import MICRO

TRIED_FIRST, MOST_TRIED = 4, 2_000  # candidates of the plain stream
MOST_NODES = (50_000, 500)  # of branch and bound, compiled and plain
PACKING_STEPS = 5_000


def any_alternative(flat: Flat, control: Control) -> bool | None:
    """Whether some alternative keeps all rules; None if a search of bounded effort does not tell."""
    return _Question(flat, control).answer()


def lean(flat: Flat) -> Flat:
    """The same problem, with a utility that is the higher, the less is used: millionths of what there is, of all budgets together."""
    held = [flat.held(purse) for purse in flat.charges.purses]
    utility = []
    for uses in flat.charges.of_leaf:
        shares = 0
        for purse, amount in uses:
            limit = held[purse]
            if limit is not None:
                shares += min(MICRO, MICRO * amount // max(1, limit))
        utility.append(-shares)
    return replace(flat, utility=tuple(utility))


class _Question:
    def __init__(self, flat: Flat, control: Control) -> None:
        self.flat = flat
        self.possible: Sequence[bool] = possible_nodes(flat).possible
        self.pool = Pool(flat, self.possible, Feasibility(flat, PACKING_STEPS) if couples(flat) else None, 1)
        self.control = replace(control, stop=lambda: self._found() or control.stop())

    def _found(self) -> bool:
        return self.pool.highest is not None

    def answer(self) -> bool | None:
        """The answer; a search that came to its end without an alternative is a proof, unless one was left undecided."""
        finished = self._finished()
        if self._found():
            return True
        return False if finished and self.pool.undecided is None else None

    def _finished(self) -> bool:
        stream = stream_of(lean(self.flat), self.possible)
        if stream is None:
            return True
        items = best_first(stream)
        for _ in range(TRIED_FIRST):
            item = next(items, None)
            if item is None or self.pool.offer(choices_of(item)) is not None:
                return True
        purses = purses_of(self.flat, self.possible)
        if purses.names:
            flat = replace(self.flat, utility=(0,) * len(self.flat.utility))
            core = core_of(flat, self.possible, purses)
            rounds = Rounds(core, purses, preorder(flat), self.pool, self.control, MOST_NODES)
            return rounds.bound is None or rounds.run()
        for _ in range(MOST_TRIED):
            item = next(items, None)
            if item is None or self.pool.offer(choices_of(item)) is not None:
                return True
            if self.control.ended():
                return False
        return False
