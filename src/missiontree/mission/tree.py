"""The mission tree as authored: what shall be achieved, independent of the fleet."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal

from missiontree.mission.entity import Entity
from missiontree.mission.times import check_times
from missiontree.mission.value import Id, NonNegative, Value, require_unique

Gate = Literal["and", "xor"]
LinkKind = Literal["precedence", "same_robot", "different_robot", "until", "hand_over"]
LINK_KINDS: tuple[LinkKind, ...] = ("precedence", "same_robot", "different_robot", "until", "hand_over")
IN_ORDER: frozenset[LinkKind] = frozenset({"precedence", "hand_over"})
"""Kinds of links whose first node has ended when the second starts."""
APART: frozenset[LinkKind] = frozenset({"different_robot", "hand_over"})
"""Kinds of links whose nodes are done by different robots."""
MUTUAL: frozenset[LinkKind] = frozenset({"same_robot", "different_robot"})
"""Kinds of links that say the same the other way round."""


@dataclass(frozen=True, slots=True)
class Link(Value):
    """
    A relation between two nodes neither of which contains the other. It binds when both are selected.

    Parameters
    ----------
    first, second
        Node ids.
    kind
        ``precedence``: the first ends before the second starts. ``same_robot``: all roles of both are filled by one robot.
        ``different_robot``: no robot fills a role of both. ``until``: the open-ended actions of the first last until the
        second ends. ``hand_over``: the last action of the first ends when the first action of the second starts, at one
        place, by different robots.
    """

    first: Id
    second: Id
    kind: LinkKind = "precedence"


@dataclass(frozen=True, slots=True, kw_only=True)
class MissionNode(Value):
    """
    A task, which has a gate over its children, or a routine, which is a leaf.

    Parameters
    ----------
    id
        Name, unique in the tree.
    label
        What people read, such as "Locate the Lost Child".
    gate
        ``and`` or ``xor``; None for a routine, and for a task that has no children yet. One child reads ``and``.
    children
        Ids of the children, in order.
    routine
        Id of the routine; None for a task.
    arguments
        Argument name to entity id.
    resources
        Robot types allowed; None (default) means all.
    release_s
        No selected action at or below the node starts earlier; seconds from the mission's start, at least 0. Default 0. A robot may
        be on its way before.
    deadline_s
        All selected actions at or below the node have ended by then; seconds from the mission's start, at least 0. None (default) means
        no deadline.
    """

    id: Id
    label: str
    gate: Gate | None = None
    children: tuple[Id, ...] = ()
    routine: Id | None = None
    arguments: Mapping[Id, Id] = field(default_factory=dict)
    resources: tuple[Id, ...] | None = None
    release_s: NonNegative = 0.0
    deadline_s: NonNegative | None = None

    def _check(self) -> None:
        check_times(f"node {self.id!r}", self.release_s, self.deadline_s)
        if self.routine is not None and (self.gate is not None or self.children):
            raise ValueError(f"node {self.id!r} is a routine; routines have no children.")
        if self.routine is None and (self.arguments or self.resources is not None):
            raise ValueError(f"node {self.id!r} is a task; arguments and resources belong to routines.")
        if bool(self.children) != (self.gate is not None):
            raise ValueError(f"node {self.id!r} needs a gate exactly if it has children.")


@dataclass(frozen=True, kw_only=True)
class MissionTree(Value):
    """
    A well-formed tree. It may still be unfinished: a task without children is an *open leaf*.

    Parameters
    ----------
    objective
        The mission in words.
    nodes
        In preorder, the root first.
    links
        Precedence and the other relations.
    entities
        Entities that the author introduced because the scene has none such.
    """

    objective: str
    nodes: tuple[MissionNode, ...]
    links: tuple[Link, ...] = ()
    entities: tuple[Entity, ...] = ()

    def _check(self) -> None:
        if not self.nodes:
            raise ValueError("a mission tree has at least its root.")
        require_unique("node", tuple(node.id for node in self.nodes))
        require_unique("entity", tuple(entity.id for entity in self.entities))
        if [node.id for node in self._preorder()] != [node.id for node in self.nodes]:
            raise ValueError("nodes must be listed in preorder, each below exactly one parent, the root first.")
        for link in self.links:
            for end in (link.first, link.second):
                if end not in self.by_id:
                    raise ValueError(f"a {link.kind} link names {end!r}, which is not in the tree.")
            if self.contains(link.first, link.second) or self.contains(link.second, link.first):
                raise ValueError(
                    f"a {link.kind} link joins {link.first!r} and {link.second!r}, of which one contains the other."
                )

    def _preorder(self) -> Iterator[MissionNode]:
        stack, seen = [self.nodes[0].id], 0
        while stack and seen <= len(self.nodes):
            node = self.by_id.get(stack.pop())
            if node is None:
                raise ValueError("a child is listed that is not among the nodes.")
            seen += 1
            yield node
            stack.extend(reversed(node.children))

    @property
    def root(self) -> MissionNode:
        """The objective's node."""
        return self.nodes[0]

    @cached_property
    def by_id(self) -> dict[str, MissionNode]:
        """Nodes by id."""
        return {node.id: node for node in self.nodes}

    @cached_property
    def parent(self) -> dict[str, str]:
        """Parent id by node id; the root has none."""
        return {child: node.id for node in self.nodes for child in node.children}

    def ancestors(self, node_id: str) -> Iterator[str]:
        """Ids above a node, nearest first."""
        while (above := self.parent.get(node_id)) is not None:
            yield above
            node_id = above

    def contains(self, outer: str, inner: str) -> bool:
        """Whether inner is outer or stands below it."""
        return outer == inner or outer in self.ancestors(inner)

    @cached_property
    def open_leaves(self) -> tuple[MissionNode, ...]:
        """Tasks without children."""
        return tuple(node for node in self.nodes if node.routine is None and not node.children)
