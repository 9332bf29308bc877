"""
Several searchers of one core, side by side.

They go on in steps of so many nodes each and are looked at between steps, in order; so what is found, and after how many nodes, is the
same in every run with as many of them. Whoever is done takes over the uppermost corner that another one has not looked at yet.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from types import TracebackType

from missiontree.allocation.core import Way
from missiontree.allocation.kernel.columns import FINISHED, LAST, MET
from missiontree.allocation.searched import Searched

SHARED_FROM = 20_000  # nodes that one looks at alone


class Crew:
    """
    Searchers that share the work of the first one.

    Parameters
    ----------
    first
        Has its prices, and nothing searched yet.
    hands
        How many there may be, at least 1.
    """

    def __init__(self, first: Searched, hands: int) -> None:
        self._busy, self._hands, self._threads = [first], hands, ThreadPoolExecutor(hands)
        self.nodes = 0

    def __enter__(self) -> Crew:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._threads.shutdown()

    @property
    def finished(self) -> bool:
        """Whether nothing is left to be searched."""
        return not self._busy

    def step(self, target: int, steps: int, nodes: int) -> list[Way]:
        """
        Go on; the ways that were met, none if all went on for as many nodes as they may.

        Parameters
        ----------
        target, steps
            See :func:`missiontree.allocation.kernel.branching.branch`.
        nodes
            That each looks at before it pauses.
        """
        self._share(target)
        before = sum(one.nodes for one in self._busy)
        if len(self._busy) == 1:
            answers = [self._busy[0].branch(target, steps, False, nodes)]
        else:
            answers = list(self._threads.map(lambda one: one.branch(target, steps, False, nodes), self._busy))
        self.nodes += sum(one.nodes for one in self._busy) - before
        ways = [one.candidate() for one, answer in zip(self._busy, answers, strict=True) if answer in (MET, LAST)]
        self._busy = [one for one, answer in zip(self._busy, answers, strict=True) if answer != FINISHED]
        return ways

    def bound(self, above: int) -> int:
        """Nothing that was not searched yet has more utility, in millionths. ``above``: the same before the search."""
        return max(one.bound(above) for one in self._busy)

    def _share(self, target: int) -> None:
        if self.nodes < SHARED_FROM:
            return
        for giver in tuple(self._busy):
            if len(self._busy) < self._hands and (taker := giver.parted(target)) is not None:
                self._busy.append(taker)
