"""What answers show of a tree: an outline, and the state that the next call needs."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from missiontree.authoring.links import name_of_kind
from missiontree.mission.reason import Reason
from missiontree.mission.times import words_of_times
from missiontree.mission.tree import MissionNode, MissionTree

MOST_SHOWN = 500
_MOST_LEAVES = 50


def outline(tree: MissionTree) -> str:
    """The tree as an indented list, a node to a line, then the links."""
    level = {tree.root.id: 0}
    lines = []
    for node in tree.nodes:
        level |= dict.fromkeys(node.children, level[node.id] + 1)
        gate = f" [{node.gate.upper()}]" if node.gate else " [open]" if node.routine is None else ""
        only = f" only {', '.join(node.resources)}" if node.resources is not None else ""
        times = "".join(f", {word}" for word in words_of_times(node.release_s, node.deadline_s))
        lines.append(f"{'  ' * level[node.id]}- {' '.join(node.label.split())} ({node.id}){gate}{only}{times}")
    lines += [f"{name_of_kind(link.kind)}: {link.first} -> {link.second}" for link in tree.links]
    if len(lines) > MOST_SHOWN:
        lines = [*lines[:MOST_SHOWN], f"... and {len(lines) - MOST_SHOWN} more lines"]
    return "\n".join(lines)


def named(nodes: Iterable[MissionNode]) -> list[dict[str, str]]:
    """Ids and labels."""
    return [{"id": node.id, "label": node.label} for node in nodes]


def state_of(tree: MissionTree) -> dict[str, Any]:
    """What stands open: the next call's work."""
    leaves = tree.open_leaves
    state: dict[str, Any] = {"open_leaves": [leaf.id for leaf in leaves[:_MOST_LEAVES]], "nodes": len(tree.nodes)}
    return state | ({"open_leaves_not_shown": len(leaves) - _MOST_LEAVES} if len(leaves) > _MOST_LEAVES else {})


def told(reasons: Iterable[Reason]) -> list[dict[str, str]]:
    """Findings as plain data."""
    return [
        {"rule": r.rule, "severity": r.severity, "node": r.node, "message": r.message, "hint": r.hint} for r in reasons
    ]
