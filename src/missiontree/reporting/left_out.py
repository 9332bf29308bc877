"""What a plan for a part of a mission leaves out, in words."""

from __future__ import annotations

from missiontree.mission.partial import Partial
from missiontree.mission.reason import Reason
from missiontree.reporting.escape import one_line

NAMED = 2
"""Parts left out that are named one by one in a line."""


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
    known = "Proven: no larger part can." if partial.claim == "proven" else "A larger part is not excluded."
    return f"{_share(partial)} can be done. {known}"


def left_out_in_short(partial: Partial) -> str:
    """``without Haul(rock)``; or how much of the mission is done, where more than two parts are left out."""
    if len(partial.left_out) > NAMED:
        return f"only {_share(partial)}"
    return f"without {' and '.join(one_line(_label(partial, one.node)) for one in partial.left_out)}"


def _share(partial: Partial) -> str:
    leaves = [node for node in partial.whole.nodes if not node.children]
    unweighted = partial.total == len(leaves) and partial.kept == round(partial.kept)
    kind = "routines" if all(leaf.routine is not None for leaf in leaves) else "parts"
    return f"{partial.kept:g} of {f'{len(leaves)} {kind}' if unweighted else f'{partial.total:g} by weight'}"


def _label(partial: Partial, node_id: str) -> str:
    node = partial.whole.by_id.get(node_id)
    return node.label if node is not None else node_id


def _weight(weight: float) -> str:
    return "" if weight == 1 else f" (weight {weight:g})"
