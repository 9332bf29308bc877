"""A mission tree in the notation of suites."""

from __future__ import annotations

from missiontree.evaluation.expected import Group
from missiontree.evaluation.structure import Structure, structure_of_tree
from missiontree.mission.brief import MissionBrief
from missiontree.mission.tree import MissionTree


def told(tree: MissionTree, brief: MissionBrief) -> str:
    """The tree as a suite would write it: routines and choices, then the order between routines, numbered from 1."""
    made = structure_of_tree(tree, brief)
    everybody = frozenset(brief.fleet.by_id)
    members = made.shape.members if isinstance(made.shape, Group) and made.shape.gate == "and" else (made.shape,)
    plan = "; ".join(_shown(member, made, everybody) for member in members)
    order = [
        f"{a + 1} {sign} {b + 1}" for sign, pairs in (("<", made.before), ("~", made.until)) for a, b in sorted(pairs)
    ]
    return f"{plan} | {', '.join(order)}" if order else plan


def _shown(shape: Group | int, made: Structure, everybody: frozenset[str]) -> str:
    if isinstance(shape, int):
        leaf = made.leaves[shape]
        return f"{leaf} by {', '.join(sorted(leaf.types))}" if leaf.types != everybody else str(leaf)
    return f"{shape.gate}({'; '.join(_shown(member, made, everybody) for member in shape.members)})"
