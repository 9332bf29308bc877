"""An AND/XOR tree as three columns of integers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from importlib import import_module
from itertools import compress
from typing import Any

from missiontree.allocation.arrays.column import Column, is_array
from missiontree.mission.columns import LEAF, XOR


@dataclass(frozen=True, slots=True, eq=False)
class TreeArrays:
    """
    A tree in which nothing couples the choices: columns over nodes, parents before children, siblings in order.

    Arrays are taken as they are if they hold 64-bit integers, and must not be changed afterwards.

    Parameters
    ----------
    kind
        0 for a leaf, 1 for an AND, 2 for an XOR. An XOR without children cannot be done; an AND without children is done already.
    parent
        Index of the parent, smaller than the node's own; -1 for node 0, the root.
    utility
        Of each leaf, any whole number, in a unit of the caller's; 0 elsewhere.

    Raises
    ------
    ValueError
        If these are no such columns; names the first node that is wrong.
    """

    kind: Column
    parent: Column
    utility: Column

    def __post_init__(self) -> None:
        for name in ("kind", "parent", "utility"):
            column = getattr(self, name)
            if is_array(column):
                column = _whole_array(name, column)
            elif not set(map(type, column)) <= {int}:
                raise ValueError(f"{name} must hold whole numbers only.")
            object.__setattr__(self, name, column)
        if not len(self.kind) == len(self.parent) == len(self.utility):
            raise ValueError(
                f"columns must be of one length, got {len(self.kind)}, {len(self.parent)} and {len(self.utility)}."
            )
        if not len(self.kind):
            raise ValueError("a tree has at least one node.")
        if self.parent[0] != -1:
            raise ValueError(f"node 0 is the root and has parent -1, got {self.parent[0]}.")
        (_check_arrays if self.in_arrays else _check_lists)(self)

    def __len__(self) -> int:
        return len(self.kind)

    @property
    def in_arrays(self) -> bool:
        """Whether all columns are NumPy arrays."""
        return all(is_array(column) for column in (self.kind, self.parent, self.utility))

    @property
    def span(self) -> int:
        """No way through the tree earns more than this, or less than its negative."""
        utility: Any = self.utility
        if is_array(utility):
            return len(utility) * max(int(utility.max()), -int(utility.min()))
        return sum(map(abs, utility))


def _whole_array(name: str, column: Any) -> Any:
    np = import_module("numpy")
    if column.ndim != 1 or column.dtype.kind not in "iu":
        raise ValueError(f"{name} must hold whole numbers in one dimension, got {column.dtype} in {column.ndim}.")
    if column.dtype.kind == "u" and len(column) and int(column.max()) >= 1 << 63:
        raise ValueError(f"{name} must fit into 64 bits with a sign, got {int(column.max())}.")
    return np.ascontiguousarray(column, dtype=np.int64)


def _check_arrays(tree: Any) -> None:
    np = import_module("numpy")
    kind, parent, utility = tree.kind, tree.parent, tree.utility
    _refuse(tree, np.flatnonzero((kind < LEAF) | (kind > XOR)), "kind")
    late = (parent < 0) | (parent >= np.arange(len(parent)))
    late[0] = False
    _refuse(tree, np.flatnonzero(late), "parent")
    _refuse(tree, 1 + np.flatnonzero(kind[parent[1:]] == LEAF), "leaf")
    _refuse(tree, np.flatnonzero((kind != LEAF) & (utility != 0)), "utility")


def _check_lists(tree: Any) -> None:
    kind, parent, utility = tree.kind, tree.parent, tree.utility
    nodes = range(len(kind))
    if not set(kind) <= {0, 1, 2}:
        _refuse(tree, [node for node in nodes if kind[node] not in {0, 1, 2}], "kind")
    _refuse(tree, [node for node, above in enumerate(parent) if not 0 <= above < node and node], "parent")
    _refuse(tree, [node for node, above in enumerate(parent) if node and kind[above] == LEAF], "leaf")
    _refuse(tree, [node for node in compress(nodes, kind) if utility[node]], "utility")


def _refuse(tree: Any, wrong: Sequence[int], rule: str) -> None:
    if len(wrong):
        node = int(wrong[0])
        above = int(tree.parent[node])
        raise ValueError(
            {
                "kind": f"node {node} is of kind {int(tree.kind[node])}; accepted are 0 (leaf), 1 (AND) and 2 (XOR).",
                "parent": f"node {node} has parent {above}; parents come before children, and only node 0 has parent -1.",
                "leaf": f"node {node} has parent {above}, which is a leaf.",
                "utility": f"node {node} is a gate with utility {int(tree.utility[node])}; only leaves have one.",
            }[rule]
        )
