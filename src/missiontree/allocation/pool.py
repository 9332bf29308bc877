"""
A pool of feasible alternatives: what any method found, judged by the referee, in the order of alternatives.

Beside the search that proves, cheap methods fill it: the best that the prices advise is repaired and improved by exchanges; the
paper's Algorithm 1 adds what it keeps; and the neighbours of the best, one exchange away, add theirs. Nothing is claimed of their
ranks.
"""

from __future__ import annotations

import heapq
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain

from missiontree.allocation.core import Core, Way
from missiontree.allocation.exchanges import improved, near_pairs, neighbours, repaired
from missiontree.allocation.feasibility import Feasibility, Verdict
from missiontree.allocation.flat import Flat
from missiontree.allocation.item import choices_of
from missiontree.allocation.pruned import kept_ways
from missiontree.allocation.purses import Purses
from missiontree.allocation.selection import Selection, select
from missiontree.allocation.writing import FREE
from missiontree.mission.control import Control

FEWEST_KEPT_BY_PRUNING, MOST_KEPT_BY_PRUNING = 8, 32
SMALL_PRUNING = 200_000  # nodes times ways kept that are worth pruning even when time is up
PAIRED_TIES = 20  # ways two exchanges away, beyond twice those wanted, that are taken up
SEEDS = 4  # ways whose neighbours are looked at
SMALL_CORE = 5_000  # parts of which first ways are tried one by one, and pairs of exchanges
HURRIED_CORE = 1_000  # parts that are worth looking around in even when time is up
REFEREED = 400  # decisions of the referee asked for by neighbours


@dataclass(frozen=True, slots=True)
class Pooled:
    """One alternative that is feasible, or of which that could not be decided."""

    utility: int
    selection: Selection
    verdict: Verdict


class Pool:
    """
    What is known to be feasible, and what is undecided.

    Parameters
    ----------
    flat, possible
        The problem.
    referee
        Who decides; None if nothing couples the choices.
    k
        How many are wanted.

    Attributes
    ----------
    highest
        Utility of the best feasible one; None if there is none.
    undecided
        Utility of the best of those that could not be decided; None if there is none.
    """

    def __init__(self, flat: Flat, possible: Sequence[bool], referee: Feasibility | None, k: int) -> None:
        self.flat, self.possible, self.referee, self.k = flat, possible, referee, k
        self._entries: dict[tuple[tuple[int, int], ...], Pooled | None] = {}
        self._best: list[int] = []  # heap of the k best utilities
        self._count: dict[int, int] = {}  # feasible ones by utility
        self.highest: int | None = None
        self.undecided: int | None = None

    def offer(self, taken: Mapping[int, int]) -> Pooled | None:
        """Let the referee decide a way through the tree; the alternative if it is feasible, be it new or not."""
        selection = select(self.flat, taken, self.possible)
        if selection.choices not in self._entries:
            verdict = self.referee.decide(selection) if self.referee is not None else FREE
            self.add(sum(self.flat.utility[leaf] for leaf in selection.leaves), selection, verdict)
        entry = self._entries[selection.choices]
        return entry if entry is not None and entry.verdict.answer == "yes" else None

    def add(self, utility: int, selection: Selection, verdict: Verdict) -> None:
        """Remember what was decided already."""
        if self._entries.get(selection.choices) is not None:
            return
        self._entries[selection.choices] = None if verdict.answer == "no" else Pooled(utility, selection, verdict)
        if verdict.answer == "undecided":
            self.undecided = utility if self.undecided is None else max(self.undecided, utility)
        if verdict.answer != "yes":
            return
        self._count[utility] = self._count.get(utility, 0) + 1
        self.highest = utility if self.highest is None else max(self.highest, utility)
        heapq.heappush(self._best, utility)
        if len(self._best) > self.k:
            heapq.heappop(self._best)

    @property
    def kth(self) -> int | None:
        """Utility of the k-th best; None if there are fewer."""
        return self._best[0] if len(self._best) == self.k else None

    def found(self, wanted: int) -> int:
        """How many have that utility at least."""
        return sum(count for utility, count in self._count.items() if utility >= wanted)

    @property
    def tied(self) -> int:
        """How many have the utility of the k-th best."""
        return self._count.get(self._best[0], 0) if len(self._best) == self.k else 0

    def better_than(self, utility: int) -> int:
        """How many have more utility; counted up to k."""
        return sum(best > utility for best in self._best)

    def listed(self) -> list[Pooled]:
        """All of them in the order of alternatives."""
        places = self._places
        return sorted(
            (entry for entry in self._entries.values() if entry is not None),
            key=lambda entry: (-entry.utility, [places[child] for _, child in entry.selection.choices]),
        )

    @cached_property
    def _places(self) -> list[int]:
        """Of each node among its siblings; a search that needs no pool never asks."""
        places = [0] * len(self.flat.kind)
        for children in self.flat.children:
            for place, child in enumerate(children):
                places[child] = place
        return places


def start(
    pool: Pool,
    core: Core,
    purses: Purses,
    known: Way | None,
    advised: Sequence[int],
    careful: Iterable[Sequence[int]],
    prices: Sequence[float],
    control: Control,
) -> list[Way]:
    """
    Put first ways into the pool, best ones where that is cheap; ways to go on from, best first.

    Parameters
    ----------
    pool
        To be filled.
    core, purses
        What there is to choose.
    known
        A way within the purses; None if none is known.
    advised
        Options by pick, as the best prices advise them.
    careful
        The same by higher and higher prices; drawn one by one while they are needed.
    prices
        By purse, in millionths for a unit.
    control
        When to stop; one way is looked for even when time is up.
    """
    found: list[tuple[int, Way]] = []
    if known is not None and pool.offer(core.taken(known)) is not None:
        found.append((core.way_under(len(core) - 1, known)[1], known))
    for options in chain((advised,), careful):
        way = repaired(core, purses, options)
        if way is not None:
            way = improved(core, purses, way, options, control.ended)
            found.append((core.way_under(len(core) - 1, way)[1], way))
            pool.offer(core.taken(way))
        if found and (control.ended() or len(core) > SMALL_CORE):
            break
    found.sort(key=lambda entry: -entry[0])
    if found and len(core) <= SMALL_CORE and not control.ended():
        for way in near_pairs(core, purses, found[0][1], advised, prices, 2 * pool.k + PAIRED_TIES):
            if control.ended():
                break
            pool.offer(core.taken(way))
    return [way for _, way in found]


def fill(
    pool: Pool, core: Core, purses: Purses, starts: Sequence[Way], advised: Sequence[int], control: Control
) -> None:
    """Fill the pool further, from ways that :func:`start` found; a little is done even when time is up."""
    _prune(pool, control)
    look_around(pool, core, purses, starts, advised, control)


def _prune(pool: Pool, control: Control) -> None:
    kept = min(max(pool.k, FEWEST_KEPT_BY_PRUNING), MOST_KEPT_BY_PRUNING)
    hurried = control.ended()
    if hurried and (pool.highest is not None or len(pool.flat.kind) * kept > SMALL_PRUNING):
        return
    for way in kept_ways(pool.flat, kept, Control() if hurried else control):
        pool.offer(choices_of(way))


def look_around(
    pool: Pool,
    core: Core,
    purses: Purses,
    starts: Sequence[Way],
    advised: Sequence[int],
    control: Control,
) -> None:
    """Offer neighbours of the best starts, then of the best among those, until time is up or enough were asked for."""
    seeds = [way for place, way in enumerate(starts) if way not in starts[:place]][:SEEDS]
    asked = 0

    def late() -> bool:
        return control.ended() and (pool.kth is not None or len(core) > HURRIED_CORE)

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
