"""What is said of somebody behind their name."""

from __future__ import annotations

import pytest

from missiontree.authoring.reading.describing import Descriptions
from missiontree.authoring.reading.words import words_of_text
from tests.authoring.reading.heard import LEXICON

TOLD = Descriptions(LEXICON)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "trapped in a building on fire",
        "who is lost",
        "with the red seat",
        "that ran away yesterday",
        "who came to fix the lamp",  # a purpose of theirs, and not of the mission
        "in block A",
        "on floor 3",
    ],
)
def test_description(text: str) -> None:
    assert TOLD.describe(words_of_text(text))


@pytest.mark.parametrize(
    "text",
    [
        "in",  # of what
        "who",
        "on the table next",  # to what
        "with it",
        "using the lift",
        "or the lab",
        "to the hall",
        "in ten minutes",
        "at 5 pm",
        "quickly",
        "if it rains",
        "by the tele-robot",
        "in (somewhere)",
    ],
)
def test_words_that_may_mean_something_else(text: str) -> None:
    assert not TOLD.describe(words_of_text(text))


@pytest.mark.parametrize("text", ["who is lost", "who ran away", "lost in the forest", "missing since Monday"])
def test_lost(text: str) -> None:
    assert TOLD.say_lost(words_of_text(text))


@pytest.mark.parametrize(
    "text", ["who lost the match", "whose dog is lost", "with the lost", "in the hall", "following the lost"]
)
def test_not_lost(text: str) -> None:
    assert not TOLD.say_lost(words_of_text(text))
