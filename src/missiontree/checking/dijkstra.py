"""Shortest ways in any graph, plainly (E. W. Dijkstra, "A note on two problems in connexion with graphs", 1959)."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from heapq import heappop, heappush
from typing import TypeVar

Node = TypeVar("Node")


def shortest(
    sources: Iterable[tuple[Node, float]], neighbours: Callable[[Node], Iterable[tuple[Node, float]]]
) -> dict[Node, float]:
    """Least length from the sources, each of which starts with a length of its own, to every node that can be reached."""
    least: dict[Node, float] = {}
    queue: list[tuple[float, int, Node]] = []
    counter = 0
    for node, length in sources:
        heappush(queue, (length, counter, node))
        counter += 1
    while queue:
        length, _, node = heappop(queue)
        if node in least:
            continue
        least[node] = length
        for neighbour, step in neighbours(node):
            if neighbour not in least:
                heappush(queue, (length + step, counter, neighbour))
                counter += 1
    return least
