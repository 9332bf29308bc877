"""What must share something takes as long as all of it together, shared evenly: a bound of the checker's own."""

from __future__ import annotations

from collections.abc import Sequence

Piece = tuple[int, int, int]
"""When a piece of work begins at the earliest, how long it takes, and how long the mission goes on after it, in ticks."""
MOST_STARTS = 2500
"""Earliest starts that are tried."""


def shared(pieces: Sequence[Piece], places: int) -> int:
    """
    The largest, over earliest starts and over what must follow, of start + work within + what follows.

    Parameters
    ----------
    pieces
        Work that shares the places. It need not be done in one go, nor by one.
    places
        How many pieces can be under way at once; less than 1 counts as 1.

    Returns
    -------
    Ticks below which not all can be done.
    """
    least = 0
    for head in {start for start, _, _ in pieces[:MOST_STARTS]}:
        work = 0
        for _, length, tail in sorted((one for one in pieces if one[0] >= head), key=lambda one: -one[2]):
            work += length
            least = max(least, head - (-work // max(1, places)) + tail)
    return least
