"""A schedule for times that somebody else found: the same order, each action as early as it can be, and robots for all of them."""

from __future__ import annotations

from collections.abc import Mapping

from missiontree.scheduling.joint.listing import Listed, listed
from missiontree.scheduling.joint.paths import Paths
from missiontree.scheduling.joint.problem import JointProblem

AT_ONCE = float("-inf")


def handed_out(problem: JointProblem, paths: Paths, chosen: Mapping[int, int], start: Mapping[int, int]) -> Listed:
    """
    The schedule of these times, in which nothing waits without a reason; no action begins later than it was to.

    A solver that is asked for the least makespan leaves gaps wherever they cost nothing. In order of the times, each action is begun as
    early as those before it and the robots of its type allow, which gives an active schedule (Sprecher, Kolisch and Drexl, European
    Journal of Operational Research 80, 1995).

    Parameters
    ----------
    problem, paths
        The tree and its least times.
    chosen
        Child of each reached XOR.
    start
        Of each selected leaf; of every type there are enough robots for these times.
    """
    urgency = [float(start.get(node, AT_ONCE)) for node in range(len(problem.kind))]
    return listed(problem, paths, urgency, None, chosen)
