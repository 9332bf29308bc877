"""Small builders that tests of composing share: understood clauses, written down as what they ask for."""

from __future__ import annotations

from typing import Any

from missiontree.authoring.composing.composition import Composition
from missiontree.authoring.methods.mention import Mention
from missiontree.authoring.methods.outline import Outline, Piece, leaf_of
from missiontree.authoring.reading.clause import Clause, Relation
from missiontree.authoring.reading.outcomes import Goal
from missiontree.authoring.reading.words import words_of_text
from missiontree.routines.library import built_in

LIBRARY = built_in()


def do(routine: str, *mentions: str | Mention) -> Piece:
    """A routine about somebody; a text stands for an animal of that name."""
    named = tuple(m if isinstance(m, Mention) else Mention(m, m, m, "animal") for m in mentions)
    return leaf_of(LIBRARY.by_id[routine], named)


def goal(text: str, *pieces: Piece, relation: Relation = "start", anchor: int | None = None, **clause: Any) -> Goal:
    """A clause that is understood."""
    return Goal(Clause(words_of_text(text), relation=relation, anchor=anchor, **clause), Outline(list(pieces)), text)


def composition(*pieces: Piece) -> Composition:
    """Pieces below one objective, not linked yet."""
    return Composition(Outline(list(pieces)))


def links(made: Composition) -> list[tuple[str, ...]]:
    """Links by label; the kind only if it is no precedence."""
    return [
        (first.label, second.label, *([kind] if kind != "precedence" else []))
        for first, second, kind in made.outline.links
    ]


def shape(piece: Piece) -> object:
    """The label of a routine; of a task its label, its gate and what it consists of."""
    return piece.label if piece.routine else (piece.label, piece.gate, [shape(below) for below in piece.pieces])
