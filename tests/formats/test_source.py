"""Bytes that are not UTF-8 are named for what they are."""

import pytest

from missiontree.errors import InputError
from missiontree.formats.source import clean, decode


@pytest.mark.parametrize(
    ("raw", "line", "words"),
    [
        (b"a: 1\nb: \xff\n", 2, "byte 0xff is not UTF-8"),
        ("a: 1".encode("utf-16"), 1, "UTF-16"),
        ("a: é".encode("latin-1"), 1, "byte 0xe9 is not UTF-8"),
    ],
)
def test_other_encodings_are_named(raw: bytes, line: int, words: str) -> None:
    with pytest.raises(InputError, match=words) as caught:
        decode(raw, "f.yaml")
    assert (caught.value.line, caught.value.accepted) == (line, "UTF-8")


def test_a_byte_order_mark_is_no_fault() -> None:
    assert decode("\ufeffa: é".encode(), "f.yaml") == "a: é"
    assert clean("\ufeffa: é", "f.yaml") == "a: é"


def test_tabs_and_line_ends_are_no_control_characters_and_the_others_are() -> None:
    assert clean("a\tb\r\nc", "f") == "a\tb\r\nc"
    with pytest.raises(InputError, match=r"a character that cannot be shown \(U\+007F\)") as caught:
        clean("a\n\x7f", "f")
    assert caught.value.line == 2
