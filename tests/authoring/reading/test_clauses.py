"""From text to clauses and noun phrases."""

from __future__ import annotations

import pytest

from missiontree.authoring.language.lexicon import Lexicon, gerund, regular_past
from missiontree.authoring.reading.clauses import clauses_of
from missiontree.authoring.reading.phrases import PhraseReader
from missiontree.authoring.reading.words import words_of_text

LEXICON = Lexicon()


def split(text: str) -> list[tuple[str, str, int | None]]:
    return [(clause.text, clause.relation, clause.anchor) for clause in clauses_of(words_of_text(text), LEXICON)]


@pytest.mark.parametrize(
    ("verb", "ing", "past"),
    [
        ("find", "finding", "finded"),
        ("locate", "locating", "located"),
        ("get", "getting", "getted"),
        ("carry", "carrying", "carried"),
        ("reach", "reaching", "reached"),
        ("free", "freeing", "freed"),
        ("weld", "welding", "welded"),
        ("stop", "stopping", "stopped"),
        ("deliver", "delivering", "delivered"),
        ("fix", "fixing", "fixed"),
    ],
)
def test_regular_forms_of_verbs(verb: str, ing: str, past: str) -> None:
    assert (gerund(verb), regular_past(verb)) == (ing, past)


def test_irregular_participles_are_known() -> None:
    found = LEXICON.verb_at(["found"], 0, "past")
    assert found is not None
    assert found.phrase == "find"
    assert LEXICON.verb_at(["finded"], 0, "past") is None


def test_longest_verb_is_taken_and_never_beyond_the_text() -> None:
    longest = LEXICON.verb_at(["keep", "an", "eye", "on", "it"], 0, "base")
    assert longest is not None
    assert (longest.phrase, longest.length) == ("keep an eye on", 4)
    shortest = LEXICON.verb_at(["bring"], 0, "base")
    assert shortest is not None
    assert shortest.length == 1


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("find the dog", [("find the dog", "start", None)]),
        ("find the dog and the cat", [("find the dog and the cat", "start", None)]),
        ("find the dog and go to the lobby", [("find the dog", "start", None), ("go to the lobby", "and", 0)]),
        ("find the dog, then go home", [("find the dog", "start", None), ("go home", "then", 0)]),
        ("find the dog before going home", [("find the dog", "start", None), ("going home", "before", 0)]),
        ("before going home, find the dog", [("going home", "before", 1), ("find the dog", "start", None)]),
        ("find and rescue the dog", [("find", "shares", 1), ("rescue the dog", "start", None)]),
        ("hello. please find the dog!", [("find the dog", "start", None)]),
        ("the dog must be found", [("find the dog", "start", None)]),
        ("the dog is found", [("the dog is found", "start", None)]),
        ("", []),
        (", and then ;", []),
    ],
)
def test_clauses_and_how_they_are_joined(text: str, expected: list[tuple[str, str, int | None]]) -> None:
    assert split(text) == expected


@pytest.mark.parametrize(
    ("text", "name", "lost"),
    [
        ("her lost child", "child", True),
        ("the cat trapped in a building on fire", "cat", True),
        ("room 12", "room 12", False),
        ("Anna's keys", "Anna's keys", False),
        ("the red ball", "red ball", False),
        ("all the patients", "patients", False),
        ("the assembly point", "assembly point", False),
        ("the woman walking with heavy luggage", "woman", False),
        ("the building", "building", False),
        ("the owner of the dog", "owner of the dog", False),
        ("the old man who lives in the tower", "man", False),
    ],
)
def test_noun_phrases(text: str, name: str, lost: bool) -> None:
    phrases = PhraseReader(LEXICON).phrases(words_of_text(text))
    assert phrases is not None
    assert [(phrase.name, phrase.lost) for phrase in phrases] == [(name, lost)]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "the",
        "the dog tomorrow",
        "the dog to the lobby",
        "the dog quickly",
        "the dog in 5 minutes",
        "of",
        "the the dog",
        "dog and",
        "!",
    ],
)
def test_what_is_no_noun_phrase(text: str) -> None:
    assert PhraseReader(LEXICON).phrases(words_of_text(text)) is None


def test_a_name_that_the_scene_knows_may_hold_any_words() -> None:
    reader = PhraseReader(LEXICON, {"hall to be for two": "place"})
    assert reader.phrases(words_of_text("the hall to be for two")) is not None


def test_lexicon_knows_eighty_goals_and_a_dozen_hazards() -> None:
    assert len(LEXICON.phrases_of) >= 80
    assert len(LEXICON.hazards) >= 12
