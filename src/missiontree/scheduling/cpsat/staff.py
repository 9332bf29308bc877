"""Who fills what: a literal per group of roles and robot, where that matters."""

from __future__ import annotations

import math

from missiontree.scheduling.cpsat.crew import Crew, tight_budgets, uses_of
from missiontree.scheduling.cpsat.model import AtMostOne, ExactlyOne, Linear, Model, negated
from missiontree.scheduling.impossible import TOLERANCE
from missiontree.scheduling.problem import Problem

MOST_FACTOR = 1 << 26
"""Of a unit per millimetre: with more, sums could be too large for the solver. Less is asked instead."""
_WHOLE = 1 << 36


class Staff:
    """
    The literals of one crew.

    Parameters
    ----------
    model, problem, crew
        What is built, of what, for whom.
    """

    def __init__(self, model: Model, problem: Problem, crew: Crew) -> None:
        self._model, self._problem, self.crew = model, problem, crew
        self.fills: dict[tuple[int, int], int] = {}  # by group and number of the member
        first_of_class = {number: crew.classes.index(number) for number in crew.classes}
        for rank, group in enumerate(crew.groups):
            for number in range(len(crew.members)):
                # equal robots: the first group takes the first of them, the next one the first or second, and so on
                late = number - first_of_class[crew.classes[number]] > rank
                self.fills[group, number] = model.false if late else model.boolean()
            model.add(ExactlyOne(tuple(self.fills[group, number] for number in range(len(crew.members)))))
        for first, second in crew.apart:
            for number in range(len(crew.members)):
                model.add(AtMostOne((self.fills[first, number], self.fills[second, number])))

    def taking_part(self) -> None:
        """Who must take part does, and no more do than may."""
        crew, model = self.crew, self._model
        for number, member in enumerate(crew.members):
            if member.required:
                model.clause(*(self.fills[group, number] for group in crew.groups))
        if crew.usable < len(crew.members):
            takes_part = [model.boolean() for _ in crew.members]
            for (_, number), literal in self.fills.items():
                model.implies((literal,), takes_part[number])
            model.add(Linear(tuple((1, literal) for literal in takes_part), 0, crew.usable))

    def budgets(self) -> None:
        """What a robot's roles use, it has."""
        for name in tight_budgets(self._problem, self.crew):
            needs: dict[int, float] = {}
            for role in self.crew.roles:
                group = self._problem.staffing.group_of[role]
                needs[group] = needs.get(group, 0.0) + uses_of(self._problem, role).get(name, 0.0)
            for number, member in enumerate(self.crew.members):
                if name not in member.budget:
                    continue
                scale = scale_of(member.budget[name])
                terms, spare = [], whole(member.budget[name], scale)
                for group, need in needs.items():
                    literal, amount = self.fills[group, number], least_whole(need, scale)
                    if literal >= 0:
                        terms.append((amount, literal))
                    else:
                        assert literal == self._model.false
                        assert negated(literal) == self._model.true
                self._model.add(Linear(tuple(terms), 0, spare))


def scale_of(amount: float) -> float:
    """By what an amount and what is taken from it are multiplied, so that whole numbers say them well enough."""
    return _WHOLE / max(amount, 1e-9) if amount < _WHOLE else 1.0


def whole(there: float, scale: float) -> int:
    """What is there, rounded up: the model may allow a little too much, and what it allows is tried out afterwards."""
    return math.ceil((there + TOLERANCE) * scale) + 1


def least_whole(needed: float, scale: float) -> int:
    """What is needed, rounded down."""
    return max(0, math.floor(needed * scale * (1 - 1e-12)) - 1)
