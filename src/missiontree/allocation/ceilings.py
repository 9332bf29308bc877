"""
How much an alternative can be worth at most with a robot type in its team, or without some: by one sweep up the tree and one down.

Nothing that couples the robots is looked at, so these bounds cost little and hold for every alternative.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from fractions import Fraction

from missiontree.allocation.flat import Flat
from missiontree.allocation.teams import Teams
from missiontree.mission.aim import Accumulate

ANY = ""
"""Stands among types for every alternative, whoever takes part."""

Value = Callable[[int], int]
Through = list[int | None]  # by node: the most that a way through it is worth; None if there is none


def ceilings(flat: Flat, without: Collection[str], accumulate: Accumulate, above: Fraction) -> dict[str, Fraction]:
    """
    Bounds on the worth of alternatives in which certain types take no part, by a type that takes part, and by :data:`ANY`.

    Parameters
    ----------
    flat
        The problem.
    without
        Types that take no part.
    accumulate
        What an alternative is worth.
    above
        A bound that is known; means are measured from it.

    Returns
    -------
    dict
        In millionths. A type that cannot take part does not appear, and nothing does if there is no alternative.
    """
    most = 1
    if accumulate == "min":
        through = _through_least(flat, without)
    elif accumulate == "sum":
        through = _through_sums(flat, without, lambda leaf: flat.utility[leaf])
    else:
        through = _through_sums(flat, without, lambda leaf: above.denominator * flat.utility[leaf] - above.numerator)
        most = max(1, _through_sums(flat, without, lambda leaf: 1)[0] or 1)
    found: dict[str, int] = {}
    for node, worth in enumerate(through):
        if worth is not None and (node == 0 or flat.kind[node] == "action"):
            name = flat.robot_type[node] if flat.kind[node] == "action" else ANY
            for about in {name, ANY}:
                found[about] = max(found.get(about, worth), worth)
    if accumulate != "mean":
        return {name: Fraction(worth) for name, worth in found.items()}
    return {name: above + Fraction(min(0, worth), above.denominator * most) for name, worth in found.items()}


def ceiling(found: dict[str, Fraction], teams: Teams, above: Fraction) -> Fraction | None:
    """
    Bound on the worth of alternatives with one of some teams, of ceilings for all that they lack, or for less; None if there are none.

    An alternative without any action is worth 0, and has the empty team.
    """
    if not found or not teams.within <= found.keys():
        return None
    if not teams.within:
        return min(above, max(found[ANY], Fraction(0)))
    return min(above, *(found[name] for name in teams.within))


def _through_sums(flat: Flat, without: Collection[str], value: Value) -> Through:
    nodes = len(flat.kind)
    best: Through = [None] * nodes
    for node in range(nodes - 1, -1, -1):
        if flat.kind[node] == "action":
            best[node] = None if flat.robot_type[node] in without else value(node)
            continue
        below = [best[child] for child in flat.children[node]]
        there = [worth for worth in below if worth is not None]
        if flat.kind[node] == "and":
            best[node] = sum(there) if len(there) == len(below) else None
        else:
            best[node] = max(there, default=None)
    through: Through = [None] * nodes
    through[0] = best[0]
    for node in range(nodes):
        whole, own = through[node], best[node]
        if whole is None or own is None:
            continue
        for child in flat.children[node]:
            part = best[child]
            if part is not None:  # beside what is chosen at an XOR, only the best of its children counts
                through[child] = whole if flat.kind[node] == "and" else whole - own + part
    return through


def _through_least(flat: Flat, without: Collection[str]) -> Through:
    nodes = len(flat.kind)
    top = max((flat.utility[node] for node, kind in enumerate(flat.kind) if kind == "action"), default=0)
    best: Through = [None] * nodes
    for node in range(nodes - 1, -1, -1):
        if flat.kind[node] == "action":
            best[node] = None if flat.robot_type[node] in without else flat.utility[node]
            continue
        below = [best[child] for child in flat.children[node]]
        there = [worth for worth in below if worth is not None]
        if flat.kind[node] == "and":
            best[node] = min(there, default=top) if len(there) == len(below) else None
        else:
            best[node] = max(there, default=None)
    beside: Through = [None] * nodes  # the least of all that is done beside a node, at its highest
    through: Through = [None] * nodes
    beside[0], through[0] = top, best[0]
    for node in range(nodes):
        outside = beside[node]
        if outside is None or best[node] is None:
            continue
        children = [child for child in flat.children[node] if best[child] is not None]
        two = sorted((best[child] or 0, child) for child in children)[:2] if flat.kind[node] == "and" else []
        for child in children:
            others = [worth for worth, other in two if other != child]
            beside[child] = min([outside, *others])
            through[child] = min([outside, *others, best[child] or 0])
    return through
