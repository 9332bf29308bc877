"""What several clauses come to: one outline, and what was added to it or cannot be kept."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from missiontree.authoring.methods.mention import Mention
from missiontree.authoring.methods.outline import Outline, Piece
from missiontree.mission.reason import Reason

EVENTS = frozenset({"before", "after", "until", "while"})
"""How clauses are joined that tell when, rather than what."""


@dataclass
class Composition:
    """
    What all clauses come to.

    Parameters
    ----------
    outline
        Everything below the objective.
    implied
        Precedence that nobody said; left out should it contradict what was said.
    notices
        What was added on the operator's behalf.
    doubts
        What was said and cannot be kept.
    """

    outline: Outline = field(default_factory=Outline)
    implied: list[tuple[Piece, Piece]] = field(default_factory=list)
    notices: list[Reason] = field(default_factory=list)
    doubts: list[Reason] = field(default_factory=list)


def mentions_of(outline: Outline) -> tuple[Mention, ...]:
    """Everybody that the routines of an outline are about, each once, in order."""
    by_name: dict[str, Mention] = {}
    for leaf in leaves(outline):
        for mention in leaf.mentions:
            by_name.setdefault(mention.name, mention)
    return tuple(by_name.values())


def leaves(outline: Outline) -> Iterator[Piece]:
    """The routines of an outline, in order."""
    for piece in outline.pieces:
        yield from piece.leaves
