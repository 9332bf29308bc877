"""One XOR after another decided otherwise, what is not concerned as it was, and kept where the mission does not end later."""

from __future__ import annotations

from collections.abc import Callable
from random import Random

from missiontree.scheduling.joint.listing import Aim, Listed, listed
from missiontree.scheduling.joint.paths import NEVER, Paths
from missiontree.scheduling.joint.problem import JointProblem

IN_VAIN = 1000
"""Flips in a row without a gain after which the search ends."""


def flipped(
    problem: JointProblem,
    paths: Paths,
    schedule: Listed,
    aim: Aim,
    seed: int,
    ended: Callable[[], bool],
) -> Listed:
    """
    The best schedule that flips lead to.

    Parameters
    ----------
    problem, paths
        The tree and its least times.
    schedule
        One to begin with.
    aim
        What decides at XORs that a flip reaches first, and the makespan at which the search ends.
    seed
        Of the order of flips.
    ended
        Whether to stop.
    """
    luck = Random(seed)  # noqa: S311 - luck for a search, not for secrets
    urgency = [-rest for rest in paths.rest]
    best, now, in_vain = schedule, schedule, 0
    while in_vain < IN_VAIN and best.makespan > aim.target and not ended():
        options = [xor for xor in now.chosen if len(problem.children[xor]) > 1]
        if not options:
            break
        in_vain += 1
        xor = luck.choice(options)
        child = luck.choice(problem.children[xor])
        if child == now.chosen[xor] or paths.head[child] + paths.rest[child] >= min(NEVER, best.makespan):
            continue
        one = listed(problem, paths, urgency, aim, {**now.chosen, xor: child})
        if one.makespan <= now.makespan:
            now = one
        if one.makespan < best.makespan:
            best, in_vain = one, 0
    return best
