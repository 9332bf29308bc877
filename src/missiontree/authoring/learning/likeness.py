"""Whether two mission trees are of one structure: the same gates, routines and order, about others who stand in the same places."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from missiontree.mission.scene import Scene
from missiontree.mission.tree import MissionNode, MissionTree


def difference(one: MissionTree, other: MissionTree, scene: Scene) -> str:
    """
    The first difference in structure, in words; empty if there is none.

    A task with a single part stands for that part. Labels are not compared; entities may be others if they are so throughout, those of
    the scene excepted.

    Parameters
    ----------
    one, other
        The trees.
    scene
        The world of both, without what they introduce.
    """
    return _Comparison(_Plain(one), _Plain(other), scene).difference()


@dataclass
class _Plain:
    """A tree without tasks of a single part."""

    tree: MissionTree
    leaves: list[MissionNode] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.leaves = [node for node in self.tree.nodes if node.routine is not None]
        self._number = {leaf.id: index for index, leaf in enumerate(self.leaves)}
        self.kinds = {entity.id: entity.kind for entity in self.tree.entities}

    def below(self, node: MissionNode) -> list[MissionNode]:
        return [self.only(self.tree.by_id[child]) for child in node.children]

    def only(self, node: MissionNode) -> MissionNode:
        while len(node.children) == 1:
            node = self.tree.by_id[node.children[0]]
        return node

    def under(self, node_id: str) -> frozenset[int]:
        """Numbers of the leaves of a node."""
        waiting, found = [node_id], set()
        while waiting:
            node = self.tree.by_id[waiting.pop()]
            waiting += node.children
            if node.routine is not None:
                found.add(self._number[node.id])
        return frozenset(found)

    def until(self) -> set[tuple[frozenset[int], frozenset[int]]]:
        return {(self.under(link.first), self.under(link.second)) for link in self.tree.links if link.kind == "until"}

    def order(self) -> set[tuple[int, int]]:
        """
        Which leaf ends before which other starts, all that follows included.

        Nothing follows by way of what may not be done, and there is no order among ways of which only one is taken.
        """
        direct: dict[int, set[int]] = {}
        for link in self.tree.links:
            if link.kind == "precedence":
                for first in self.under(link.first):
                    direct.setdefault(first, set()).update(self.under(link.second))
        certain = {index for index, leaf in enumerate(self.leaves) if self._is_certain(leaf)}
        pairs: set[tuple[int, int]] = set()
        for start in direct:
            waiting = [start]
            while waiting:
                here = waiting.pop()
                for following in direct.get(here, ()):
                    if (start, following) not in pairs:
                        pairs.add((start, following))
                        waiting += [following] if following in certain else []
        return {pair for pair in pairs if self._may_both_be_done(*pair)}

    def _may_both_be_done(self, first: int, second: int) -> bool:
        one, other = self.leaves[first], self.leaves[second]
        above = set(self.tree.ancestors(one.id))
        fork = next(node for node in self.tree.ancestors(other.id) if node in above)
        return self.tree.by_id[fork].gate != "xor"

    def _is_certain(self, leaf: MissionNode) -> bool:
        return all(self.tree.by_id[above].gate != "xor" for above in self.tree.ancestors(leaf.id))

    def shown(self, number: int) -> str:
        return repr(self.leaves[number].label)


@dataclass
class _Comparison:
    one: _Plain
    other: _Plain
    scene: Scene
    same: dict[str, str] = field(default_factory=dict)

    def difference(self) -> str:
        found = next(self._of_nodes(), "")
        if found:
            return found
        ours, theirs = self.one.order(), self.other.order()
        for pairs, where in ((ours - theirs, "is missing"), (theirs - ours, "is added")):
            for first, second in sorted(pairs)[:1]:
                return f"the order {self.one.shown(first)} before {self.one.shown(second)} {where}"
        if self.one.until() != self.other.until():
            return "what lasts until something else ends is not the same"
        return ""

    def _of_nodes(self) -> Iterator[str]:
        waiting = [(self.one.only(self.one.tree.root), self.other.only(self.other.tree.root))]
        while waiting:
            one, other = waiting.pop()
            if one.routine != other.routine or one.gate != other.gate:
                yield f"{_told(other)} stands where {_told(one)} was"
                return
            ours, theirs = self.one.below(one), self.other.below(other)
            if len(ours) != len(theirs):
                yield f"{other.label!r} has {_listed(theirs)} where {one.label!r} had {_listed(ours)}"
                return
            if one.routine is not None and (found := self._of_leaves(one, other)):
                yield found
                return
            waiting += reversed(list(zip(ours, theirs, strict=True)))

    def _of_leaves(self, one: MissionNode, other: MissionNode) -> str:
        if set(one.arguments) != set(other.arguments) or set(one.resources or ()) != set(other.resources or ()):
            return f"{_told(other)} stands where {_told(one)} was, with other arguments or robots"
        for argument, ours in one.arguments.items():
            theirs = other.arguments[argument]
            if (ours in self.scene.by_id or theirs in self.scene.by_id) and ours != theirs:
                return f"{_told(other)} is about {theirs}, {_told(one)} about {ours}"
            if self._base(self.one, ours) != self._base(self.other, theirs):
                return f"{theirs} is of another kind than {ours}"
            if self.same.setdefault(ours, theirs) != theirs or list(self.same.values()).count(theirs) > 1:
                return f"{_told(other)} is about {theirs}, which is not who {_told(one)} is about"
        return ""

    def _base(self, plain: _Plain, entity: str) -> str:
        return self.scene.base_kind(plain.kinds[entity]) if entity in plain.kinds else entity


def _told(node: MissionNode) -> str:
    return repr(node.label) if node.routine is not None else f"{node.label!r} ({node.gate})"


def _listed(nodes: list[MissionNode]) -> str:
    return f"{len(nodes)} part{'s' if len(nodes) != 1 else ''} ({', '.join(repr(node.label) for node in nodes)})"
