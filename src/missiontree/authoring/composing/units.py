"""Which clauses stand together as one choice: "either do this or do that"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from missiontree.authoring.reading.outcomes import Goal
from missiontree.mission.reason import Reason


@dataclass(frozen=True, slots=True)
class Unit:
    """Clauses by index, option by option; most units are one clause."""

    options: tuple[tuple[int, ...], ...]

    @property
    def indexes(self) -> tuple[int, ...]:
        """All clauses of the unit, in order."""
        return tuple(index for option in self.options for index in option)


def units_of(goals: Sequence[Goal], doubts: list[Reason]) -> list[Unit]:
    """
    The units of a mission, in order.

    Parameters
    ----------
    goals
        What the clauses ask for.
    doubts
        Where it is not clear how far a choice reaches, a reason is added.
    """
    units: list[list[list[int]]] = []
    either = last = False  # within a choice that began with *either*; within its last option
    for index, goal in enumerate(goals):
        clause = goal.clause
        if clause.relation == "or" and units:
            first = units[-1][0][0]
            shared = first > 0 and goals[first - 1].clause.relation == "shares"
            if (not either and _joined(goals, units)) or shared:
                doubts.append(_unclear(clause.text))
            units[-1].append([index])
            last, either = either, False
        elif either and clause.relation == "and" and clause.listed:
            units[-1].append([index])
        elif (last and clause.relation == "and" and not clause.pause) or (
            either and clause.relation in {"and", "then", "shares"}
        ):
            units[-1][-1].append(index)
        else:
            if clause.relation == "and" and units and len(units[-1]) > 1:
                doubts.append(_unclear(clause.text))
            if (
                index
                and goals[index - 1].clause.relation == "shares"
                and any(word.low == "or" for word in clause.words)
            ):
                doubts.append(_unclear(clause.text))  # "weld and paint the mast or the rudder"
            units.append([[index]])
            last = False
            either = clause.either and _goes_on(goals, index)
            if clause.either and not either and not any(word.low == "or" for word in clause.words):
                doubts.append(_unclear(clause.text))
    return [Unit(tuple(tuple(option) for option in options)) for options in units]


def _goes_on(goals: Sequence[Goal], index: int) -> bool:
    """Whether a clause joined by *or* follows in the same sentence."""
    here = goals[index].clause.sentence
    return any(goal.clause.relation == "or" and goal.clause.sentence == here for goal in goals[index + 1 :])


def _joined(goals: Sequence[Goal], units: Sequence[list[list[int]]]) -> bool:
    """Whether what stands before an *or* is itself joined to another clause by *and*: "do this and that, or that"."""
    if len(units[-1]) > 1:
        return False
    return goals[units[-1][-1][0]].clause.relation == "and"


def _unclear(text: str) -> Reason:
    return Reason(
        rule="choice_unclear",
        message=f"It is not clear how far the choice before or at {text!r} reaches.",
        found=text,
        hint="Say 'either ... or ...' in a sentence of its own.",
    )
