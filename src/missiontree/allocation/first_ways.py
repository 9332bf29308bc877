"""The first ways through a tree in the order of alternatives, whatever couples them, without a stream over the whole tree."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice

from missiontree.allocation.arrays.loops import PLAIN, Loops, are_compiled, fast_loops, fits
from missiontree.allocation.arrays.swept import Swept
from missiontree.allocation.arrays.ways import BestWays, Draft
from missiontree.allocation.flat import Flat
from missiontree.allocation.item import choices_of
from missiontree.allocation.kernel.sweeping import BLOCKED, NOTHING
from missiontree.allocation.selection import Selection, follow, select
from missiontree.allocation.streams import best_first, stream_of
from missiontree.mission.columns import AND, KINDS

CODE = {kind: number for number, kind in enumerate(KINDS)}


def swept_of(flat: Flat, possible: Sequence[bool] | None = None) -> Swept:
    """
    The sweep over a problem, its coupling left aside.

    Parameters
    ----------
    flat
        The problem.
    possible
        Which nodes can be done. Default: as the tree alone tells.
    """
    loops = _loops(flat)
    kinds, blocked = list(map(CODE.__getitem__, flat.kind)), None
    if possible is not None:
        # A node that is ruled out is an AND that some child blocks, whatever it was.
        kinds = [kind if able else AND for kind, able in zip(kinds, possible, strict=True)]
        blocked = loops.column([NOTHING if able else BLOCKED for able in possible])
    return Swept(loops, loops.column(kinds), loops.column(flat.parent), loops.column(flat.utility), blocked)


def _loops(flat: Flat) -> Loops:
    """Compiling takes longer than it saves here, so it is done only for who needs it anyway."""
    return fast_loops() if are_compiled() and fits(sum(map(abs, flat.utility))) else PLAIN


def ways_in_order(flat: Flat, possible: Sequence[bool], first: int) -> Iterator[tuple[int, Selection]]:
    """
    All ways through the possible nodes with their utilities, best first; the root must be possible.

    Parameters
    ----------
    flat, possible
        The problem.
    first
        As many are found without a stream over the whole tree, which is made if more are asked for.
    """
    best = BestWays(swept_of(flat, possible), first)
    drawn = 0
    for draft in islice(best, first):
        drawn += 1
        yield draft.utility, _selection(flat, best, draft)
    if drawn < first:
        return
    stream = stream_of(flat, possible)
    assert stream is not None
    for item in islice(best_first(stream), first, None):
        yield item.utility, select(flat, choices_of(item), possible)


def _selection(flat: Flat, best: BestWays, draft: Draft) -> Selection:
    taken = best.swept.taken
    return follow(flat, lambda xor: draft.options.get(xor, int(taken[xor])))
