"""
A pool of feasible alternatives by cheap methods, for when the proof is not finished.

The best that the prices advise is repaired and improved by exchanges; the paper's Algorithm 1 adds what it keeps; and the
neighbours of the best, one exchange away, add theirs. Every one has passed the referee, nothing is claimed of their ranks.
"""

from __future__ import annotations

import heapq
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from missiontree.allocation.core import Core, Way
from missiontree.allocation.exchanges import improved, neighbours, repaired
from missiontree.allocation.feasibility import Feasibility, Verdict
from missiontree.allocation.flat import Flat
from missiontree.allocation.item import choices_of
from missiontree.allocation.multipliers import STEPS, Relaxed, relax, sweep
from missiontree.allocation.pruned import kept_ways
from missiontree.allocation.purses import Purses
from missiontree.allocation.selection import Selection, select
from missiontree.allocation.writing import FREE
from missiontree.mission.control import Control

FEWEST_KEPT_BY_PRUNING, MOST_KEPT_BY_PRUNING = 8, 32
SMALL_PRUNING = 200_000  # nodes times ways kept that are worth pruning even when time is up
REPAIRED_PARTS = 600_000  # parts looked at by all repairs together
SEEDS = 4  # ways whose neighbours are looked at
SMALL_CORE = 5_000  # parts that are worth looking around in even when time is up
REFEREED = 400  # decisions of the referee asked for by neighbours


@dataclass(frozen=True, slots=True)
class Pooled:
    """One feasible alternative."""

    utility: int
    selection: Selection
    verdict: Verdict


class Pool:
    """
    What is known to be feasible.

    Parameters
    ----------
    flat, possible
        The problem.
    referee
        Who decides; None if nothing couples the choices.
    k
        How many are wanted.
    """

    def __init__(self, flat: Flat, possible: Sequence[bool], referee: Feasibility | None, k: int) -> None:
        self.flat, self.possible, self.referee, self.k = flat, possible, referee, k
        self._places = [0] * len(flat.kind)
        for children in flat.children:
            for place, child in enumerate(children):
                self._places[child] = place
        self._entries: dict[tuple[tuple[int, int], ...], Pooled | None] = {}
        self._best: list[int] = []  # heap of the k best utilities
        self.highest: int | None = None

    def offer(self, taken: Mapping[int, int]) -> bool:
        """Let the referee decide a way through the tree; whether it is, or was, taken up."""
        selection = select(self.flat, taken, self.possible)
        if selection.choices not in self._entries:
            verdict = self.referee.decide(selection) if self.referee is not None else FREE
            self.add(sum(self.flat.utility[leaf] for leaf in selection.leaves), selection, verdict)
        return self._entries[selection.choices] is not None

    def add(self, utility: int, selection: Selection, verdict: Verdict) -> None:
        """Remember what was decided already."""
        if self._entries.get(selection.choices) is not None:
            return
        if verdict.answer != "yes":
            self._entries[selection.choices] = None
            return
        self._entries[selection.choices] = Pooled(utility, selection, verdict)
        self.highest = utility if self.highest is None else max(self.highest, utility)
        heapq.heappush(self._best, utility)
        if len(self._best) > self.k:
            heapq.heappop(self._best)

    @property
    def kth(self) -> int | None:
        """Utility of the k-th best; None if there are fewer."""
        return self._best[0] if len(self._best) == self.k else None

    def listed(self) -> list[Pooled]:
        """All of them in the order of alternatives."""
        return sorted(
            (entry for entry in self._entries.values() if entry is not None),
            key=lambda entry: (-entry.utility, [self._places[child] for _, child in entry.selection.choices]),
        )


def fill(pool: Pool, core: Core, purses: Purses, control: Control) -> Relaxed:
    """
    Fill the pool, and find prices on the way.

    A few sweeps are made even when time is up, so that there is something to show.
    """
    repairs, unseen = max(2, REPAIRED_PARTS // len(core)), 0
    if repairs < STEPS:
        # In large trees repairs take longer than sweeps; after the first one the prices go ahead.
        unseen = STEPS // 3
    starts: list[tuple[int, Way]] = []

    def visit(picked: list[int], _: float) -> int | None:
        nonlocal repairs, unseen
        unseen -= 1
        if repairs > 0 and (unseen < 0 or pool.highest is None or control.ended()):
            repairs -= 1
            way = repaired(core, purses, picked)
            if way is not None:
                way = improved(core, purses, way, picked, control.ended)
                starts.append((core.way_under(len(core) - 1, way)[1], way))
                pool.offer(core.taken(way))
        return pool.highest

    relaxed = relax(core, purses, visit, control.ended)
    _prune(pool, control)
    _look_around(pool, core, purses, starts, relaxed, control)
    return relaxed


def _prune(pool: Pool, control: Control) -> None:
    kept = min(max(pool.k, FEWEST_KEPT_BY_PRUNING), MOST_KEPT_BY_PRUNING)
    hurried = control.ended()
    if hurried and (pool.highest is not None or len(pool.flat.kind) * kept > SMALL_PRUNING):
        return
    for way in kept_ways(pool.flat, kept, Control() if hurried else control):
        pool.offer(choices_of(way))


def _look_around(
    pool: Pool,
    core: Core,
    purses: Purses,
    starts: list[tuple[int, Way]],
    relaxed: Relaxed,
    control: Control,
) -> None:
    """Neighbours of the best starts, then of the best among those, until time is up or enough were asked for."""
    _, advised = sweep(core, relaxed.prices)
    starts.sort(key=lambda entry: -entry[0])
    seeds = [way for place, (_, way) in enumerate(starts) if way not in [other for _, other in starts[:place]]][:SEEDS]
    asked = 0

    def late() -> bool:
        return control.ended() and (pool.kth is not None or len(core) > SMALL_CORE)

    for _ in range(2):
        found: list[Way] = []
        for seed in seeds:
            if late():
                return
            for way in neighbours(core, purses, seed, advised)[: 2 * pool.k + 100]:
                if late() or asked == REFEREED:
                    return
                asked += 1
                if pool.offer(core.taken(way)):
                    found.append(way)
        seeds = found[:SEEDS]
