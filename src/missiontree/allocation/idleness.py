"""Alternatives without any action: of nothing there is no mean and no least, so such ways are counted, and listed apart."""

from __future__ import annotations

from missiontree.allocation.flat import Flat
from missiontree.allocation.narrowing import kept
from missiontree.errors import InputError

MOST_WAYS = 1000


def idle_ways(flat: Flat) -> int:
    """
    How many ways through the tree have no leaf, whatever couples the robots.

    Raises
    ------
    InputError
        If there are more than 1,000.
    """
    ways = [0] * len(flat.kind)
    for node in range(len(flat.kind) - 1, -1, -1):
        below = [ways[child] for child in flat.children[node]]
        if flat.kind[node] == "and":
            ways[node] = 1
            for count in below:
                ways[node] = min(MOST_WAYS + 1, ways[node] * count)
        else:
            ways[node] = min(MOST_WAYS + 1, sum(below))
    if ways[0] > MOST_WAYS:
        raise InputError(
            f"the tree can be done in more than {MOST_WAYS:,} ways without any action, and of no action there is no mean and no least",
            accepted="accumulate: sum, or a tree in which something has to be done",
        )
    return ways[0]


def idle_part(flat: Flat) -> Flat:
    """The problem of doing the mission without any action."""
    return kept(flat, lambda leaf: False)
