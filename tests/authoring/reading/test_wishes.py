"""What somebody needs, as an order to bring it."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree.authoring.reading.clause import Clause
from missiontree.authoring.reading.phrases import PhraseReader
from missiontree.authoring.reading.wishes import errand_of, wish_of
from tests.authoring.reading.heard import LEXICON, clause_of

PHRASES = PhraseReader(LEXICON)


def text_of(clause: Clause | None) -> str | None:
    assert clause is None or (clause.verb is not None and clause.verb.phrase == "bring")
    return None if clause is None else clause.text


@pytest.mark.parametrize(
    ("text", "order"),
    [
        ("Anna needs her keys", "bring her keys to Anna"),
        ("The old man wants the newspaper", "bring the newspaper to The old man"),
        ("The dog requires its medicine", "bring its medicine to The dog"),
        ("The kitchen needs the ladder", "bring the ladder to The kitchen"),
        ("Anna is waiting for the parcel", "bring the parcel to Anna"),
        ("Anna would like the ball and the bag", "bring the ball and the bag to Anna"),
        ("We need the ladder in the hall", "bring the ladder to the hall"),
        ("I want the parcel at the gate", "bring the parcel to the gate"),
        ("The ladder is needed in the hall", "bring The ladder to the hall"),
        ("The keys are wanted by Anna", "bring The keys to Anna"),
        ("Anna needs either the ball or the bag", "bring either the ball or the bag to Anna"),
    ],
)
def test_need_is_an_order_to_bring(text: str, order: str) -> None:
    assert text_of(wish_of(clause_of(text), PHRASES, LEXICON)) == order


@pytest.mark.parametrize(
    "text",
    [
        "Anna is in the hall",
        "We need the ladder",  # and nobody says where
        "We need the ladder in the afternoon",
        "The box needs the lid",  # a box receives nothing
        "Anna needs the kitchen",  # and nobody can bring that
        "She needs the keys",
        "Anna needs them",
        "Anna and Bob need the keys",  # one of them, or both
        "Anna needs",
        "It is needed in the hall",
        "The ladder is needed there",
    ],
)
def test_no_wish_that_can_be_served(text: str) -> None:
    assert wish_of(clause_of(text), PHRASES, LEXICON) is None


def test_need_that_only_tells_when_is_no_order() -> None:
    for text in ("Anna needs her keys", "The ladder is needed in the hall"):
        clause = replace(clause_of(text), relation="before")
        assert wish_of(clause, PHRASES, LEXICON) is None


@pytest.mark.parametrize(
    ("text", "order"),
    [
        ("the crate to dock 3", "bring the crate to dock 3"),
        ("Crate to dock 3", "bring crate to dock 3"),
        ("Anna to the lobby", "bring Anna to the lobby"),
        ("the crate and the bag to Anna", "bring the crate and the bag to Anna"),
        ("the crate to the hall or to the lab", "bring the crate to the hall or to the lab"),
        ("the crate to the hall and the bag to the lab", "bring the crate to the hall and the bag to the lab"),
    ],
)
def test_clause_without_a_verb_is_an_errand(text: str, order: str) -> None:
    assert text_of(errand_of(clause_of(text), PHRASES, LEXICON)) == order


@pytest.mark.parametrize(
    "text",
    [
        "the crate",
        "to the hall",
        "the crate to",
        "it to the hall",
        "the hall to the gate",  # no place is brought anywhere
        "the crate to the hall to the gate",
        "the drone to the hall",  # rather an order to the drone
        "the blorp to the hall",  # what is no known noun is not guessed at
        "the crate quickly moved to the hall",
    ],
)
def test_no_errand(text: str) -> None:
    assert errand_of(clause_of(text), PHRASES, LEXICON) is None
