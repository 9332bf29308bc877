"""Which activities come before others in any case, and which may change when or where others can be."""

from __future__ import annotations

from missiontree.scheduling.precedence import TaskGraph


class Relations:
    """
    Relations between the activities of a task graph.

    Parameters
    ----------
    graph
        Without a cycle.

    Attributes
    ----------
    earlier
        For each activity, those whose start comes before its own in any case.
    rivals
        For each activity, those of which that is not so either way round, and which move what it moves or needs in its place, or need in
        its place what it moves.
    """

    def __init__(self, graph: TaskGraph) -> None:
        order = graph.order()
        assert order is not None
        number = len(graph.activities)
        before = graph.marks_before(order, {2 * one: 1 << one for one in range(number)})
        self.earlier = [{other for other in range(number) if before[2 * one] & 1 << other} for one in range(number)]
        actions = [[graph.tree.action(leaf) for leaf in leaves] for leaves in graph.activities]
        moved = [{name for action in own for name in action.brings} for own in actions]
        there = [{action.at for action in own if action.at is not None} for own in actions]
        self.rivals = [
            {
                other
                for other in range(number)
                if other != one
                and (moved[other] & (moved[one] | there[one]) or there[other] & moved[one])
                and other not in self.earlier[one]
                and one not in self.earlier[other]
            }
            for one in range(number)
        ]
