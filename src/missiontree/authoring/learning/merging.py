"""Parts of a tree that do the same with each of a list: as steps of a method they are one step, whose slot holds several."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass, field

from missiontree.mission.tree import MissionNode, MissionTree


@dataclass
class Merged:
    """
    A tree whose like parts are one.

    Parameters
    ----------
    tree
        The tree.
    sign
        What a node comes to in a method, what is below it aside; like nodes have the same.
    listed
        Ids of those who stand in a list.
    """

    tree: MissionTree
    sign: Callable[[MissionNode], Hashable]
    listed: frozenset[str]
    stands_for: dict[str, str] = field(default_factory=dict)
    """The first of its like, for each node."""
    children: dict[str, tuple[str, ...]] = field(default_factory=dict)
    """What is below the first of each kind."""

    def __post_init__(self) -> None:
        self._merge([self.tree.root.id], apart=True)

    def _merge(self, ids: Sequence[str], *, apart: bool) -> tuple[str, ...]:
        """The nodes of one level, each kind once; those of a choice stay apart."""
        kinds: dict[Hashable, list[str]] = {}
        for node_id in ids:
            alone = apart or not self._is_about_listed(node_id)
            kinds.setdefault(node_id if alone else self._whole_sign(node_id), []).append(node_id)
        for alike in kinds.values():
            self.stands_for |= dict.fromkeys(alike, alike[0])
            nodes = [self.tree.by_id[node_id] for node_id in alike]
            below = [child for node in nodes for child in node.children]
            self.children[alike[0]] = self._merge(below, apart=nodes[0].gate == "xor")
        return tuple(alike[0] for alike in kinds.values())

    def _is_about_listed(self, node_id: str) -> bool:
        node = self.tree.by_id[node_id]
        return bool(self.listed & set(node.arguments.values())) or any(map(self._is_about_listed, node.children))

    def _whole_sign(self, node_id: str) -> Hashable:
        node = self.tree.by_id[node_id]
        return self.sign(node), tuple(dict.fromkeys(self._whole_sign(child) for child in node.children))
