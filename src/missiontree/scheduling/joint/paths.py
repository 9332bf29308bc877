"""The longest path through a tree of choices: what no selection can do without."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from missiontree.mission.columns import AND, LEAF, XOR
from missiontree.scheduling.joint.problem import JointProblem

NEVER = 1 << 60
"""Later than anything: a node that cannot be done, or whose choice is closed."""


@dataclass(frozen=True)
class Paths:
    """
    Least times, each on condition that the node is selected.

    Parameters
    ----------
    head
        Before the start of each node.
    end
        Before its end.
    tail
        From its end to the end of the mission.
    rest
        From its start to the end of the mission.
    """

    head: list[int]
    end: list[int]
    tail: list[int]
    rest: list[int]

    @property
    def bound(self) -> int:
        """No schedule is shorter, however many robots there are."""
        return self.end[0]


def paths_of(problem: JointProblem) -> Paths:
    """
    Critical path over the least of every XOR.

    A precedence counts between two nodes only where the one cannot be selected without the other.
    """
    before, after = certain_links(problem)
    head, end = _heads(problem, before)
    tail, rest = _tails(problem, after)
    return Paths(head, end, tail, rest)


def _heads(problem: JointProblem, before: Sequence[Iterable[int]]) -> tuple[list[int], list[int]]:
    kind, parent, children, duration = problem.kind, problem.parent, problem.children, problem.duration
    head, end = [0] * len(kind), [0] * len(kind)
    for event in problem.order:
        node = event >> 1
        if not event & 1:
            found = head[parent[node]] if node else 0
            for other in before[node]:
                found = max(found, end[other])
            head[node] = found
        elif kind[node] == LEAF:
            end[node] = head[node] + duration[node]
        elif kind[node] == AND:
            end[node] = max([end[child] for child in children[node]], default=head[node])
        else:
            end[node] = min([end[child] for child in children[node]], default=NEVER)
    return head, end


def _tails(problem: JointProblem, after: Sequence[Iterable[int]]) -> tuple[list[int], list[int]]:
    kind, parent, children, duration = problem.kind, problem.parent, problem.children, problem.duration
    tail, rest = [0] * len(kind), [0] * len(kind)
    for event in reversed(problem.order):
        node = event >> 1
        if event & 1:
            found = tail[parent[node]] if node else 0
            for other in after[node]:
                found = max(found, rest[other])
            tail[node] = found
        elif kind[node] == LEAF:
            rest[node] = tail[node] + duration[node]
        elif kind[node] == AND:
            rest[node] = max([rest[child] for child in children[node]], default=tail[node])
        else:
            rest[node] = min([rest[child] for child in children[node]], default=NEVER)
    return tail, rest


def certain_links(problem: JointProblem) -> tuple[list[Iterable[int]], list[Iterable[int]]]:
    """Of the nodes before and after each node, those that are selected whenever it is."""
    kind, parent = problem.kind, problem.parent
    # The AND parts of the tree: nodes joined to their parent by an AND are selected together with it.
    top = list(range(len(kind)))
    for node in range(1, len(kind)):
        if kind[parent[node]] != XOR:
            top[node] = top[parent[node]]

    def certain(node: int, other: int) -> bool:
        wanted = top[other]
        while node >= 0:
            if top[node] == wanted:
                return True
            node = parent[top[node]]
        return False

    def kept(links: Sequence[Sequence[int]]) -> list[Iterable[int]]:
        return [
            [other for other in others if certain(node, other)] if others else others
            for node, others in enumerate(links)
        ]

    return kept(problem.before), kept(problem.after)
