"""How much each part of a mission counts, and what a mission is without some of its parts."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from fractions import Fraction

from missiontree.errors import InputError
from missiontree.explaining.naming import nodes_named
from missiontree.mission.routine import RoutineLibrary
from missiontree.mission.tree import MissionNode, MissionTree
from missiontree.routines.open_ended import pointless_until

MOST_STEPS = 10**8
"""Steps that the weight of a mission may be counted in, so that every sum stays exact."""


def parts_of(tree: MissionTree) -> tuple[MissionNode, ...]:
    """Parts that can be left out, in tree order: children of an AND that has others."""
    return tuple(
        tree.by_id[child]
        for node in tree.nodes
        if node.gate == "and" and len(node.children) > 1
        for child in node.children
    )


def weights_of(tree: MissionTree, stated: Mapping[str, float]) -> dict[str, Fraction]:
    """
    Weight of every node.

    Parameters
    ----------
    tree
        The mission.
    stated
        Weights by the name of a part: id, label or call of a node.

    Raises
    ------
    InputError
        If a name means no part of the mission, or several.
    """
    own = _stated(tree, stated)
    size: dict[str, Fraction] = {}
    for node in reversed(tree.nodes):
        below = [size[child] for child in node.children]
        size[node.id] = own.get(
            node.id, sum(below, Fraction()) if node.gate == "and" else min(below, default=Fraction(1))
        )
    found = {tree.root.id: size[tree.root.id]}
    for node in tree.nodes:
        below_all = sum((size[child] for child in node.children), Fraction())
        for child in node.children:
            share = size[child] / below_all if node.gate == "and" else Fraction(1)
            found[child] = found[node.id] * share
    return found


def _stated(tree: MissionTree, stated: Mapping[str, float]) -> dict[str, Fraction]:
    meant = [(nodes_named(name, tree, "parts"), weight) for name, weight in stated.items()]
    found: dict[str, Fraction] = {}
    for nodes, weight in sorted(
        meant, key=lambda one: -len(one[0])
    ):  # what names one node goes before what names several
        for node in nodes:
            found[node.id] = Fraction(str(weight))
    return found


def in_steps(weights: Mapping[str, Fraction], root: str) -> dict[str, int]:
    """
    The same weights as whole numbers.

    Raises
    ------
    InputError
        If they differ by too little for that.
    """
    scale = 1
    for weight in weights.values():
        scale = scale * weight.denominator // _common(scale, weight.denominator)
    if weights[root] * scale > MOST_STEPS:
        raise InputError(
            "the weights of parts differ by too little to be added up exactly",
            where="parts",
            accepted="weights such as 1, 2.5 or 10",
        )
    return {node: int(weight * scale) for node, weight in weights.items()}


def _common(first: int, second: int) -> int:
    while second:
        first, second = second, first % second
    return first


def topmost(tree: MissionTree, left_out: Collection[str]) -> tuple[str, ...]:
    """The same parts left out, with a task in place of all its children, and nothing below another; in tree order."""
    gone = set(left_out)
    for node in reversed(tree.nodes):
        if node.gate == "and" and all(child in gone for child in node.children):
            gone.add(node.id)
    return tuple(node.id for node in tree.nodes if node.id in gone and gone.isdisjoint(tree.ancestors(node.id)))


def without_parts(tree: MissionTree, left_out: Collection[str], library: RoutineLibrary) -> MissionTree:
    """What is left of a mission; links to what is left out vanish with it, and so do until links from what then ends by itself."""
    kept = [
        node for node in tree.nodes if node.id not in left_out and set(left_out).isdisjoint(tree.ancestors(node.id))
    ]
    names = {node.id for node in kept}
    rest = replace(
        tree,
        nodes=tuple(
            replace(node, children=tuple(child for child in node.children if child in names)) if node.children else node
            for node in kept
        ),
        links=tuple(link for link in tree.links if link.first in names and link.second in names),
    )
    return replace(rest, links=tuple(link for link in rest.links if not pointless_until(rest, link, library)))
