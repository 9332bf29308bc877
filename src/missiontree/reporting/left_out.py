"""What a plan for a part of a mission leaves out, in words."""

from __future__ import annotations

from missiontree.mission.partial import Partial
from missiontree.mission.reason import Reason


def parts_left_out(partial: Partial) -> tuple[Reason, ...]:
    """A reason for each part that is left out."""
    return tuple(
        Reason(
            rule="part_left_out",
            message=f"{_label(partial, one.node)} is not done{_weight(one.weight)}.",
            node=one.node,
        )
        for one in partial.left_out
    )


def known_of_larger(partial: Partial) -> str:
    """How much of the mission is done, and whether more of it can be."""
    leaves = [node for node in partial.whole.nodes if not node.children]
    unweighted = partial.total == len(leaves) and partial.kept == round(partial.kept)
    kind = "routines" if all(leaf.routine is not None for leaf in leaves) else "parts"
    what = f"{len(leaves)} {kind}" if unweighted else f"{partial.total:g} by weight"
    if partial.claim == "proven":
        return f"{partial.kept:g} of {what} can be done. Proven: no larger part can."
    return f"{partial.kept:g} of {what} can be done. A larger part is not excluded."


def _label(partial: Partial, node_id: str) -> str:
    node = partial.whole.by_id.get(node_id)
    return node.label if node is not None else node_id


def _weight(weight: float) -> str:
    return "" if weight == 1 else f" (weight {weight:g})"
