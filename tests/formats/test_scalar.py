"""Unquoted words: which stay words, and which are values."""

import pytest

from missiontree.formats.reader import parse

WORDS = [
    "no",
    "yes",
    "on",
    "off",
    "y",
    "n",
    "No",
    "12:30",
    "0123",
    "0x1F",
    "0o7",
    "1_000",
    "2026-01-02",
    "1.2.3",
    "nan",
    "inf",
    "+",
    ".",
]


@pytest.mark.parametrize("word", WORDS)
def test_words_stay_words(word: str) -> None:
    assert parse(f"a: {word}").data == {"a": word}
    assert parse(f"{word}: 1").data == {word: 1}


VALUES: list[tuple[str, object]] = [
    ("true", True),
    ("False", False),
    ("null", None),
    ("~", None),
    ("", None),
    ("12", 12),
    ("-3", -3),
    ("+4", 4),
    ("0", 0),
]
VALUES += [
    ("1.5", 1.5),
    (".5", 0.5),
    ("1.", 1.0),
    ("1e3", 1000.0),
    ("-2.5E-1", -0.25),
    ("'12'", "12"),
    ('"true"', "true"),
]


@pytest.mark.parametrize(("text", "value"), VALUES)
def test_values_are_those_of_json(text: str, value: object) -> None:
    data = parse(f"a: {text}").data
    assert data == {"a": value}
    assert type(data["a"]) is type(value)


def test_core_tags_are_accepted() -> None:
    assert parse("a: !!str 12\nb: !!float 2\nc: !!map {}\nd: ! 5").data == {"a": "12", "b": 2, "c": {}, "d": "5"}
