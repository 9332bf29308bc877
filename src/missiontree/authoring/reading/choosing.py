"""Several readings of one clause to one goal: a choice between them, or all of them."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.authoring.methods.mention import heading
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
    if len(distinct) > 1:
        shared = _shared(distinct)
        options = [option_of(_without(goal.outline, shared), goal.clause.text) for goal in distinct]
        links = [link for goal in distinct for link in goal.outline.links]
        common = [piece for piece in outline.pieces if piece.routine is not None and piece.call in shared]
        outline = Outline([*common, Piece(heading(clause.text), pieces=options, gate="xor")], links)
    return Goal(
        clause,
        outline,
        _told("or", goals),
        _assumptions(goals),
        min(goal.slots for goal in goals),
        standing=goals[0].standing,
    )


def both_of(clause: Clause, goals: Sequence[Goal]) -> Goal:
    """All of the goals are done."""
    pieces = [piece for goal in goals for piece in goal.outline.pieces]
    links = [link for goal in goals for link in goal.outline.links]
    slots = min(goal.slots for goal in goals)
    return Goal(
        clause, Outline(pieces, links), _told("and", goals), _assumptions(goals), slots, standing=goals[0].standing
    )


def option_of(pieces: Sequence[Piece], label: str) -> Piece:
    """One piece for an option of a choice."""
    return pieces[0] if len(pieces) == 1 else Piece(heading(label), pieces=list(pieces))


def _shared(goals: Sequence[Goal]) -> list[tuple[object, ...]]:
    """What all options ask for, and is therefore no part of the choice; nothing if links hold it, or an option is no more than that."""
    shared = [call for call in _calls(goals[0]) if all(call in _calls(goal) for goal in goals)]
    alone = any(not _without(goal.outline, shared) for goal in goals)
    return [] if alone or any(goal.outline.links for goal in goals) else shared


def _without(outline: Outline, shared: Sequence[tuple[object, ...]]) -> list[Piece]:
    return [piece for piece in outline.pieces if piece.routine is None or piece.call not in shared]


def _calls(goal: Goal) -> list[tuple[object, ...]]:
    return [leaf.call for piece in goal.outline.pieces for leaf in piece.leaves]


def _told(word: str, goals: Sequence[Goal]) -> str:
    return f" {word} ".join(dict.fromkeys(goal.reading for goal in goals))


def _assumptions(goals: Sequence[Goal]) -> tuple[Reason, ...]:
    return tuple(dict.fromkeys(reason for goal in goals for reason in goal.assumptions))
