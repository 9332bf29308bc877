"""Figures of speech."""

from __future__ import annotations

import pytest

from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.idioms import MOST_BETWEEN, idiom_in
from missiontree.authoring.reading.words import words_of_text
from tests.authoring.reading.heard import LEXICON, clause_of


@pytest.mark.parametrize(
    ("text", "idiom"),
    [
        ("give Anna a hand", "give ... hand"),
        ("give the old man a hand", "give ... hand"),
        ("give us a hand", "give hand"),
        ("give a hand to Anna", "give hand"),
        ("take a break", "take break"),
        ("bring the house down", "bring house down"),
        ("go to sleep", "go to sleep"),
        ("save the day", "save day"),
    ],
)
def test_figure_of_speech(text: str, idiom: str) -> None:
    assert idiom_in(clause_of(text), LEXICON) == idiom


@pytest.mark.parametrize(
    "text",
    [
        "give Anna the keys",
        "take the box to the hall",
        "bring the house",
        "go to the hall",
        "hand",
    ],
)
def test_plain_words(text: str) -> None:
    assert idiom_in(clause_of(text), LEXICON) == ""


def test_so_many_words_may_stand_between() -> None:
    for count, found in ((MOST_BETWEEN, True), (MOST_BETWEEN + 1, False)):
        words = " ".join(["old"] * (count - 1) + ["man"])
        assert bool(idiom_in(clause_of(f"give the {words} a hand"), LEXICON)) is found


def test_clause_without_a_verb_has_none() -> None:
    assert idiom_in(Clause(words_of_text("a hand")), LEXICON) == ""
