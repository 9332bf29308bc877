"""
Pushing a schedule to and fro: everything as late as the end allows, then as early as the beginning does, the choices as they are.

Each pass is list scheduling in the order of the schedule before, so the makespan hardly ever grows and often shrinks (Valls, Ballestín and
Quintanilla, European Journal of Operational Research 165, 2005).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from missiontree.mission.columns import LEAF
from missiontree.scheduling.joint.listing import Listed, listed
from missiontree.scheduling.joint.paths import Paths
from missiontree.scheduling.joint.problem import JointProblem

ROUNDS = 6


def reversed_in_time(problem: JointProblem) -> JointProblem:
    """The tree with every precedence the other way round."""
    return replace(problem, before=problem.after, after=problem.before)


def justified(
    problem: JointProblem, mirror: JointProblem, paths: Paths, schedule: Listed, bound: int, ended: Callable[[], bool]
) -> Listed:
    """
    The best of some rounds.

    Parameters
    ----------
    problem, mirror
        The tree, and the same reversed in time.
    paths
        Its least times.
    schedule
        A schedule of it.
    bound
        At which there is nothing left to gain.
    ended
        Whether to stop.
    """
    best, now = schedule, schedule
    for _ in range(ROUNDS):
        if best.makespan <= bound or ended():
            break
        late = listed(mirror, paths, _urgency(problem, now), None, schedule.chosen)
        early = listed(problem, paths, _urgency(problem, late), None, schedule.chosen)
        if early.makespan < best.makespan:
            best = early
        elif early.makespan >= now.makespan:
            break
        now = early
    return best


def _urgency(problem: JointProblem, schedule: Listed) -> list[int]:
    """What ends last comes first, seen from the other side; gates come at once."""
    urgency = [-(1 << 60)] * len(problem.kind)
    for node, kind in enumerate(problem.kind):
        if kind == LEAF and node in schedule.start:
            urgency[node] = -(schedule.start[node] + problem.duration[node])
    return urgency
