"""Shortest ways from one node to many, found only as far as they are asked for."""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterable

Neighbours = Callable[[int], Iterable[tuple[int, float]]]


class ShortestTree:
    """
    Dijkstra's algorithm from one source, resumed at every question.

    All questions from one source together cost one run at most: O(E log E) time for the E edges met, O(V) memory for the V
    nodes met. Ties are settled by node number.

    Parameters
    ----------
    source
        Node all ways start from.
    neighbours
        Answers, for a node, the nodes one step away and what the step costs, at least 0. Asked once per node.
    """

    def __init__(self, source: int, neighbours: Neighbours) -> None:
        self._neighbours = neighbours
        self._best = {source: 0.0}
        self._before: dict[int, int] = {}
        self._settled: set[int] = set()
        self._front = [(0.0, source)]

    def cost(self, target: int) -> float | None:
        """Least cost from the source to a node; None if it cannot be reached."""
        while target not in self._settled and self._front:
            cost, node = heapq.heappop(self._front)
            if node in self._settled:
                continue
            self._settled.add(node)
            self._extend(node, cost)
        return self._best[target] if target in self._settled else None

    def _extend(self, node: int, cost: float) -> None:
        best, before, settled = self._best, self._before, self._settled
        for neighbour, step in self._neighbours(node):
            reached = cost + step
            if neighbour not in settled and reached < best.get(neighbour, float("inf")):
                best[neighbour] = reached
                before[neighbour] = node
                heapq.heappush(self._front, (reached, neighbour))

    def way(self, target: int) -> list[int]:
        """
        Nodes of a cheapest way, from the source to the target.

        Raises
        ------
        KeyError
            If the target cannot be reached, or was never asked for.
        """
        if target not in self._settled:
            raise KeyError(target)
        nodes = [target]
        while (before := self._before.get(nodes[-1])) is not None:
            nodes.append(before)
        return nodes[::-1]
