"""How many are meant."""

from __future__ import annotations

import pytest

from missiontree.authoring.reading.quantity import Quantity, number_of, quantity_of
from missiontree.authoring.reading.words import words_of_text


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("all patients", Quantity(1, determined=True, every=True)),
        ("all the patients", Quantity(2, determined=True, every=True)),
        ("every bed", Quantity(1, determined=True, every=True)),
        ("every single bed", Quantity(2, determined=True, every=True)),
        ("each of the beds", Quantity(3, determined=True, every=True)),
        ("both dogs", Quantity(1, determined=True, every=True, count=2)),
        ("all three crates", Quantity(2, determined=True, every=True, count=3)),
        ("three crates", Quantity(1, determined=True, count=3)),
        ("the three crates", Quantity(2, determined=True, count=3)),
        ("my 12 crates", Quantity(2, determined=True, count=12)),
        ("the other one", Quantity(2, determined=True, other=True)),
        ("the other two crates", Quantity(3, determined=True, count=2, other=True)),
        ("the two other crates", Quantity(3, determined=True, count=2, other=True)),
        ("the second crate", Quantity(2, determined=True, ordinal=2)),
        ("some crates", Quantity(1)),  # it takes a word and says nothing
    ],
)
def test_what_stands_before_the_noun(text: str, expected: Quantity) -> None:
    assert quantity_of(words_of_text(text)) == expected


@pytest.mark.parametrize(
    "text",
    [
        "",
        "the crate",
        "crates",
        "some",
        "some of the crates",  # how many, nobody knows
        "any other crate",
        "second crate",  # without an article it is a name
        "the first aid kit",  # "first" belongs to the name
        "the first",  # and nothing behind it
        "21 crates",
        "1 crate",
        "three",
        "room 12",
    ],
)
def test_what_says_no_number(text: str) -> None:
    assert quantity_of(words_of_text(text)) == Quantity()


def test_every_single_is_said_of_one_and_not_of_all() -> None:
    # "all single beds" are those for one person, so that "single" stays with the noun.
    assert quantity_of(words_of_text("all single beds")).length == 1


@pytest.mark.parametrize(
    ("word", "number"),
    [("two", 2), ("twelve", 12), ("2", 2), ("20", 20), ("21", None), ("1", None), ("0", None), ("one", None)],
)
def test_numbers_from_two_to_twenty_are_counted(word: str, number: int | None) -> None:
    assert number_of(word) == number


@pytest.mark.parametrize("word", ["²", "٣", "1.5", "two-fold", "9" * 5000])
def test_what_only_looks_like_a_number_is_none(word: str) -> None:
    assert number_of(word) is None
