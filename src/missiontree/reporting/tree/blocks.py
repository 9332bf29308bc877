"""What a drawn tree is laid out by: single nodes, and columns of leaves that stand one above the other."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from missiontree.reporting.tree.shape import Shape

MOST_ACTIONS, MOST_BESIDE = 12, 12
_TALL = ((40, 1), (120, 3), (300, 5))
_TALLEST = 8


@dataclass(frozen=True, slots=True)
class Blocks:
    """
    The nodes of a tree, parted into blocks; blocks form a tree of their own.

    Parameters
    ----------
    members
        Nodes of each block, from the top down; more than one only if all are leaves with one parent, next to each other.
    children
        Blocks below each block, in order. Block 0 holds the root, parents come before children.
    of
        Block of each node.
    ordered
        Whether each block holds what one robot does, one after the other.
    """

    members: tuple[tuple[int, ...], ...]
    children: tuple[tuple[int, ...], ...]
    of: tuple[int, ...]
    ordered: tuple[bool, ...]

    def above(self, node: int) -> int | None:
        """The node above another one in its column."""
        members = self.members[self.of[node]]
        place = members.index(node)
        return members[place - 1] if place else None

    def hangs(self, block: int) -> bool:
        """Whether the nodes of a block hang on a line at its side: a column in no order."""
        return len(self.members[block]) > 1 and not self.ordered[block]


def blocks_of(shape: Shape) -> Blocks:
    """
    Put leaves into columns: what one robot does, in its order, and siblings without children if they are many, or the tree is large.

    How high columns are depends on the siblings and on the size of the whole tree, so that equal subtrees are parted equally.
    """
    high = next((most for size, most in _TALL if len(shape.nodes) <= size), _TALLEST)
    framed = frozenset(shape.frames)
    members: list[tuple[int, ...]] = [(0,)]
    children: list[tuple[int, ...]] = []
    of = [0] * len(shape.nodes)
    for block, nodes in enumerate(members):  # it grows while it is read
        below = [] if len(nodes) > 1 else list(_parted(shape, nodes[0], framed, high))
        children.append(tuple(range(len(members), len(members) + len(below))))
        members += below
        for node in nodes:
            of[node] = block
    ordered = [False] * len(members)
    for block, blocks_below in enumerate(children):
        for child in blocks_below:
            ordered[child] = _is_ordered(shape, members[block][0], members[child])
    return Blocks(tuple(members), tuple(children), tuple(of), tuple(ordered))


def _is_ordered(shape: Shape, parent: int, nodes: Sequence[int]) -> bool:
    roles = {shape.nodes[node].role for node in nodes}
    return shape.nodes[parent].gate == "and" and len(nodes) > 1 and len(roles) == 1 and None not in roles


def _parted(shape: Shape, parent: int, framed: frozenset[int], high: int) -> Iterator[tuple[int, ...]]:
    """Children of a node, block by block."""
    run: list[int] = []
    for child in shape.children[parent]:
        if shape.children[child] or child in framed:
            yield from _columns(shape, parent, run, high)
            yield (child,)
            run = []
        elif run and (shape.nodes[run[-1]].role is None) != (shape.nodes[child].role is None):
            yield from _columns(shape, parent, run, high)
            run = [child]
        else:
            run.append(child)
    yield from _columns(shape, parent, run, high)


def _columns(shape: Shape, parent: int, run: Sequence[int], high: int) -> Iterator[tuple[int, ...]]:
    """Leaves next to each other, in columns of nearly equal height."""
    if _is_ordered(shape, parent, run):
        high = MOST_ACTIONS
    elif len(run) > MOST_BESIDE:
        high = max(high, math.isqrt(len(run) - 1) + 1)  # about as many columns as rows
    count = -(-len(run) // high)
    for column in range(count):
        yield tuple(run[column * len(run) // count : (column + 1) * len(run) // count])
