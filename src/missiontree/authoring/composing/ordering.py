"""The order of clauses as it was said: then, before, after, while, until."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from missiontree.authoring.composing.composition import Composition
from missiontree.authoring.composing.units import Unit
from missiontree.authoring.methods.outline import Piece
from missiontree.authoring.reading.clause import Relation
from missiontree.authoring.reading.outcomes import Goal
from missiontree.mission.reason import Reason
from missiontree.mission.routine import RoutineLibrary


def order_as_said(
    goals: Sequence[Goal],
    tops: Sequence[list[Piece]],
    units: Sequence[Unit],
    library: RoutineLibrary,
    made: Composition,
) -> None:
    """Then, before, after, while, until, among units; the first of them has nothing before it."""
    stage: list[Piece] = []
    earlier: list[Piece] = []
    relations = _relations(goals)
    beside = _beside(tops, relations)
    closing = [piece for number, goal in enumerate(goals) if goal.clause.closes for piece in tops[number]]
    for unit in units:
        index = unit.indexes[0]
        _all_before([piece for piece in tops[index] if piece not in closing], closing, made)
        goal, pieces, (relation, anchor) = goals[index], tops[index], relations[index]
        others = _anchored(goals, tops, index, anchor)
        if relation in {"before", "after"}:
            first, second = (others, pieces) if relation == "before" else (pieces, others)
            _all_before(first, second, made)
        elif relation == "earlier":
            before = [piece for number in range(index) for piece in tops[number]] if goal.clause.opens else others
            _all_before(pieces, before, made)
        elif relation == "meanwhile" and stage:
            _alongside(goal, "while", pieces, stage, library, made)
            stage = [*stage, *pieces]
        elif relation in {"while", "until"}:
            _alongside(goal, relation, pieces, others, library, made)
        else:
            if relation == "then":
                stage, earlier = [], stage
            elif relation == "start":
                stage, earlier = [], []
                openings = [number for number in range(index) if goals[number].clause.opens]
                for number in openings:
                    _all_before(tops[number], pieces, made)
            together = [*pieces, *beside.get(index, [])]
            _all_before(earlier, together, made)
            stage = [*stage, *together, *_ending(index, tops, relations)]
            if goal.clause.in_order and relation == "and":
                _one_after_the_other(index, goals, tops, made)


def _one_after_the_other(last: int, goals: Sequence[Goal], tops: Sequence[list[Piece]], made: Composition) -> None:
    """Link the clauses that *and* joins, up to one that says "in that order"."""
    run = [last]
    while run[0] > 0 and goals[run[0]].clause.relation == "and":
        run.insert(0, run[0] - 1)
    for first, second in pairwise(run):
        _all_before(tops[first], tops[second], made)


def _anchored(goals: Sequence[Goal], tops: Sequence[list[Piece]], index: int, anchor: int | None) -> list[Piece]:
    """What a clause is joined to; one that leads a sentence is said of all that *and* joins behind it."""
    if anchor is None or anchor >= len(tops):
        return []
    others = list(tops[anchor])
    if anchor > index and goals[index].clause.relation in {"before", "after", "while"}:
        for number in range(anchor + 1, len(goals)):
            clause = goals[number].clause
            if clause.relation != "and" or clause.sentence != goals[anchor].clause.sentence:
                break
            others += [piece for piece in tops[number] if piece not in others]
    return others


def _beside(tops: Sequence[list[Piece]], relations: Sequence[tuple[Relation, int | None]]) -> dict[int, list[Piece]]:
    """What goes on while each clause does: a "then" before or behind that clause is said of both."""
    beside: dict[int, list[Piece]] = {}
    for index, pieces in enumerate(tops):
        main: int | None = index
        for _ in relations:  # "while this, while that, do it": both go on beside the last
            if main is None or main >= len(tops) or relations[main][0] != "while":
                break
            main = relations[main][1]
        if main is not None and main != index and main < len(tops):
            beside.setdefault(main, []).extend(piece for piece in pieces if piece not in tops[main])
    return beside


def _ending(index: int, tops: Sequence[list[Piece]], relations: Sequence[tuple[Relation, int | None]]) -> list[Piece]:
    """What a clause lasts until: in "follow her until he is found, then go home", he is found before that."""
    ends = [number for number, relation in enumerate(relations) if relation == ("until", index)]
    return [piece for number in ends if number != index for piece in tops[number] if piece not in tops[index]]


def _relations(goals: Sequence[Goal]) -> list[tuple[Relation, int | None]]:
    """How each clause is joined; one that shares the object of the next stands where that one stands."""
    relations: list[tuple[Relation, int | None]] = [(goal.clause.relation, goal.clause.anchor) for goal in goals]
    for index in range(len(goals) - 2, -1, -1):
        if relations[index][0] == "shares":
            relations[index] = relations[index + 1]
            if relations[index][0] not in {"before", "after", "while", "until"}:
                relations[index + 1] = ("and", index)
    return relations


def _all_before(first: Sequence[Piece], second: Sequence[Piece], made: Composition) -> None:
    for one in first:
        for other in second:
            made.outline.link(one, other)


def _alongside(
    goal: Goal, relation: Relation, own: list[Piece], main: list[Piece], library: RoutineLibrary, made: Composition
) -> None:
    """While and until: what is open-ended lasts until the other has ended."""
    own_open, main_open = (any(piece.open_ended(library) for piece in pieces) for pieces in (own, main))
    pairs = [(one, other) for one in main for other in own]
    if main_open and not (own_open and relation == "while"):
        for one, other in pairs:
            if one.open_ended(library):
                made.outline.link(one, other, "until")
    elif own_open and not main_open and relation == "while":
        for one, other in pairs:
            if other.open_ended(library):
                made.outline.link(other, one, "until")
    elif relation == "until":
        message = f"'until {goal.clause.text}': what comes before it ends by itself, so nothing can last until then."
        made.doubts.append(
            Reason(
                rule="until_without_open_end",
                message=message,
                found=goal.clause.text,
                hint="Only following lasts; say 'before' or 'then' for an order.",
            )
        )
