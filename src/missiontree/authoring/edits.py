"""Changes of a mission tree: each makes a new tree out of an old one, well-formed by birth."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from missiontree.authoring.answer import refuse
from missiontree.mission.entity import Entity
from missiontree.mission.tree import Gate, Link, MissionNode, MissionTree


def with_children(tree: MissionTree, parent: str, children: Sequence[MissionNode], gate: Gate) -> MissionTree:
    """The tree with further children below a task, after those it has."""
    end = _end_of_subtree(tree, parent)
    above = tree.by_id[parent]
    grown = replace(above, children=(*above.children, *(child.id for child in children)), gate=gate)
    if len(grown.children) == 1:
        grown = replace(grown, gate="and")  # with a single child both gates mean the same; it reads AND
    nodes = [grown if node.id == parent else node for node in tree.nodes]
    return replace(tree, nodes=(*nodes[:end], *children, *nodes[end:]))


def without(tree: MissionTree, node: str) -> tuple[MissionTree, tuple[Link, ...]]:
    """The tree without a node and all below it, and the links that fell with them. The node is not the root."""
    start = next(index for index, known in enumerate(tree.nodes) if known.id == node)
    gone = {known.id for known in tree.nodes[start : _end_of_subtree(tree, node)]}
    above = tree.by_id[tree.parent[node]]
    left = tuple(child for child in above.children if child != node)
    gate: Gate | None = above.gate if len(left) > 1 else "and" if left else None
    shrunk = replace(above, children=left, gate=gate)
    nodes = tuple(shrunk if known.id == above.id else known for known in tree.nodes if known.id not in gone)
    dropped = tuple(link for link in tree.links if link.first in gone or link.second in gone)
    links = tuple(link for link in tree.links if not (link.first in gone or link.second in gone))
    return replace(tree, nodes=nodes, links=links), dropped


def with_links(tree: MissionTree, links: Iterable[Link]) -> MissionTree:
    """The tree with further links."""
    return replace(tree, links=(*tree.links, *links))


def with_entities(tree: MissionTree, entities: Iterable[Entity]) -> MissionTree:
    """The tree with further entities."""
    return replace(tree, entities=(*tree.entities, *entities))


def with_times(tree: MissionTree, node: str, release_s: float, deadline_s: float | None) -> MissionTree:
    """
    The tree with a node's times in place of those it has.

    Raises
    ------
    RefusalError
        ``times_conflict``, if the deadline lies before the release time.
    """
    try:
        timed = replace(tree.by_id[node], release_s=release_s, deadline_s=deadline_s)
    except ValueError as error:
        hint = "Give a deadline no earlier than the release time, or leave one of them out."
        raise refuse("times_conflict", f"{error}", node=node, hint=hint) from error
    return replace(tree, nodes=tuple(timed if known.id == node else known for known in tree.nodes))


def depth_of(tree: MissionTree, node: str) -> int:
    """Level of a node; the root stands on level 1."""
    return 1 + sum(1 for _ in tree.ancestors(node))


def _end_of_subtree(tree: MissionTree, node: str) -> int:
    """Index after the last node below a node, in preorder."""
    last = node
    while tree.by_id[last].children:
        last = tree.by_id[last].children[-1]
    return next(index for index, known in enumerate(tree.nodes) if known.id == last) + 1
