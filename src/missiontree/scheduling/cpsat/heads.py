"""
Robots of a type that need not travel: heads are counted, or each role's robot has its literal.

Where an interval belongs to one of several robots, the form is a safe one (shared start and end of optional intervals of varying size
can give wrong answers): intervals of fixed size on the shared start, or a start and an end of its own for each robot.
"""

from __future__ import annotations

from missiontree.scheduling.cpsat.crew import Crew, matters_who
from missiontree.scheduling.cpsat.model import Affine, Cumulative, Interval, Model, NoOverlap
from missiontree.scheduling.cpsat.staff import Staff
from missiontree.scheduling.cpsat.times import Times
from missiontree.scheduling.problem import Problem


class Spans:
    """
    From when to when a role holds its robot, as intervals.

    Parameters
    ----------
    model, problem, times
        What is built, of what, and when.
    """

    def __init__(self, model: Model, problem: Problem, times: Times) -> None:
        self._model, self._graph, self._times = model, problem.graph, times
        self._sizes: dict[int, Affine] = {}
        self._of: dict[int, int] = {}

    def start(self, role: int) -> Affine:
        """When a role begins."""
        return self._times.start[self._graph.activity_of[self._graph.roles[role][0]]]

    def end(self, role: int) -> Affine:
        """When it is over."""
        return self._times.end[self._graph.activity_of[self._graph.roles[role][-1]]]

    def fixed(self, role: int) -> int | None:
        """How long it lasts; None if that depends."""
        start, end = self.start(role), self.end(role)
        return end.offset - start.offset if start.var == end.var else None

    def of(self, role: int) -> int:
        """The interval of a role."""
        if role not in self._of:
            size = self.fixed(role)
            length = Affine(self._model.integer(0, self._times.horizon)) if size is None else Affine(None, size)
            self._of[role] = self._model.add(Interval(self.start(role), length, self.end(role)))
        return self._of[role]

    def by(self, role: int, literal: int) -> int:
        """The interval of a role for one robot, there where the literal holds; in a safe form."""
        size, model, horizon = self.fixed(role), self._model, self._times.horizon
        if size is not None:
            return model.add(Interval(self.start(role), Affine(None, size), self.end(role), (literal,)))
        start, end, length = (Affine(model.integer(0, horizon)) for _ in range(3))
        for own, shared in ((start, self.start(role)), (end, self.end(role))):
            model.at_least(own, shared, 0, (literal,))
            model.at_least(shared, own, 0, (literal,))
        return model.add(Interval(start, length, end, (literal,)))


def count_heads(model: Model, crew: Crew, spans: Spans, capacity: int) -> None:
    """No more roles at once than robots."""
    if capacity == 1:
        model.add(NoOverlap(tuple(spans.of(role) for role in crew.roles)))
    elif len(crew.roles) > capacity:
        model.add(Cumulative(tuple(spans.of(role) for role in crew.roles), capacity))


def add_heads(model: Model, problem: Problem, crew: Crew, spans: Spans) -> Staff | None:
    """One role at a time for every robot of a crew without travel; its literals, where it matters who it is."""
    if not matters_who(problem, crew):
        count_heads(model, crew, spans, crew.usable)
        return None
    staff = Staff(model, problem, crew)
    staff.taking_part()
    staff.budgets()
    for number, member in enumerate(crew.members):
        for role in crew.roles:
            fills = staff.fills[problem.staffing.group_of[role], number]
            model.at_least(spans.start(role), Affine(None, member.since), 0, (fills,))
            if member.until is not None:
                model.at_least(Affine(None, member.until), spans.end(role), 0, (fills,))
        taken = [(role, staff.fills[problem.staffing.group_of[role], number]) for role in crew.roles]
        model.add(NoOverlap(tuple(spans.by(role, lit) for role, lit in taken if lit != model.false)))
    count_heads(model, crew, spans, crew.usable)
    return staff
