"""The same problem with some leaves that nobody may take; node numbers, and so choices and their order, stay what they are."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

from missiontree.allocation.flat import Flat
from missiontree.allocation.possible import structurally_possible


def kept(flat: Flat, keep: Callable[[int], bool]) -> Flat:
    """
    A problem in which a leaf that is not kept becomes an XOR without children, which nobody can do.

    Parameters
    ----------
    flat
        The problem.
    keep
        Whether a leaf stays.
    """
    dead = {node for node, kind in enumerate(flat.kind) if kind == "action" and not keep(node)}
    if not dead:
        return flat
    nodes = range(len(flat.kind))
    return replace(
        flat,
        kind=tuple("xor" if node in dead else flat.kind[node] for node in nodes),
        utility=tuple(0 if node in dead else flat.utility[node] for node in nodes),
        role=tuple(-1 if node in dead else flat.role[node] for node in nodes),
        robot_type=tuple("" if node in dead else flat.robot_type[node] for node in nodes),
        uses=tuple({} if node in dead else flat.uses[node] for node in nodes),
    )


def valued(flat: Flat, utility: Callable[[int], int]) -> Flat:
    """A problem in which the leaves have other utilities, in millionths."""
    kinds = enumerate(flat.kind)
    return replace(flat, utility=tuple(utility(node) if kind == "action" else 0 for node, kind in kinds))


def with_required(flat: Flat, types: Iterable[str]) -> Flat:
    """A problem in which these robot types must take part as well."""
    return replace(flat, required={**{name: (name,) for name in types}, **flat.required})


def fewest_leaves(flat: Flat) -> int:
    """No way through the tree that has a leaf has fewer; at least 1."""
    possible = structurally_possible(flat)
    fewest = [0] * len(flat.kind)
    for node in range(len(flat.kind) - 1, -1, -1):
        below = [fewest[child] for child in flat.children[node] if possible[child]]
        if flat.kind[node] == "action":
            fewest[node] = 1
        else:
            fewest[node] = sum(below) if flat.kind[node] == "and" else min(below, default=0)
    return max(1, fewest[0])


def highest_least(flat: Flat, possible: Sequence[bool]) -> int:
    """Every possible way with leaves has one with at most this utility."""
    utilities = [flat.utility[node] for node, kind in enumerate(flat.kind) if kind == "action" and possible[node]]
    top = max(utilities, default=0)
    least = [top] * len(flat.kind)
    for node in range(len(flat.kind) - 1, -1, -1):
        below = [least[child] for child in flat.children[node] if possible[child]]
        if flat.kind[node] == "action":
            least[node] = flat.utility[node]
        elif flat.kind[node] == "xor":
            least[node] = max(below, default=top)
        else:
            least[node] = min(below, default=top)
    return least[0]
