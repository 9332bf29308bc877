"""Chains that one robot does in one go, as one leaf each: a smaller tree, quicker to schedule."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from missiontree.mission.columns import AND, LEAF
from missiontree.scheduling.joint.listing import Listed
from missiontree.scheduling.joint.problem import JointProblem


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

    def expanded(self, whole: JointProblem, listed: Listed) -> Listed:
        """The schedule of the whole tree that one of the smaller one is."""
        start: dict[int, int] = {}
        robot: dict[int, int] = {}
        for node, begins in listed.start.items():
            for leaf in self.inside[node]:
                start[leaf], robot[leaf] = begins, listed.robot[node]
                begins += whole.duration[leaf]  # noqa: PLW2901 - one action after the other
        chosen = {self.original[xor]: self.original[child] for xor, child in listed.chosen.items()}
        return Listed(listed.makespan, start, robot, chosen)


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
