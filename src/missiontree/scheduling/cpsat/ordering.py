"""Which of two activities comes first: known from the task graph, or a literal of the model."""

from __future__ import annotations

from missiontree.scheduling.cpsat.model import Model, negated
from missiontree.scheduling.problem import Problem


class Ordering:
    """
    The order of pairs of activities.

    Parameters
    ----------
    model, problem
        What is built, and of what.
    """

    def __init__(self, model: Model, problem: Problem) -> None:
        self._model = model
        graph = problem.graph
        order = graph.order()
        assert order is not None, "a problem has no cycle"
        marks = {2 * activity + 1: 1 << activity for activity in range(len(graph.activities))}
        self._before = graph.marks_before(order, marks)
        self.literals: dict[
            tuple[int, int], int
        ] = {}  # the first of the pair, the smaller one, ends before the second starts

    def certain(self, first: int, second: int) -> bool:
        """Whether an activity ends before another starts, whatever the schedule."""
        return bool(self._before[2 * second] >> first & 1)

    def open_pair(self, first: int, second: int) -> bool:
        """Whether neither order is certain."""
        return not (self.certain(first, second) or self.certain(second, first))

    def before(self, first: int, second: int) -> int:
        """The literal that the first of two activities comes before the second."""
        if self.certain(first, second):
            return self._model.true
        if self.certain(second, first):
            return self._model.false
        low, high = sorted((first, second))
        literal = self.literals.get((low, high))
        if literal is None:
            literal = self.literals[low, high] = self._model.boolean()
        return literal if first == low else negated(literal)
