"""
List scheduling with local choice: one action after another, each as early as possible, and at an XOR what promises most.

The serial generation of schedules (Kelley 1963), longest rest first. The mission is to end by a target; of the ways at an XOR that seem
to allow it, the one that costs the robots least is taken, by prices on their time; where none allows it, the one that is late by least.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from heapq import heappop, heappush

from missiontree.mission.columns import AND, LEAF
from missiontree.scheduling.joint.paths import NEVER, Paths
from missiontree.scheduling.joint.problem import JointProblem
from missiontree.scheduling.joint.timeline import Timeline

CLOSE = 64
"""Leaves below a node up to which a way is looked at leaf by leaf before it is taken; beyond, by its longest path alone."""


@dataclass(frozen=True)
class Listed:
    """
    A schedule.

    Parameters
    ----------
    makespan
        End of the last action.
    start
        Start of each selected leaf, by leaf.
    robot
        Which robot of its type does it.
    chosen
        Child of each reached XOR.
    """

    makespan: int
    start: dict[int, int]
    robot: dict[int, int]
    chosen: dict[int, int]


@dataclass(frozen=True)
class Aim:
    """
    What a way is chosen by.

    Parameters
    ----------
    target
        When the mission is to have ended.
    price
        Of a unit of time, by robot type.
    sizes
        Leaves below each node.
    """

    target: int
    price: Sequence[float]
    sizes: Sequence[int]


def leaves_below(problem: JointProblem) -> list[int]:
    """How many leaves each node has below it, itself included."""
    sizes = [int(kind == LEAF) for kind in problem.kind]
    for node in range(len(sizes) - 1, 0, -1):
        sizes[problem.parent[node]] += sizes[node]
    return sizes


def listed(
    problem: JointProblem,
    paths: Paths,
    urgency: Sequence[float],
    aim: Aim | None = None,
    chosen: Mapping[int, int] | None = None,
) -> Listed:
    """
    Make a schedule.

    Parameters
    ----------
    problem, paths
        The tree and its least times.
    urgency
        Of each node; of those that could come next, the smallest comes first.
    aim
        What decides at an XOR that ``chosen`` does not name.
    chosen
        Children to take.
    """
    return _Listing(problem, paths, urgency, aim, chosen or {}).run()


class _Listing:
    def __init__(
        self,
        problem: JointProblem,
        paths: Paths,
        urgency: Sequence[float],
        aim: Aim | None,
        chosen: Mapping[int, int],
    ) -> None:
        self.problem, self.paths, self.urgency, self.aim, self.given = problem, paths, urgency, aim, chosen
        self.timeline = Timeline(problem.count)
        self.start: dict[int, int] = {}
        self.robot: dict[int, int] = {}
        self.chosen: dict[int, int] = {}

    def run(self) -> Listed:
        """Events in an order that keeps every precedence between selected nodes."""
        problem = self.problem
        kind, children, duration = problem.kind, problem.children, problem.duration
        waiting = self._waiting()
        ready = [0] * len(kind)  # no earlier start, by what has ended
        ended = [0] * len(kind)
        left: dict[int, int] = {}  # children of a gate that have not ended
        queue = [(self.urgency[0], 0)]
        while queue:
            node = heappop(queue)[1]
            if kind[node] != LEAF:
                below = children[node]
                if kind[node] != AND:
                    child = self.given.get(node, -1)
                    child = self._choose(node, ready[node]) if child < 0 else child
                    self.chosen[node] = child
                    self._drop(node, child, waiting, ready, queue)
                    below = (child,)
                left[node] = len(below)
                ended[node] = ready[node]
                for child in below:
                    ready[child] = max(ready[child], ready[node])
                    waiting[child] -= 1
                    if not waiting[child]:
                        heappush(queue, (self.urgency[child], child))
                if below:
                    continue
            else:
                began, robot = self.timeline.fit(problem.robot[node], ready[node], duration[node])
                self.timeline.take(problem.robot[node], robot, began, duration[node])
                self.start[node], self.robot[node] = began, robot
                ended[node] = began + duration[node]
            self._close(node, ended, left, waiting, ready, queue)
        return Listed(ended[0], self.start, self.robot, self.chosen)

    def _waiting(self) -> list[int]:
        return [len(before) + 1 if node else len(before) for node, before in enumerate(self.problem.before)]

    def _close(
        self,
        node: int,
        ended: list[int],
        left: dict[int, int],
        waiting: list[int],
        ready: list[int],
        queue: list[tuple[float, int]],
    ) -> None:
        """A node has ended; so may nodes above it."""
        parent = self.problem.parent
        while True:
            for other in self.problem.after[node]:
                ready[other] = max(ready[other], ended[node])
                waiting[other] -= 1
                if not waiting[other]:
                    heappush(queue, (self.urgency[other], other))
            above = parent[node]
            if above < 0:
                return
            ended[above] = max(ended[above], ended[node])
            left[above] -= 1
            if left[above]:
                return
            node = above

    def _drop(self, xor: int, child: int, waiting: list[int], ready: list[int], queue: list[tuple[float, int]]) -> None:
        """What is not selected holds nobody up."""
        problem = self.problem
        if not problem.reaching[xor]:
            return
        stack = [other for other in problem.children[xor] if other != child]
        while stack:
            node = stack.pop()
            for other in problem.after[node]:
                waiting[other] -= 1
                if not waiting[other]:
                    heappush(queue, (self.urgency[other], other))
            stack.extend(problem.children[node])

    def _choose(self, xor: int, ready: int) -> int:
        return self._promise(xor, ready)[2]

    def _promise(self, node: int, ready: int) -> tuple[int, float, int]:
        """When a node would end if it were done now and nothing else were, what that would cost, and the child it would take."""
        problem, paths, aim = self.problem, self.paths, self.aim
        assert aim is not None  # every XOR is either given or decided by an aim
        if problem.kind[node] == LEAF:
            duration, kind = problem.duration[node], problem.robot[node]
            return self.timeline.fit(kind, ready, duration)[0] + duration, aim.price[kind] * duration, -1
        children = problem.children[node]
        if problem.kind[node] == AND:
            if aim.sizes[node] > CLOSE:
                return ready + paths.end[node] - paths.head[node], 0.0, -1
            return self._promise_all(node, ready)
        best: tuple[int, float, int, int] | None = None
        after = paths.tail[node] - aim.target
        for child in children:
            if paths.rest[child] >= NEVER:
                continue
            end, cost, _ = self._promise(child, ready)
            rank = (max(0, end + after), cost, end, child)
            if best is None or rank < best:
                best = rank
        if best is None:
            return NEVER, 0.0, children[0] if children else -1
        return best[2], best[1], best[3]

    def _promise_all(self, node: int, ready: int) -> tuple[int, float, int]:
        problem = self.problem
        ends: dict[int, int] = {}
        latest, total = ready, 0.0
        for child in problem.sequence(node):
            begins = ready
            for other in problem.before[child]:
                if other in ends:
                    begins = max(begins, ends[other])
            end, cost, _ = self._promise(child, begins)
            ends[child] = end
            latest, total = max(latest, end), total + cost
        return latest, total, -1
