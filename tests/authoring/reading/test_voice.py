"""What is to be done, said in another way than as an order."""

from __future__ import annotations

import pytest

from missiontree.authoring.language.lexicon import Verb
from missiontree.authoring.reading.voice import active, caused, past_verb
from missiontree.authoring.reading.words import words_of_text
from tests.authoring.reading.heard import LEXICON, shown


def turned(text: str, *, is_event: bool = False) -> str:
    return shown(active(list(words_of_text(text)), LEXICON, is_event=is_event))


@pytest.mark.parametrize(
    ("text", "order"),
    [
        ("the forklift must be found", "find the forklift"),
        ("the forklift has to be found", "find the forklift"),
        ("the crate should be carried to the hall", "carry the crate to the hall"),
        ("the dog needs to be looked for", "look for the dog"),
        ("must the gate be reached", "reach the gate"),
        ("find the forklift", "find the forklift"),
        ("the forklift must be red", "the forklift must be red"),
    ],
)
def test_passive_is_turned_round(text: str, order: str) -> None:
    assert turned(text) == order


@pytest.mark.parametrize(
    ("text", "order"),
    [
        ("the forklift is found", "find the forklift"),
        ("the forklift has been found", "find the forklift"),
        ("the crate gets carried to the hall", "carry the crate to the hall"),
        ("you have found the forklift", "find the forklift"),
        ("the robots have found the forklift", "find the forklift"),
        ("found the forklift", "find the forklift"),
    ],
)
def test_what_happens_is_done_only_if_something_waits_for_it(text: str, order: str) -> None:
    assert turned(text, is_event=True) == order
    assert turned(text) == text


def test_who_is_no_robot_does_not_do_it() -> None:
    assert turned("Anna has found the forklift", is_event=True) == "Anna has found the forklift"


@pytest.mark.parametrize(
    ("text", "order"),
    [
        ("have the crate moved to the hall", "move the crate to the hall"),
        ("I need the crate taken to the hall", "take the crate to the hall"),
        ("make sure that the crate is brought to Anna", "bring the crate to Anna"),
        ("I want the crate to be carried to Anna", "carry the crate to Anna"),
    ],
)
def test_what_shall_be_done_by_somebody_is_done(text: str, order: str) -> None:
    assert shown(caused(list(words_of_text(text)), LEXICON)) == order


@pytest.mark.parametrize(
    "text",
    [
        "move the crate to the hall",
        "get the lost cat",
        "get the crate that moved",
        "have the crate",
        "get the found bag",  # behind an article it only describes
    ],
)
def test_other_words_stay_as_they_are(text: str) -> None:
    words = list(words_of_text(text))
    assert caused(words, LEXICON) == words


def test_past_of_a_verb_that_asks_whoever_moves_is_that_of_the_plain_verb() -> None:
    assert past_verb(["moved", "to", "the", "hall"], 0, LEXICON) == Verb("move", "past", 1)
    assert past_verb(["looked", "for", "it"], 0, LEXICON) == Verb("look for", "past", 2)
    assert past_verb(["find"], 0, LEXICON) is None
