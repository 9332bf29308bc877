"""Whether the precedence of a tree in columns can be kept at all."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain
from typing import Any

from missiontree.formats.parsed import Parsed
from missiontree.formats.place import found
from missiontree.mission.columns import TreeColumns
from missiontree.mission.precedence import EventGraph

ACCEPTED = "[before, after]: two nodes neither of which stands below the other"


def refuse_impossible_order(parsed: Parsed, tree: TreeColumns) -> None:
    """
    Refuse pairs of no meaning, and a circle.

    Doing the tree from its first child to its last keeps every pair whose first node is wholly before the second. Only where some
    pair points the other way is a circle looked for, since that takes the whole graph.

    Raises
    ------
    InputError
        With the pair.
    """
    pairs: Any = tree.precedence
    if not isinstance(pairs, list):
        raise parsed.refusal(f"{found(pairs)} stands here", ("precedence",), "a list of pairs of nodes")
    parent, nodes = tree.parent, len(tree.parent)
    if not _are_pairs(pairs, nodes):
        _refuse_first(parsed, pairs, nodes)
    # Pairs that are not two children of one node, the first of them first.
    crossing = [
        place for place, (before, after) in enumerate(pairs) if not (before < after and parent[before] == parent[after])
    ]
    if crossing:
        _look_closer(parsed, tree, crossing)


def _are_pairs(pairs: list[Any], nodes: int) -> bool:
    """Whether all are pairs of nodes; by columns, for there may be a million."""
    if not (set(map(type, pairs)) <= {list} and set(map(len, pairs)) <= {2}):
        return False
    named = list(chain.from_iterable(pairs))
    return not named or (set(map(type, named)) == {int} and min(named) >= 0 and max(named) < nodes)


def _refuse_first(parsed: Parsed, pairs: list[Any], nodes: int) -> None:
    for place, pair in enumerate(pairs):
        if type(pair) is not list or len(pair) != 2 or type(pair[0]) is not int or type(pair[1]) is not int:
            raise parsed.refusal(f"{found(pair)} stands here", ("precedence", place), ACCEPTED)
        before, after = pair
        if not (0 <= before < nodes and 0 <= after < nodes):
            message = f"the pair [{before}, {after}] names a node that there is not; there are {nodes}"
            raise parsed.refusal(message, ("precedence", place), ACCEPTED)


def _look_closer(parsed: Parsed, tree: TreeColumns, crossing: Sequence[int]) -> None:
    first, last = _spans(tree.parent)
    backward = False
    for place in crossing:
        before, after = tree.precedence[place]
        if first[before] <= first[after] <= last[before] or first[after] <= first[before] <= last[after]:
            message = f"the pair [{before}, {after}] names " + (
                "one node twice" if before == after else "two nodes of which one stands below the other"
            )
            raise parsed.refusal(message, ("precedence", place), ACCEPTED)
        backward |= first[before] > first[after]
    if backward:
        _refuse_circle(parsed, tree)


def _spans(parent: Sequence[int]) -> tuple[list[int], list[int]]:
    """Place of each node when a tree is read from the first child to the last, and the last place below it."""
    nodes = len(parent)
    size = [1] * nodes
    for node in range(nodes - 1, 0, -1):
        size[parent[node]] += size[node]
    first, free = [0] * nodes, [1] * nodes  # free: where the next child goes
    for node in range(1, nodes):
        above = parent[node]
        first[node] = free[above]
        free[above] += size[node]
        free[node] = first[node] + 1
    return first, [start + count - 1 for start, count in zip(first, size, strict=True)]


def _refuse_circle(parsed: Parsed, tree: TreeColumns) -> None:
    circle = EventGraph(tree.parent, ((before, after, "precedence") for before, after in tree.precedence)).cycle()
    if circle is None:
        return
    within = set(circle)
    place = next(place for place, pair in enumerate(tree.precedence) if within.issuperset(pair))
    shown = ", ".join(map(str, circle[:8])) + (", …" if len(circle) > 8 else "")
    message = f"the precedence runs in a circle, so no order keeps it; in the circle are the nodes {shown}"
    raise parsed.refusal(message, ("precedence", place), "an order that can be kept", "Remove a pair of these nodes.")
