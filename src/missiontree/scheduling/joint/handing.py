"""Robots for times: which of several equal robots does what, where all that is known is that they are enough."""

from __future__ import annotations

from collections.abc import Mapping
from heapq import heappop, heappush

from missiontree.scheduling.joint.listing import Listed
from missiontree.scheduling.joint.problem import JointProblem


def handed_out(problem: JointProblem, chosen: Mapping[int, int], start: Mapping[int, int]) -> Listed:
    """The schedule of these times: by start, each action to the robot of its type that is free (interval colouring)."""
    free: dict[int, list[int]] = {}
    busy: dict[int, list[tuple[int, int]]] = {}
    robot: dict[int, int] = {}
    makespan = 0
    for leaf in sorted(start, key=lambda leaf: (start[leaf], leaf)):
        kind, begins, ends = problem.robot[leaf], start[leaf], start[leaf] + problem.duration[leaf]
        makespan = max(makespan, ends)
        robot[leaf] = 0
        if not problem.duration[leaf]:
            continue
        idle = free.setdefault(kind, list(range(problem.count[kind])))
        working = busy.setdefault(kind, [])
        while working and working[0][0] <= begins:
            heappush(idle, heappop(working)[1])
        robot[leaf] = heappop(idle)
        heappush(working, (ends, robot[leaf]))
    return Listed(makespan, dict(start), robot, dict(chosen))
