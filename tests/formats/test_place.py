"""Places are written as people write them, and what stands there is shown short and harmless."""

import pytest

from missiontree.formats.place import NOWHERE, child, found, quoted, where


def test_paths_read_like_paths() -> None:
    assert where(("types", 0, "limits", "max_speed_mps")) == "types[0].limits.max_speed_mps"
    assert where((0, "a")) == "[0].a"
    assert where(()) == ""


def test_strange_keys_are_quoted_and_cannot_reach_the_terminal() -> None:
    assert where(("limits", "a b", "\x1b[31m")) == r"limits['a b']['\x1b[31m']"
    assert quoted("x" * 100) == "'" + "x" * 60 + "...'"


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (None, "nothing (null)"),
        (True, "true (a truth value)"),
        (1.5, "1.5"),
        (float("inf"), "inf (too large to hold)"),
        (10**50, "a number of more than 40 digits"),
        ("it's", '"it\'s" (text)'),
        ([1, 2], "a list of 2"),
        ({}, "an empty mapping"),
        ({"a": 1, "b": 2}, "a mapping with the keys 'a', 'b'"),
    ],
)
def test_what_was_found_is_said_in_words(data: object, words: str) -> None:
    assert found(data) == words


def test_a_step_to_nowhere_is_not_a_step_to_null() -> None:
    assert child({"a": None}, "a") is None
    assert child({"a": None}, "b") is NOWHERE
    assert child([1], 3) is NOWHERE
    assert child(5, "a") is NOWHERE
