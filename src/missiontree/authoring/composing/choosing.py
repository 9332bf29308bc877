"""Clauses of which one is done, below one task."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.authoring.composing.composition import Composition
from missiontree.authoring.composing.ordering import order_as_said
from missiontree.authoring.composing.units import Unit
from missiontree.authoring.methods.mention import heading
from missiontree.authoring.methods.outline import Piece
from missiontree.authoring.reading.outcomes import Goal
from missiontree.mission.routine import RoutineLibrary


def chosen(
    unit: Unit, goals: Sequence[Goal], tops: list[list[Piece]], library: RoutineLibrary, made: Composition
) -> None:
    """Hang the options of a choice below one task, which from then on stands for all of their clauses."""
    if len(unit.options) < 2:
        return
    options: list[Piece] = []
    where = min(made.outline.pieces.index(piece) for index in unit.indexes for piece in tops[index])
    for option in unit.options:
        inner = [Unit(((index,),)) for index in option]
        order_as_said(goals, tops, inner, library, made)
        pieces = [piece for index in option for piece in tops[index]]
        text = ", ".join(goals[index].clause.text for index in option)
        options.append(pieces[0] if len(pieces) == 1 else Piece(heading(text), pieces=pieces))
    for index in unit.indexes:
        made.outline.pieces = [piece for piece in made.outline.pieces if piece not in tops[index]]
    label = " or ".join(goals[option[0]].clause.text for option in unit.options)
    choice = Piece(heading(label), pieces=options, gate="xor")
    made.outline.pieces.insert(where, choice)
    for index in unit.indexes:
        tops[index] = [choice]
