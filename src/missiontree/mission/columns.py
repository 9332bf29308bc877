"""A foreign mission tree as columns of numbers, without a value per node: what trees of millions of nodes are kept in."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import overload

from missiontree.mission.estimate import Weights
from missiontree.mission.grounded import NodeKind

LEAF, AND, XOR = range(3)
KINDS: tuple[NodeKind, NodeKind, NodeKind] = ("action", "and", "xor")
"""What a grounded tree calls these."""
BUDGET = "consumption"
"""Name of the budget that every leaf uses and every robot is limited in."""
WEIGHTS = Weights(alpha=1, beta=0, gamma=1)
"""With these, an action's utility is its column's: one above 0 is a quality, one below 0 a cost."""


@dataclass(frozen=True)
class TreeColumns:
    """
    A tree over single robots: a leaf is one action of one robot, and a role of its own.

    Unlike other values it is not checked at birth, but by whoever reads it
    (:func:`missiontree.formats.importers.tree_json.columns_of`); nobody may change the columns.

    Parameters
    ----------
    kind
        0 for a leaf, 1 for an AND, 2 for an XOR.
    parent
        Smaller than the node's own index; -1 for the root.
    robot
        Of each leaf, from 0; 0 elsewhere.
    utility
        Of each leaf, any whole number; 0 elsewhere.
    duration
        Of each leaf, in whole seconds, at least 0; 0 elsewhere.
    consumption
        What each leaf uses of its robot's budget, at least 0; 0 elsewhere.
    precedence
        (before, after): pairs of nodes, in an order that can be kept.
    disjoint
        ANDs whose children are to be done by different robots.
    robots
        How many there are.
    budget
        What each robot may use; None if nothing limits them.
    count
        How many equal robots each ``robot`` stands for, at least 1; None (default) if each is a single one.
    names
        What people call each node; None (default) for "leaf 5" and the like.
    robot_names
        Id of each robot; None (default) for ``robot-0`` and so on.
    """

    kind: Sequence[int]
    parent: Sequence[int]
    robot: Sequence[int]
    utility: Sequence[int]
    duration: Sequence[int]
    consumption: Sequence[int]
    precedence: Sequence[Sequence[int]]
    disjoint: Sequence[int]
    robots: int
    budget: Sequence[int] | None
    count: Sequence[int] | None = None
    names: Sequence[str] | None = None
    robot_names: Sequence[str] | None = None

    def label(self, node: int) -> str:
        """What people call a node."""
        if self.names is not None:
            return self.names[node]
        return f"{_WORDS[self.kind[node]]} {node}"

    def robot_id(self, robot: int) -> str:
        """The type that consists of one robot."""
        return f"robot-{robot}" if self.robot_names is None else self.robot_names[robot]

    def apart(self) -> list[tuple[int, int]]:
        """Pairs of nodes whose robots are to differ: all pairs of children of every AND in ``disjoint``."""
        wanted = dict.fromkeys(self.disjoint)
        below: dict[int, list[int]] = {node: [] for node in wanted}
        if wanted:
            for node, parent in enumerate(self.parent):
                if parent in wanted:
                    below[parent].append(node)
        return [
            (children[one], other)
            for children in below.values()
            for one in range(len(children))
            for other in children[one + 1 :]
        ]


_WORDS = ("leaf", "AND", "XOR")


class Labels(Sequence[str]):
    """
    What people call the nodes of a tree, made when somebody asks; equal to any sequence of the same words.

    Parameters
    ----------
    columns
        The tree.
    """

    __slots__ = ("_columns",)

    def __init__(self, columns: TreeColumns) -> None:
        self._columns = columns

    def __len__(self) -> int:
        return len(self._columns.kind)

    @overload
    def __getitem__(self, node: int) -> str: ...
    @overload
    def __getitem__(self, node: slice) -> tuple[str, ...]: ...
    def __getitem__(self, node: int | slice) -> str | tuple[str, ...]:
        nodes = range(len(self))[node]
        return self._columns.label(nodes) if isinstance(nodes, int) else tuple(map(self._columns.label, nodes))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Sequence) and tuple(self) == tuple(other)

    __hash__ = None  # type: ignore[assignment]
