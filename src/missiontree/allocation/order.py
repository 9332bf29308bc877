"""
The total order of alternatives as one number.

Number all ways of doing a subtree in the order of their choice indices: an XOR counts through its children one after the other,
an AND counts like an odometer whose last child turns fastest. The number of a whole way is then a sum with one term per choice
taken, whatever else is chosen, and so utility and order together are one integer that is added up like a utility. No two ways
have the same, so that ties are settled by plain comparison.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import log2

from missiontree.allocation.flat import Flat

MAX_BITS = 4096


@dataclass(frozen=True, slots=True)
class Order:
    """
    Places of all ways in the order of their choices.

    Parameters
    ----------
    ways
        How many there are through the possible nodes.
    offsets
        By node: if its parent is an XOR, what taking it adds to the place.
    """

    ways: int
    offsets: Sequence[int]

    def score(self, points: int, choices: Iterable[tuple[int, int]]) -> int:
        """Utility in whole points of any unit and the order in one: the greater comes first."""
        return points * self.ways - sum(self.offsets[child] for _, child in choices)


def order_of(flat: Flat, possible: Sequence[bool], max_bits: int = MAX_BITS) -> Order | None:
    """The order; None if the number of ways has more than about so many bits."""
    if _bits(flat, possible) > max_bits:
        return None
    ways = [1] * len(flat.kind)
    for node in range(len(flat.kind) - 1, -1, -1):
        if flat.kind[node] == "xor":
            ways[node] = sum(ways[child] for child in flat.children[node] if possible[child])
        elif possible[node]:
            for child in flat.children[node]:
                ways[node] *= ways[child]
    offsets, weight = [0] * len(flat.kind), [1] * len(flat.kind)
    for node, children in enumerate(flat.children):
        if not possible[node]:
            continue
        if flat.kind[node] == "xor":
            before = 0
            for child in children:
                offsets[child], weight[child] = before * weight[node], weight[node]
                before += ways[child] if possible[child] else 0
        else:
            after = weight[node]
            for child in reversed(children):
                weight[child] = after
                after *= ways[child]
    return Order(ways[0], offsets)


def _bits(flat: Flat, possible: Sequence[bool]) -> float:
    bits = [0.0] * len(flat.kind)
    for node in range(len(flat.kind) - 1, -1, -1):
        below = [bits[child] for child in flat.children[node] if possible[child]]
        if flat.kind[node] == "xor" and below:
            bits[node] = max(below) + log2(len(below))
        else:
            bits[node] = sum(below)
    return bits[0]
