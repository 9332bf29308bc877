"""A text to its words and signs."""

from __future__ import annotations

import pytest

from missiontree.authoring.reading.words import MARK, is_mark, words_of_text


def lows(text: str) -> list[str]:
    return [word.low for word in words_of_text(text)]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", []),
        ("  \n\t ", []),
        ("Find the cat!", ["find", "the", "cat", "!"]),
        ("Anna's keys", ["anna's", "keys"]),
        ("Anna’s keys", ["anna's", "keys"]),  # the typographer's apostrophe
        ('„find“ «the» "cat"', ["find", "the", "cat"]),
        ("tele-robot", ["tele-robot"]),
        ("tele‑robot", ["tele-robot"]),  # a hyphen that does not break
        ("2.5 m at 14:30", ["2.5", "m", "at", "14:30"]),
        ("find it - then go", ["find", "it", ",", "then", "go"]),
        ("find it — then go", ["find", "it", ",", "then", "go"]),
        ("find it—then go", ["find", "it", ",", "then", "go"]),
        ("Mr. Brown and Dr. Ng.", ["mr", "brown", "and", "dr", "ng", "."]),
        ("@drone", ["@", "drone"]),
    ],
)
def test_signs_stand_apart_and_those_that_look_alike_are_alike(text: str, expected: list[str]) -> None:
    assert lows(text) == expected


def test_words_keep_how_they_are_written() -> None:
    assert [word.text for word in words_of_text("Find ANNA")] == ["Find", "ANNA"]


def test_letters_that_are_composed_differently_are_alike() -> None:
    assert words_of_text("Jo\u0308rg") == words_of_text("J\u00f6rg")


@pytest.mark.parametrize("and_", ["as well as", "along with", "together with"])
def test_what_means_and_is_read_as_and(and_: str) -> None:
    assert lows(f"find the cat {and_} the dog") == ["find", "the", "cat", "and", "the", "dog"]
    assert lows(f"{and_} the dog")[0] != "and"  # it joins nothing there
    assert lows(f"find the cat {and_}")[-1] != "and"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("go home", "go to home"),
        ("return there", "return to there"),
        ("go to home", "go to home"),
        ("go Home", "go home"),  # a name
        ("take it home", "take it home"),  # put right where the clause is known
    ],
)
def test_home_and_there_are_where_somebody_goes(text: str, expected: str) -> None:
    assert " ".join(lows(text)) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("find Anna, who is lost", "find anna who is lost"),
        ("bring the safe, which is heavy, to the hall", "bring the safe which is heavy to the hall"),
        ("Anna, who is lost, must be found", "anna who is lost must be found"),
        ("bring the safe, to the hall", "bring the safe , to the hall"),
        ("find Anna, Bob", "find anna , bob"),
    ],
)
def test_comma_that_only_sets_off_what_describes_falls_away(text: str, expected: str) -> None:
    assert " ".join(lows(text)) == expected


def test_nobody_can_write_a_mark() -> None:
    assert not any(is_mark(lows("@drone @@drone a@b"), place) for place in range(9))
    assert is_mark([f"{MARK}drone"], 0)
    assert not is_mark([MARK], 0)
    assert not is_mark([], 0)
