"""Lists of noun phrases."""

from __future__ import annotations

import pytest

from missiontree.authoring.language.lexicon import PhraseTable
from missiontree.authoring.reading.listing import is_letter, parts_of
from missiontree.authoring.reading.words import words_of_text
from tests.authoring.reading.heard import shown

NAMES = PhraseTable({("salt", "and", "pepper"): "salt and pepper"})


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("the bed", ["the bed"]),
        ("the bed and the chair", ["the bed", "the chair"]),
        ("the bed, the chair, and the lamp", ["the bed", "the chair", "the lamp"]),
        ("the bed & the chair", ["the bed", "the chair"]),
        ("docks 1, 2 and 3", ["dock 1", "dock 2", "dock 3"]),
        ("blocks A and B", ["block A", "block B"]),
        ("dock 1 and gate 2", ["dock 1", "gate 2"]),
        ("the white and the black van", ["the white van", "the black van"]),
        ("the larch and the red pine", ["the larch", "the red pine"]),
        ("the wug and the blorp press", ["the wug", "the blorp press"]),  # an unknown noun is no adjective
        ("the white and black vans", ["the white vans", "black vans"]),
        ("the white and black van", ["the white and black van", "black van"]),  # one or two: nobody knows
        ("the white door and the black van", ["the white door", "the black van"]),
        ("the path between the hall and the yard", ["the path between the hall and the yard"]),
        ("salt and pepper and the bread", ["salt and pepper", "the bread"]),
    ],
)
def test_parts_of_a_list(text: str, parts: list[str]) -> None:
    assert [shown(part) for part in parts_of(words_of_text(text), NAMES)] == parts


@pytest.mark.parametrize(("text", "letter"), [("A", True), ("a", False), ("AB", False), ("1", False)])
def test_capital_tells_things_apart(text: str, letter: bool) -> None:
    (word,) = words_of_text(text)
    assert is_letter(word) is letter
