"""Parts of a mission that can be left out."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from missiontree.explaining.case import Case
from missiontree.explaining.changes.needs import Needs
from missiontree.mission.change import Change
from missiontree.mission.tree import MissionNode, MissionTree


def candidates(case: Case, needs: Needs) -> Iterator[Change]:
    """Children of an AND that has others: without an option of a choice the choice is only narrower, without all nothing is left."""
    for node in case.tree.nodes[1:]:
        parent = case.tree.by_id[case.tree.parent[node.id]]
        if parent.gate == "and" and len(parent.children) > 1:
            yield Change(kind="drop_part", target=node.id)


def drop_part(case: Case, change: Change) -> Case:
    """The tree without a node, all below it, and all links to these."""
    return replace(case, tree=without(case.tree, change.target))


def without(tree: MissionTree, node_id: str) -> MissionTree:
    """
    A tree without a node and all below it.

    Raises
    ------
    ValueError
        If nothing would be left.
    """
    gone = {node.id for node in tree.nodes if tree.contains(node_id, node.id)}
    above = tree.parent.get(node_id)
    while above is not None and not set(tree.by_id[above].children) - gone:  # a task without children is no task
        gone.add(above)
        above = tree.parent.get(above)
    if tree.root.id in gone:
        raise ValueError("nothing of the mission would be left.")
    nodes = tuple(_kept(node, gone) for node in tree.nodes if node.id not in gone)
    links = tuple(link for link in tree.links if link.first not in gone and link.second not in gone)
    return replace(tree, nodes=nodes, links=links)


def _kept(node: MissionNode, gone: set[str]) -> MissionNode:
    children = tuple(child for child in node.children if child not in gone)
    gate = "and" if len(children) == 1 else node.gate
    return node if children == node.children else replace(node, children=children, gate=gate)


def drop_part_words(case: Case, change: Change) -> str:
    """As an order."""
    return f'leave out "{case.tree.by_id[change.target].label}"'


def routines_below(case: Case, node_id: str) -> int:
    """How many routines a node holds."""
    return sum(node.routine is not None and case.tree.contains(node_id, node.id) for node in case.tree.nodes)
