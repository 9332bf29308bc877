"""Changes that cannot be enough, seen without planning: a routine that no robot can do is not mended by time or energy."""

from __future__ import annotations

from missiontree.explaining.case import Case
from missiontree.explaining.changes.needs import Needs
from missiontree.mission.change import Change, ChangeKind
from missiontree.mission.grounded import Grounding
from missiontree.mission.tree import MissionNode

UNOFFERING: frozenset[ChangeKind] = frozenset(
    {
        "take_off_require",
        "end_anywhere",
        "drop_link",
        "extend_deadline",
        "move_release",
        "extend_stay",
        "come_earlier",
        "raise_capacity",
        "raise_total",
        "raise_stock",
    }
)
"""Kinds that offer no routine to anybody to whom it was not offered before."""


class Pointless:
    """
    Knows which routines of a mission somebody can do.

    Parameters
    ----------
    case
        The mission.
    grounding
        The mission over its fleet; None if it could not be grounded, then nothing is pointless.
    needs
        What its routines need.
    """

    def __init__(self, case: Case, grounding: Grounding | None, needs: Needs) -> None:
        self._case, self._needs = case, needs
        self._unable: frozenset[str] = frozenset()
        if grounding is not None:
            tree = grounding.tree
            empty = (node for index, node in enumerate(tree.nodes) if node.kind == "xor" and not tree.children[index])
            self._unable = frozenset(node.source for node in empty if node.source is not None)
        self._stuck = bool(self._unable) and not self._can("")

    def __call__(self, change: Change) -> bool:
        """Whether a change alone cannot be enough."""
        if not self._stuck:
            return False
        if change.kind == "drop_part":  # to leave out one part takes no routine of another to anybody new
            return not self._can(change.target)
        budget = change.kind == "raise_limit" and change.name not in self._needs.at_least
        return budget or change.kind in UNOFFERING

    def _can(self, dropped: str) -> bool:
        """Whether all routines that are needed without a node have somebody, whatever the limits."""
        tree = self._case.tree
        can: dict[str, bool] = {}
        for node in reversed(tree.nodes):
            below = [can[child] for child in node.children if child != dropped]
            can[node.id] = self._able(node, below)
        return can[tree.root.id]

    def _able(self, node: MissionNode, below: list[bool]) -> bool:
        if node.routine is not None:
            return node.id not in self._unable
        return any(below) if node.gate == "xor" and below else all(below)
