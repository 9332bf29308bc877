"""
What robots must do at least, whichever ways are taken: a bound on the makespan, and prices on the time of each robot type.

Each type's work fits between the first moment that any of it can begin and the last at which it must end. Weighing the types by prices
and taking everywhere the cheapest way bounds the makespan from below; the best prices give the bound of the linear programme in which a
way may be taken in part. Prices rise by multiplicative weights (Arora, Hazan and Kale, Theory of Computing 8, 2012) on those with most to
do. They are whole numbers, so the bound is exact whatever they are.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import exp, log

from missiontree.mission.columns import AND, LEAF
from missiontree.scheduling.joint.paths import NEVER, Paths
from missiontree.scheduling.joint.problem import JointProblem

SCALE = 1_000_000
ROUNDS = 400
MOST_ALONE = 32
"""Types looked at one by one."""
VISITS = 2_000_000
"""Nodes looked at in all rounds together."""


@dataclass(frozen=True)
class Loads:
    """
    A bound, and the best prices found.

    Parameters
    ----------
    bound
        No schedule ends before.
    price
        Of a unit of time, by robot type, to choose ways by; they sum up to about a million.
    """

    bound: int
    price: list[int]


def loads_of(problem: JointProblem, paths: Paths, lower: int, upper: int, ended: Callable[[], bool]) -> Loads:
    """
    The load bound.

    Parameters
    ----------
    problem, paths
        The tree and its least times.
    lower
        A bound that is known.
    upper
        A makespan that is known; ways that cannot lead below it are left out, so that the bound is at most that makespan.
    ended
        Whether to stop.
    """
    types = len(problem.count)
    weight = [1.0 / types] * types
    best = Loads(lower, [SCALE // types + 1] * types)
    rounds = max(3, min(ROUNDS, VISITS // len(problem.kind)))
    if all(kind in {LEAF, AND} or len(below) < 2 for kind, below in zip(problem.kind, problem.children, strict=True)):
        rounds = 0  # nothing to choose, so that no weighing of types bounds more than the heaviest type alone
    rate = (log(types + 1) / max(1, rounds)) ** 0.5
    gone = _gone(problem, paths, upper, lower)
    for turn in range(-min(types, MOST_ALONE), rounds):
        if ended() or best.bound >= upper:
            break
        if turn < 0:  # first each type by itself
            price = [0] * types
            price[turn] = 1
        else:
            price = [max(1, round(SCALE * part)) for part in weight]
        least, load = _cheapest(problem, paths, price, upper)
        if least >= NEVER:
            return Loads(upper, best.price)  # no way is left below the makespan that is known
        fixed = sum(price[kind] * problem.count[kind] * gone[kind] for kind in range(types))
        scale = sum(price[kind] * problem.count[kind] for kind in range(types))
        bound = min(upper, -(-(least + fixed) // scale))
        if bound > best.bound:
            best = Loads(bound, price if turn >= 0 else best.price)
        if turn < 0:
            continue
        per_robot = [load[kind] / problem.count[kind] + gone[kind] for kind in range(types)]
        most = max(per_robot) or 1.0
        weight = [part * exp(rate * (work / most)) for part, work in zip(weight, per_robot, strict=True)]
        total = sum(weight)
        weight = [part / total for part in weight]
    return best


def _gone(problem: JointProblem, paths: Paths, upper: int, lower: int) -> list[int]:
    """Of each type, the time before any of its work can begin and after all of it must have ended, if that is sure to fit."""
    types = len(problem.count)
    head, tail = [NEVER] * types, [NEVER] * types
    for leaf in problem.leaves:
        if paths.head[leaf] + paths.rest[leaf] < upper:
            kind = problem.robot[leaf]
            head[kind] = min(head[kind], paths.head[leaf])
            tail[kind] = min(tail[kind], paths.tail[leaf])
    both = [before + after for before, after in zip(head, tail, strict=True)]
    return [
        span if span <= lower else 0 for span in both
    ]  # a type that may have nothing to do must not add to the bound


def _cheapest(problem: JointProblem, paths: Paths, price: Sequence[int], upper: int) -> tuple[int, list[int]]:
    """What the cheapest selection costs, and what it gives each type to do."""
    kind, children = problem.kind, problem.children
    cost = [0] * len(kind)
    for node in range(len(kind) - 1, -1, -1):
        if kind[node] == LEAF:
            cost[node] = price[problem.robot[node]] * problem.duration[node]
        elif kind[node] == AND:
            cost[node] = min(NEVER, sum([cost[child] for child in children[node]]))
        else:
            cost[node] = min([cost[child] for child in children[node]], default=NEVER)
        if node and paths.head[node] + paths.rest[node] >= upper:
            cost[node] = NEVER
    load = [0] * len(price)
    if cost[0] >= NEVER:
        return NEVER, load
    stack = [0]
    while stack:
        node = stack.pop()
        if kind[node] == LEAF:
            load[problem.robot[node]] += problem.duration[node]
        elif kind[node] == AND:
            stack.extend(children[node])
        else:
            stack.append(min(children[node], key=cost.__getitem__))
    return cost[0], load
