"""A draft as values of a model, for the solver to begin with."""

from __future__ import annotations

import itertools
from collections.abc import Iterable

from missiontree.scheduling.cpsat.crew import Crew
from missiontree.scheduling.cpsat.formulation import Formulation
from missiontree.scheduling.cpsat.model import negated
from missiontree.scheduling.cpsat.staff import Staff
from missiontree.scheduling.cpsat.tours import Tours
from missiontree.scheduling.problem import Draft


def hint(formulation: Formulation, draft: Draft) -> None:
    """Set the hint of a formulation's model to a draft, as far as the draft tells."""
    _Hint(formulation, draft).set()


class _Hint:
    def __init__(self, formulation: Formulation, draft: Draft) -> None:
        self._formulation, self._draft = formulation, draft
        self._model, self._graph = formulation.model, formulation.problem.graph
        self._done = {one.leaf: one for one in draft.done}

    def set(self) -> None:
        model, times = self._model, self._formulation.times
        model.hint.clear()
        model.hint[times.makespan] = self._draft.makespan
        for activity in range(len(self._graph.activities)):
            start, end = self._span(activity)
            if times.start[activity].var is not None:
                model.hint[times.start[activity].var or 0] = start
            if times.end[activity].offset == 0 and times.end[activity].var is not None:
                model.hint[times.end[activity].var or 0] = end
        for (open_ended, one), literal in times.latest.items():
            self._literal(literal, self._span(one)[1] > self._span(open_ended)[0])
        for (first, second), literal in self._formulation.ordering.literals.items():
            self._literal(literal, self._span(first) <= self._span(second))
        for leaf, where in self._formulation.stations.where.items():
            trip = self._done[leaf].trip
            for spot, literal in where.items():
                self._literal(literal, trip is not None and trip.destination == spot)
        for crew, staff in self._formulation.heads:
            self._staff(staff, self._numbers(crew))
        for tours in self._formulation.tours:
            self._tours(tours)
        model.hint.pop(model.true, None)

    def _span(self, activity: int) -> tuple[int, int]:
        one = self._done[self._graph.activities[activity][0]]
        return one.start, one.end

    def _literal(self, literal: int, holds: bool) -> None:
        if literal in (self._model.true, self._model.false):
            return
        self._model.hint[literal if literal >= 0 else negated(literal)] = int(holds == (literal >= 0))

    def _numbers(self, crew: Crew) -> dict[int, int]:
        """Number of the member that fills each group; of equal robots, the first group takes the first."""
        taken: dict[str, int] = {}
        used = dict.fromkeys(crew.classes, 0)
        robot_of = {
            self._formulation.problem.staffing.group_of[role]: self._draft.robot_of[role] for role in crew.roles
        }
        for group in crew.groups:
            robot = robot_of[group]
            if robot not in taken:
                number = crew.class_of[robot]
                taken[robot] = crew.classes.index(number) + used[number]
                used[number] += 1
        return {group: taken[robot_of[group]] for group in crew.groups}

    def _staff(self, staff: Staff | None, numbers: dict[int, int]) -> None:
        if staff is not None:
            for (group, number), literal in staff.fills.items():
                self._literal(literal, numbers[group] == number)

    def _tours(self, tours: Tours) -> None:
        numbers = self._numbers(tours.crew)
        self._staff(tours.staff, numbers)
        taken: set[tuple[int, int]] = set()
        for number in range(len(tours.crew.members)):
            group_of = self._formulation.problem.staffing.group_of
            roles = self._in_order(role for role in tours.crew.roles if numbers[group_of[role]] == number)
            nodes = [0, 1 + number, *(tours.node(role) for role in roles), 0]
            taken |= set(itertools.pairwise(nodes))
        for arc, literal in tours.arcs.items():
            self._literal(literal, arc in taken)

    def _in_order(self, roles: Iterable[int]) -> list[int]:
        def span(role: int) -> tuple[int, int, int]:
            leaves = self._graph.roles[role]
            return self._done[leaves[0]].start, self._done[leaves[-1]].end, role

        return sorted(roles, key=span)
