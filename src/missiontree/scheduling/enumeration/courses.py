"""What a schedule under trial comes to, as decisions that can be replayed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from missiontree.scheduling.course import Course, begun_is_enough, passings
from missiontree.scheduling.enumeration.state import State
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.room import order_of_events, turns


def course_of(problem: Problem, names: Sequence[str], state: State, under_way: Mapping[int, int]) -> Course:
    """
    What a whole trial decided, so that it can be replayed.

    Parameters
    ----------
    problem
        The alternative.
    names
        Of robots, by number.
    state
        With everything put down.
    under_way
        For each open-ended activity, the one before whose end it has begun.
    """
    graph = problem.graph
    robots = {role: names[state.robot_of[group]] for role, group in problem.staffing.group_of.items()}
    tours: dict[str, list[int]] = {}
    for activity in state.placed:
        for leaf in graph.activities[activity]:
            role = graph.tree.action(leaf).role
            if graph.roles[role][0] == leaf:
                tours.setdefault(robots[role], []).append(role)
    after_end: list[tuple[int, int]] = []
    after_start: list[tuple[int, int]] = []
    for place, second in enumerate(state.placed):
        for first in state.placed[:place]:
            begun = begun_is_enough(graph, first, second)
            if begun is not None:
                (after_start if begun else after_end).append((first, second))
    if problem.sharing:
        spans = {one: (state.starts[one], state.time[2 * one + 1]) for one in state.placed}
        order = order_of_events(graph, spans, [*after_end, *passings(graph, tours)], after_start)
        after_end += turns(problem.sharing, spans, order)
    return Course(robots, tours, after_end, after_start, dict(under_way))
