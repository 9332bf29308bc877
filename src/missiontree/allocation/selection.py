"""What a choice at every reached XOR selects."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from missiontree.allocation.flat import Flat


@dataclass(frozen=True, slots=True)
class Selection:
    """
    A complete way through the tree.

    Parameters
    ----------
    choices
        (XOR, child) for every reached XOR, in preorder.
    nodes
        Selected nodes, in preorder.
    leaves
        Selected leaves, in preorder.
    """

    choices: tuple[tuple[int, int], ...]
    nodes: tuple[int, ...]
    leaves: tuple[int, ...]


def select(flat: Flat, taken: Mapping[int, int], possible: Sequence[bool]) -> Selection:
    """
    Follow the choices through the tree.

    Parameters
    ----------
    flat
        The problem.
    taken
        Position of the chosen child by XOR; may leave out XORs with a single possible child.
    possible
        Which nodes can be done.
    """
    children = flat.children

    def child_of(xor: int) -> int:
        place = taken.get(xor)
        return next(below for below in children[xor] if possible[below]) if place is None else children[xor][place]

    return follow(flat, child_of)


def follow(flat: Flat, child_of: Callable[[int], int]) -> Selection:
    """
    Go through the tree from the root.

    Parameters
    ----------
    flat
        The problem.
    child_of
        Which child of an XOR to take.
    """
    kind, children = flat.kind, flat.children
    choices, nodes, leaves, stack = [], [], [], [0]
    while stack:
        node = stack.pop()
        nodes.append(node)
        if kind[node] == "action":
            leaves.append(node)
        elif kind[node] == "and":
            stack.extend(children[node][::-1])
        else:
            child = child_of(node)
            choices.append((node, child))
            stack.append(child)
    return Selection(tuple(choices), tuple(nodes), tuple(leaves))
