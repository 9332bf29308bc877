"""The tree as the engines of this package look at it: events in an order, and chains that one robot does in one go."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

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
        """Of each node, whether a precedence leads from a node below it (but not from itself) to one that is not below it."""
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
                above = self.parent[node]
                while above >= 0 and not first[above] <= first[other] < first[above] + size[above]:
                    if reach[above]:
                        break
                    reach[above] = True
                    above = self.parent[above]
        return reach

    @cached_property
    def leaves(self) -> list[int]:
        """Nodes that are leaves."""
        return [node for node, kind in enumerate(self.kind) if kind == LEAF]


def problem_of(columns: TreeColumns) -> JointProblem:
    """The tree as it stands."""
    nodes = len(columns.kind)
    nothing: list[int] = []
    children: list[list[int]] = [nothing if kind == LEAF else [] for kind in columns.kind]
    for node in range(1, nodes):
        children[columns.parent[node]].append(node)
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
    return JointProblem(
        columns.kind, columns.parent, children, columns.robot, columns.duration, before, after, count
    )


@dataclass(frozen=True)
class Contraction:
    """
    The tree with every chain that one robot type does, one action after the other and none of them linked elsewhere, as one leaf.

    What is scheduled here can be scheduled there, in as much time; bounds of paths and loads are the same. A schedule there that lets a
    robot do something else in the midst of a chain has none here.

    Parameters
    ----------
    problem
        The smaller tree.
    inside
        Leaves of the whole tree that a leaf of the smaller one stands for, in their order; the node itself for other nodes.
    original
        Node of the whole tree that each node of the smaller one is; a chain is the AND above it.
    """

    problem: JointProblem
    inside: list[list[int]]
    original: list[int]


def contracted(problem: JointProblem) -> Contraction:
    """The tree with its chains as leaves."""
    chain = _chains(problem)
    number = [-1] * len(problem.kind)
    kept: list[int] = []
    for node, parent in enumerate(problem.parent):
        if parent >= 0 and (chain[parent] is not None or number[parent] < 0):
            continue
        number[node] = len(kept)
        kept.append(node)
    inside = [chain[node] or [node] for node in kept]
    nothing: list[int] = []

    def moved(links: Sequence[Sequence[int]]) -> list[list[int]]:
        return [[number[other] for other in links[node]] if links[node] else nothing for node in kept]

    smaller = JointProblem(
        kind=[LEAF if chain[node] else problem.kind[node] for node in kept],
        parent=[number[problem.parent[node]] if problem.parent[node] >= 0 else -1 for node in kept],
        children=[[] if chain[node] else [number[child] for child in problem.children[node]] for node in kept],
        robot=[problem.robot[leaves[0]] for leaves in inside],
        duration=[sum(problem.duration[leaf] for leaf in leaves) for leaves in inside],
        before=moved(problem.before),
        after=moved(problem.after),
        count=problem.count,
    )
    return Contraction(smaller, inside, kept)


def _chains(problem: JointProblem) -> list[list[int] | None]:
    """For each AND that is such a chain, its leaves in order."""
    chain: list[list[int] | None] = [None] * len(problem.kind)
    for node, kind in enumerate(problem.kind):
        children = problem.children[node]
        if kind != AND or not children:
            continue
        if any(problem.kind[child] != LEAF for child in children):
            continue
        if len({problem.robot[child] for child in children}) > 1:
            continue
        chain[node] = _in_order(problem, children)
    return chain


def _in_order(problem: JointProblem, children: Sequence[int]) -> list[int] | None:
    """The leaves one after the other; None if their links leave that open or reach further."""
    links = {child: list(dict.fromkeys(problem.after[child])) for child in children}
    first = [child for child in children if not problem.before[child]]
    if len(first) != 1:
        return None
    found = [first[0]]
    while len(links[found[-1]]) == 1 and links[found[-1]][0] in links:
        found.append(links[found[-1]][0])
    whole = len(found) == len(children) and not links[found[-1]]
    tied = all(set(problem.before[child]) <= set(children) for child in children)
    return found if whole and tied else None
