"""
The grounded tree: the mission expanded over a fleet and a scene, down to actions of robot types.

Allocation and everything after it know only this tree. Importers of foreign instances produce it directly. Nodes are
numbered parents before children and named by their index, so that sweeps need no recursion.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal

from missiontree.mission.estimate import Estimate
from missiontree.mission.estimator_source import Estimated
from missiontree.mission.reason import Reason
from missiontree.mission.times import Window, check_times, windows_of
from missiontree.mission.tree import LinkKind
from missiontree.mission.value import Id, Index, NonNegative, Value, require_unique

NodeKind = Literal["and", "xor", "action"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Action(Value):
    """
    A primitive action as one robot type would do it.

    Parameters
    ----------
    name
        Name of the primitive action.
    text
        What people read: "Get to Child location".
    role
        Index into the tree's roles.
    robot_type
        Type that does it.
    capability
        Capability that rates it.
    estimate
        Quality, duration and cost that allocation ranks by. The duration includes what is known beforehand of the travel, an
        approach counted from the start of the type's nearest robot.
    duration_s
        Its own working time, travel excluded, as the estimator has it: by default the type's duration model applied. For a move:
        what it takes when positions are unknown.
    uses
        What it uses of the robot's budgets, travel excluded.
    uses_at_least
        What it uses whatever happens: ``uses`` and the travel inside the role that is certain. An approach counts 0.
    travel_at_least_s
        Travel time that is certain: before it and inside the role, or of the move that it is. An approach counts 0.
    at
        Entity or place where it is done; None if anywhere. For a move: where it goes.
    moves
        It is nothing but the travel to ``at``.
    brings
        Entities that move along.
    finds
        Entity whose position is known once it succeeded.
    sync
        Joint actions carry the same number and share start and end; None if it is not joint.
    open_ended
        It lasts ``duration_s``, or until the second node of an *until* link ends.
    holds
        Shared resources that its robot holds from its start to its end, each of the scene's. Default: none.
    """

    name: Id
    text: str
    role: Index
    robot_type: Id
    capability: Id
    estimate: Estimate
    duration_s: NonNegative = 0.0
    uses: Mapping[Id, NonNegative] = field(default_factory=dict)
    uses_at_least: Mapping[Id, NonNegative] = field(default_factory=dict)
    at: Id | None = None
    moves: bool = False
    brings: tuple[Id, ...] = ()
    finds: Id | None = None
    sync: Index | None = None
    open_ended: bool = False
    travel_at_least_s: NonNegative = 0.0
    holds: tuple[Id, ...] = ()

    @property
    def is_somewhere(self) -> bool:
        """Whether it is done at a place, known or not."""
        return self.moves or self.at is not None

    def _check(self) -> None:
        require_unique(f"action {self.name!r} holds: resource", self.holds)


@dataclass(frozen=True, slots=True, kw_only=True)
class GroundedNode(Value):
    """
    A node of the grounded tree.

    Parameters
    ----------
    parent
        Index of the parent, smaller than the node's own; -1 for the root.
    kind
        ``and``: all children are done. ``xor``: exactly one is; without children it cannot be done. ``action``: a leaf.
    label
        What people read.
    source
        Id of the mission tree's node it came from; None in foreign instances.
    action
        What is done; for leaves only.
    release_s, deadline_s
        As in the mission tree: the root's deadline is also the mission's.
    """

    parent: int
    kind: NodeKind
    label: str
    source: Id | None = None
    action: Action | None = None
    release_s: NonNegative = 0.0
    deadline_s: NonNegative | None = None

    def _check(self) -> None:
        check_times(f"node {self.label!r}", self.release_s, self.deadline_s)
        if (self.kind == "action") != (self.action is not None):
            raise ValueError(f"node {self.label!r} is of kind {self.kind!r}; actions, and they alone, carry an action.")


@dataclass(frozen=True, slots=True, kw_only=True)
class Role(Value):
    """
    One robot's part. The robot is held from the role's first action to its last.

    Parameters
    ----------
    label
        What people read.
    source
        Id of the routine node it came from; None in foreign instances.
    team
        Roles with the same number are filled by different robots; None if the role stands alone.
    """

    label: str
    source: Id | None = None
    team: Index | None = None


@dataclass(frozen=True, slots=True)
class GroundedLink(Value):
    """
    A relation between two grounded nodes; see :class:`missiontree.mission.tree.Link`.

    Parameters
    ----------
    first, second
        Node indices.
    kind
        As in the mission tree.
    """

    first: Index
    second: Index
    kind: LinkKind = "precedence"


@dataclass(frozen=True, kw_only=True)
class GroundedTree(Value):
    """
    An AND/XOR tree over actions of robot types.

    Parameters
    ----------
    objective
        The mission in words.
    nodes
        Parents before children; siblings in order. Actions of a role stand in the order in which they are done.
    roles
        Roles that actions refer to. In each alternative, a reached role is filled by one type.
    links
        Relations between nodes neither of which contains the other.
    """

    objective: str
    nodes: tuple[GroundedNode, ...]
    roles: tuple[Role, ...] = ()
    links: tuple[GroundedLink, ...] = ()

    def _check(self) -> None:
        if not self.nodes or self.nodes[0].parent != -1:
            raise ValueError("node 0 is the root and has parent -1.")
        for index, node in enumerate(self.nodes):
            if index and not 0 <= node.parent < index:
                raise ValueError(f"node {index} has parent {node.parent}; parents come before children.")
            if index and self.nodes[node.parent].kind == "action":
                raise ValueError(f"node {index} stands below an action.")
            if node.action is not None and node.action.role >= len(self.roles):
                raise ValueError(f"node {index} names role {node.action.role}, there are {len(self.roles)}.")
        for link in self.links:
            if max(link.first, link.second) >= len(self.nodes):
                raise ValueError(f"a link joins {link.first} and {link.second}, there are {len(self.nodes)} nodes.")

    @cached_property
    def children(self) -> tuple[tuple[int, ...], ...]:
        """Children of each node, in order."""
        below: list[list[int]] = [[] for _ in self.nodes]
        for index, node in enumerate(self.nodes):
            if node.parent >= 0:
                below[node.parent].append(index)
        return tuple(tuple(children) for children in below)

    @cached_property
    def windows(self) -> tuple[Window, ...]:
        """From when and until when each node may be under way: its own times, and those of all nodes above it."""
        return windows_of((node.parent, node.release_s, node.deadline_s) for node in self.nodes)

    def action(self, leaf: int) -> Action:
        """The action of a leaf."""
        action = self.nodes[leaf].action
        assert action is not None, f"node {leaf} is not an action"
        return action


@dataclass(frozen=True, kw_only=True)
class Grounding(Value):
    """
    A mission tree expanded over a fleet and a scene, with everything that was decided on the way.

    Parameters
    ----------
    tree
        The grounded tree. Where no robot can do a routine it holds an XOR without children.
    not_offered
        Why branches were not offered, per routine node and robot type.
    assumptions
        What was unknown and taken for granted.
    notices
        What was added on the operator's behalf, such as an order between two uses of one entity.
    findings
        What may be wrong with the tree, such as the use of a lost entity that nobody searches for.
    estimates
        All that an estimator of the user's own said; empty if the estimates are the fleet's.
    """

    tree: GroundedTree
    not_offered: tuple[Reason, ...] = ()
    assumptions: tuple[Reason, ...] = ()
    notices: tuple[Reason, ...] = ()
    findings: tuple[Reason, ...] = ()
    estimates: tuple[Estimated, ...] = ()
