"""Signs and names of places that the parts of the page share."""

from __future__ import annotations

from missiontree.evaluation.in_words import VERDICT_NAMES
from missiontree.evaluation.verdict import VerdictKind

MARKS: dict[VerdictKind, str] = {
    "right": "✓",
    "wrong": "✗",
    "declined_though_possible": "∅",
    "wrong_decline": "≠",
    "no_answer": "…",
}
"""A sign for each verdict, so that colour is never needed to tell them apart."""


def marked(kind: VerdictKind) -> str:
    """A verdict with its sign, in its colour."""
    return f'<span class="mark {kind}">{MARKS[kind]} {VERDICT_NAMES[kind]}</span>'


def anchor(mission: str, model: int | None = None) -> str:
    """Where the page tells of a mission, or of what one model made of it; ids hold no dot, so no two places are called alike."""
    return f"m.{mission}" if model is None else f"m.{mission}.{model}"
