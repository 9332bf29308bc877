"""From when to when the nodes of a scheduled tree last, and which action decides over what a link holds back."""

from __future__ import annotations

from collections.abc import Mapping

from missiontree.mission.grounded import GroundedTree
from missiontree.mission.schedule import ScheduledAction
from missiontree.mission.tree import IN_ORDER, LinkKind


def ms(time_s: float) -> int:
    """A time in whole milliseconds, the grid of schedules."""
    return round(time_s * 1000)


class Spans:
    """
    Spans of all nodes.

    Parameters
    ----------
    tree
        The grounded tree.
    at
        Scheduled actions by leaf.

    Attributes
    ----------
    last, first
        For every node, the scheduled leaf below it that ends last, and the one that starts first; None if there is none.
    """

    def __init__(self, tree: GroundedTree, at: Mapping[int, ScheduledAction]) -> None:
        self._tree, self._at = tree, at
        self.last: list[int | None] = [None] * len(tree.nodes)
        self.first: list[int | None] = [None] * len(tree.nodes)
        for node in reversed(range(len(tree.nodes))):  # children stand after their parents
            if node in at:
                self.last[node] = self.first[node] = node
            above = tree.nodes[node].parent
            if above >= 0:
                self.last[above] = self._later(self.last[above], self.last[node])
                self.first[above] = self._sooner(self.first[above], self.first[node])

    def inherited(self, kind: LinkKind) -> dict[int, int]:
        """
        For every scheduled leaf, the action that decides over links of a kind into it or into a node above it.

        For precedence, hand-overs among it, that is the latest end of what comes before; for until, of what it lasts until.
        """
        over: list[int | None] = [None] * len(self._tree.nodes)
        for link in self._tree.links:
            if link.kind == kind or (kind == "precedence" and link.kind in IN_ORDER):
                held, by = (link.second, link.first) if kind == "precedence" else (link.first, link.second)
                over[held] = self._later(over[held], self.last[by])
        for node, given in enumerate(self._tree.nodes):
            if given.parent >= 0:
                over[node] = self._later(over[node], over[given.parent])
        return {leaf: last for leaf in self._at if (last := over[leaf]) is not None}

    def above(self, node: int) -> set[int]:
        """A node and all above it."""
        found: set[int] = set()
        while node >= 0:
            found.add(node)
            node = self._tree.nodes[node].parent
        return found

    def _later(self, first: int | None, second: int | None) -> int | None:
        given = [leaf for leaf in (first, second) if leaf is not None]
        return min(given, key=lambda leaf: (-ms(self._at[leaf].end_s), leaf), default=None)

    def _sooner(self, first: int | None, second: int | None) -> int | None:
        given = [leaf for leaf in (first, second) if leaf is not None]
        return min(given, key=lambda leaf: (ms(self._at[leaf].start_s), leaf), default=None)
