"""How long a role keeps its robot at least, the way to it left out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from missiontree.scheduling.precedence import TaskGraph


def own_work(graph: TaskGraph, duration: Sequence[int], lag: Mapping[int, int], role: int, first: int | None) -> int:
    """
    The least ticks from the start of a role to its end, without the way to its first place.

    Parameters
    ----------
    graph
        What is done.
    duration, lag
        Of activities, and of ways inside roles; see :class:`missiontree.scheduling.bounds.Bounds`.
    role
        Which one.
    first
        Its first action with a place; None if it has none. A move is itself the way.
    """
    total = 0
    for leaf in graph.roles[role]:
        if leaf != first or not graph.tree.action(leaf).moves:
            total += duration[graph.activity_of[leaf]]
        if leaf != first:
            total += lag.get(leaf, 0)
    return total
