"""
Dispatching: the clock goes forward, and whenever a robot is free it takes the most urgent action that waits for its type.

The parallel generation of schedules (Giffler and Thompson 1960; Kolisch 1996). Unlike the serial one it leaves nobody idle while something
waits for it, which is what counts where the load of equal robots binds. Choices are made beforehand.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from heapq import heappop, heappush

from missiontree.mission.columns import AND, LEAF
from missiontree.scheduling.joint.listing import Listed
from missiontree.scheduling.joint.problem import JointProblem


def dispatched(problem: JointProblem, urgency: Sequence[float], chosen: Mapping[int, int]) -> Listed:
    """
    Make a schedule.

    Parameters
    ----------
    problem
        The tree.
    urgency
        Of each node; of actions that wait for a robot, the one with the smallest is taken.
    chosen
        Child of every XOR that is reached.
    """
    return _Dispatch(problem, urgency, chosen).run()


class _Dispatch:
    def __init__(self, problem: JointProblem, urgency: Sequence[float], chosen: Mapping[int, int]) -> None:
        self.problem, self.urgency, self.given = problem, urgency, chosen
        self.chosen: dict[int, int] = {}
        self.start: dict[int, int] = {}
        self.robot: dict[int, int] = {}
        self.waiting = [len(before) + 1 if node else len(before) for node, before in enumerate(problem.before)]
        self.left: dict[int, int] = {}  # children of a gate that have not ended
        self.open = [0]  # nodes that may begin now
        self.queues: list[list[tuple[float, int]]] = [[] for _ in problem.count]
        self.idle = [list(range(robots)) for robots in problem.count]
        self.now = 0

    def run(self) -> Listed:
        """Moment by moment."""
        problem = self.problem
        under_way: list[tuple[int, int]] = []
        while True:
            while self.open:
                self._begin(self.open.pop())
            for queue, idle in zip(self.queues, self.idle, strict=True):
                while queue and idle:
                    leaf = heappop(queue)[1]
                    self.start[leaf], self.robot[leaf] = self.now, heappop(idle)
                    heappush(under_way, (self.now + problem.duration[leaf], leaf))
            if not under_way:
                return Listed(self.now, self.start, self.robot, self.chosen)
            self.now = under_way[0][0]
            while under_way and under_way[0][0] == self.now:
                leaf = heappop(under_way)[1]
                heappush(self.idle[problem.robot[leaf]], self.robot[leaf])
                self._end(leaf)

    def _begin(self, node: int) -> None:
        problem = self.problem
        if problem.kind[node] == LEAF:
            if problem.duration[node]:
                heappush(self.queues[problem.robot[node]], (self.urgency[node], node))
                return
            self.start[node], self.robot[node] = self.now, 0  # it takes no robot's time
        else:
            below = problem.children[node]
            if problem.kind[node] != AND:
                child = self.chosen[node] = self.given[node]
                self._drop(node, child)
                below = (child,)
            self.left[node] = len(below)
            for child in below:
                self._count_down(child)
            if below:
                return
        self._end(node)

    def _count_down(self, node: int) -> None:
        self.waiting[node] -= 1
        if not self.waiting[node]:
            self.open.append(node)

    def _end(self, node: int) -> None:
        """A node has ended; so may nodes above it."""
        while True:
            for other in self.problem.after[node]:
                self._count_down(other)
            above = self.problem.parent[node]
            if above < 0:
                return
            self.left[above] -= 1
            if self.left[above]:
                return
            node = above

    def _drop(self, xor: int, child: int) -> None:
        """What is not selected holds nobody up."""
        problem = self.problem
        if not problem.reaching[xor]:
            return
        stack = [other for other in problem.children[xor] if other != child]
        while stack:
            node = stack.pop()
            for other in problem.after[node]:
                self._count_down(other)
            stack.extend(problem.children[node])
