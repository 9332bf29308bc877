"""The order in which choices are compared."""

from __future__ import annotations

from missiontree.allocation.flat import Flat


def preorder(flat: Flat) -> list[int]:
    """Place of each node in preorder."""
    rank, stack, count = [0] * len(flat.kind), [0], 0
    while stack:
        node = stack.pop()
        rank[node] = count
        count += 1
        stack.extend(flat.children[node][::-1])
    return rank
