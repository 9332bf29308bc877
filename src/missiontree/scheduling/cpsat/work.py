"""How long a role keeps its robot at least, the way to it left out."""

from __future__ import annotations

from missiontree.scheduling.problem import Problem


def least_work(problem: Problem, role: int, first: int | None) -> int:
    """
    The least ticks from the start of a role to its end, without the way to its first place.

    Parameters
    ----------
    problem, role
        Of what.
    first
        Its first action with a place; None if it has none. A move is itself the way.
    """
    graph, bounds, total = problem.graph, problem.bounds, 0
    for leaf in graph.roles[role]:
        if leaf != first or not graph.tree.action(leaf).moves:
            total += bounds.duration[graph.activity_of[leaf]]
        if leaf != first:
            total += bounds.lag.get(leaf, 0)
    return total
