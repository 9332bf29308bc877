"""Several readings of one clause to one goal: a choice between them, or all of them."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.authoring.methods.mention import title
from missiontree.authoring.methods.outline import Outline, Piece
from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.outcomes import Goal
from missiontree.mission.reason import Reason


def choice_of(clause: Clause, goals: Sequence[Goal]) -> Goal:
    """One of the goals is done; if all ask for the same, that is what is done."""
    distinct: list[Goal] = []
    for goal in goals:
        if all(_calls(goal) != _calls(other) for other in distinct):
            distinct.append(goal)
    outline = distinct[0].outline
    shared = [call for call in _calls(distinct[0]) if all(call in _calls(goal) for goal in distinct)]
    if len(distinct) > 1 and shared and not any(goal.outline.links for goal in distinct):
        common = [piece for piece in outline.pieces if piece.routine is not None and piece.call in shared]
        for goal in distinct:
            goal.outline.pieces = [p for p in goal.outline.pieces if p.routine is None or p.call not in shared]
        rest = [goal for goal in distinct if goal.outline.pieces]
        if len(rest) == len(distinct):
            options = [option_of([goal.outline], goal.clause.text) for goal in rest]
            outline = Outline([*common, Piece(title(clause.text), pieces=options, gate="xor")])
    elif len(distinct) > 1:
        options = [option_of([goal.outline], goal.clause.text) for goal in distinct]
        links = [link for goal in distinct for link in goal.outline.links]
        outline = Outline([Piece(title(clause.text), pieces=options, gate="xor")], links)
    return Goal(clause, outline, _told("or", goals), _assumptions(goals), min(goal.slots for goal in goals))


def both_of(clause: Clause, goals: Sequence[Goal]) -> Goal:
    """All of the goals are done."""
    pieces = [piece for goal in goals for piece in goal.outline.pieces]
    links = [link for goal in goals for link in goal.outline.links]
    slots = min(goal.slots for goal in goals)
    return Goal(clause, Outline(pieces, links), _told("and", goals), _assumptions(goals), slots)


def option_of(outlines: Sequence[Outline], label: str) -> Piece:
    """One piece for an option of a choice."""
    pieces = [piece for outline in outlines for piece in outline.pieces]
    return pieces[0] if len(pieces) == 1 else Piece(title(label), pieces=pieces)


def _calls(goal: Goal) -> list[tuple[object, ...]]:
    return [leaf.call for piece in goal.outline.pieces for leaf in piece.leaves]


def _told(word: str, goals: Sequence[Goal]) -> str:
    return f" {word} ".join(dict.fromkeys(goal.reading for goal in goals))


def _assumptions(goals: Sequence[Goal]) -> tuple[Reason, ...]:
    return tuple(dict.fromkeys(reason for goal in goals for reason in goal.assumptions))
