"""What a rule answers when something is wrong; the checker turns it into a Reason that bears the rule's name."""

from __future__ import annotations

from typing import NamedTuple

from missiontree.mission.grounded import GroundedTree


class Fault(NamedTuple):
    """A finding before it has its rule's name; the fields are those of :class:`missiontree.mission.reason.Reason`."""

    message: str
    node: str = ""
    robot: str = ""
    found: str = ""
    needed: str = ""


def named(tree: GroundedTree, index: int) -> str:
    """Label and index of a grounded node, or the index alone where no such node is."""
    if not 0 <= index < len(tree.nodes):
        return f"[{index}]"
    return f"{tree.nodes[index].label} [{index}]"


def role_named(tree: GroundedTree, role: int) -> str:
    """Label and index of a role, or the index alone where no such role is."""
    return f"role {tree.roles[role].label} [{role}]" if 0 <= role < len(tree.roles) else f"role [{role}]"
