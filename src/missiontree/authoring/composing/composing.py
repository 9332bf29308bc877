"""Several understood clauses to one outline: the order that was said, and the order that follows from what is lost."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from missiontree.authoring.composing.choosing import chosen
from missiontree.authoring.composing.composition import EVENTS, Composition
from missiontree.authoring.composing.ordering import order_as_said
from missiontree.authoring.composing.reduction import without_implied
from missiontree.authoring.composing.searching import (
    brought_before_returned,
    found_before_used,
    search_first,
    search_once,
)
from missiontree.authoring.composing.units import units_of
from missiontree.authoring.methods.mention import heading
from missiontree.authoring.methods.outline import Outline, Piece
from missiontree.authoring.reading.outcomes import Goal
from missiontree.mission.routine import RoutineLibrary


def composed(goals: Sequence[Goal], library: RoutineLibrary) -> Composition:
    """Put the clauses together below one objective."""
    made = Composition()
    goals = _asked_in_full(goals)
    search_once(goals, library, made)
    building = sum(bool(goal.outline.pieces) for goal in goals)
    tops: list[list[Piece]] = []
    for goal in goals:
        event = _named_again(goal, made.outline)
        tops.append(event or (_top(goal, made.outline) if building > 1 else goal.outline.pieces))
        made.outline.pieces += [] if event else tops[-1]
        made.outline.links += goal.outline.links
    units = units_of(goals, made.doubts)
    for unit in units:
        chosen(unit, goals, tops, library, made)
    order_as_said(goals, tops, units, library, made)
    search_first(goals, library, made)
    found_before_used(library, made)
    brought_before_returned(goals, made)
    made.implied = without_implied(made.outline, made.implied)
    return made


def _asked_in_full(goals: Sequence[Goal]) -> list[Goal]:
    """The goals; nothing is left to be built of what a clause asks for again, or what somebody needs and a later clause asks for."""
    kept: list[Goal] = []
    for number, goal in enumerate(goals):
        later = {leaf.call for other in goals[number + 1 :] for piece in other.outline.pieces for leaf in piece.leaves}
        calls = {leaf.call for piece in goal.outline.pieces for leaf in piece.leaves}
        before = {leaf.call for other in kept[-1:] for piece in other.outline.pieces for leaf in piece.leaves}
        again = goal.clause.relation == "and" and bool(calls) and calls <= before
        done = again or (goal.wished and calls <= later)
        kept.append(replace(goal, outline=Outline()) if done else goal)
    return kept


def _named_again(goal: Goal, outline: Outline) -> list[Piece]:
    """What an earlier clause asks for, if this one only names that as an event: "when it is found"."""
    if goal.clause.relation not in EVENTS or not goal.outline.pieces:
        return []
    standing = [leaf for piece in outline.pieces for leaf in piece.leaves]
    found = [next((leaf for leaf in standing if _stands(piece, [leaf])), None) for piece in goal.outline.pieces]
    return [leaf for leaf in found if leaf is not None] if None not in found else []


def _top(goal: Goal, outline: Outline) -> list[Piece]:
    """One piece for a clause: its own, or a task named by its words; none for a statement."""
    if not goal.outline.pieces:
        return []
    if len(goal.outline.pieces) == 1 and not _stands(goal.outline.pieces[0], outline.pieces):
        return goal.outline.pieces
    label, number = heading(goal.clause.text), 1
    while any(piece.routine is None and piece.label == label for piece in outline.pieces):
        number += 1
        label = f"{heading(goal.clause.text)} ({number})"
    return [Piece(label, pieces=goal.outline.pieces)]


def _stands(piece: Piece, pieces: Sequence[Piece]) -> bool:
    if piece.routine is None:
        return any(other.routine is None and other.label == piece.label for other in pieces)
    return any(other.routine is not None and other.call == piece.call for other in pieces)
