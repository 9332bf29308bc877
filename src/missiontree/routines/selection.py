"""Which nodes of a mission tree can be selected together, and which are whenever another is."""

from __future__ import annotations

from missiontree.mission.tree import MissionTree

Turns = frozenset[tuple[int, int]]


class CoSelection:
    """
    The XOR turns above each node: which child of which XOR must be taken for the node to be selected.

    Parameters
    ----------
    tree
        The mission tree; nodes are numbered as in ``tree.nodes``.
    """

    def __init__(self, tree: MissionTree) -> None:
        number = {node.id: index for index, node in enumerate(tree.nodes)}
        self.turns: list[Turns] = []
        for index, node in enumerate(tree.nodes):
            above = number.get(tree.parent.get(node.id, ""), -1)
            turns = self.turns[above] if above >= 0 else frozenset()
            if above >= 0 and tree.nodes[above].gate == "xor" and len(tree.nodes[above].children) > 1:
                turns |= {(above, index)}
            self.turns.append(turns)

    def exclusive(self, first: int, second: int) -> bool:
        """Whether the two stand below different children of one XOR."""
        taken = dict(self.turns[first])
        return any(taken.get(xor, child) != child for xor, child in self.turns[second])

    def implies(self, given: int, other: int) -> bool:
        """Whether the other node is selected whenever the given one is."""
        return self.turns[other] <= self.turns[given]
