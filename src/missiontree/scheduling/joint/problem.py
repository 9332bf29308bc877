"""The tree as the engines of this package look at it: events in an order, and chains that one robot does in one go."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from missiontree.errors import InputError
from missiontree.mission.columns import AND, LEAF, TreeColumns


@dataclass(frozen=True)
class JointProblem:
    """
    A tree over actions, each of one robot type.

    Parameters
    ----------
    kind, parent
        As in :class:`~missiontree.mission.columns.TreeColumns`.
    children
        Of each node, in order.
    robot
        Type of each leaf; 0 elsewhere.
    duration
        Of each leaf, a whole number; 0 elsewhere.
    before, after
        Nodes that end before a node starts, and nodes that start after it ended, by precedence alone.
    count
        How many robots of each type there are.
    """

    kind: Sequence[int]
    parent: Sequence[int]
    children: Sequence[Sequence[int]]
    robot: Sequence[int]
    duration: Sequence[int]
    before: Sequence[Sequence[int]]
    after: Sequence[Sequence[int]]
    count: Sequence[int]

    @cached_property
    def order(self) -> list[int]:
        """Events, 2 n for the start of node n and 2 n + 1 for its end, each after all that come no later (Kahn 1962)."""
        nodes = len(self.kind)
        waiting = [0] * (2 * nodes)
        for node in range(nodes):
            waiting[2 * node] = (self.parent[node] >= 0) + len(self.before[node])
            waiting[2 * node + 1] = len(self.children[node]) or 1
        ready, order = [0], list[int]()
        if waiting[0]:
            return order
        kind, parent, children, after = self.kind, self.parent, self.children, self.after
        while ready:
            event = ready.pop()
            order.append(event)
            node = event >> 1
            if event & 1:
                follow = [2 * other for other in after[node]]
                if parent[node] >= 0:
                    follow.append(2 * parent[node] + 1)
            elif kind[node] == LEAF or not children[node]:
                follow = [event + 1]
            else:
                follow = [2 * child for child in children[node]]
            for other in follow:
                waiting[other] -= 1
                if not waiting[other]:
                    ready.append(other)
        return order

    @cached_property
    def place(self) -> list[int]:
        """Place of the start of each node in that order."""
        place = [0] * len(self.kind)
        for at, event in enumerate(self.order):
            if not event & 1:
                place[event >> 1] = at
        return place

    def sequence(self, node: int) -> Sequence[int]:
        """The children, each after all that it must wait for."""
        found = self._sequences.get(node)
        if found is None:
            children = self.children[node]
            linked = any(self.before[child] for child in children)
            found = self._sequences[node] = sorted(children, key=self.place.__getitem__) if linked else children
        return found

    @cached_property
    def _sequences(self) -> dict[int, Sequence[int]]:
        return {}

    @cached_property
    def reaching(self) -> list[bool]:
        """Of each gate, whether a precedence leads from a child, or from below it, to a node that is not below that child."""
        nodes = len(self.kind)
        reach = [False] * nodes
        size = [1] * nodes
        for node in range(nodes - 1, 0, -1):
            size[self.parent[node]] += size[node]
        first = [0] * nodes
        free = [1] * nodes
        for node in range(1, nodes):
            above = self.parent[node]
            first[node] = free[above]
            free[above] += size[node]
            free[node] = first[node] + 1
        for node, others in enumerate(self.after):
            for other in others:
                child = node
                while not first[child] <= first[other] < first[child] + size[child]:
                    child = self.parent[child]
                    reach[child] = True
        return reach

    @cached_property
    def leaves(self) -> list[int]:
        """Nodes that are leaves."""
        return [node for node, kind in enumerate(self.kind) if kind == LEAF]


def problem_of(columns: TreeColumns) -> JointProblem:
    """
    The tree as it stands.

    Raises
    ------
    InputError
        If an AND has no children: it has neither a start nor an end, and what should precede it is open.
    """
    nodes = len(columns.kind)
    nothing: list[int] = []
    children: list[list[int]] = [nothing if kind == LEAF else [] for kind in columns.kind]
    for node in range(1, nodes):
        children[columns.parent[node]].append(node)
    for node, kind in enumerate(columns.kind):
        if kind == AND and not children[node]:
            message = f"{columns.label(node)} has no children, so it has no time at which it starts or ends"
            raise InputError(message, accepted="ANDs with children", hint="Give it an action that takes no time.")
    before: list[list[int]] = [nothing] * nodes
    after: list[list[int]] = [nothing] * nodes
    for first, second in columns.precedence:
        if before[second] is nothing:
            before[second] = []
        before[second].append(first)
        if after[first] is nothing:
            after[first] = []
        after[first].append(second)
    count = columns.count if columns.count is not None else [1] * columns.robots
    return JointProblem(columns.kind, columns.parent, children, columns.robot, columns.duration, before, after, count)
