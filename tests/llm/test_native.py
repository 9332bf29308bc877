"""What a provider wants back, laid beside a message that may have changed."""

from __future__ import annotations

import pytest

from missiontree.llm.chat import Message, ToolCall
from missiontree.llm.native import Piece, native_of, pieces_of

KEPT = (
    Piece("thought", own="t1"),
    Piece("text", "One."),
    Piece("call", "own-1", "s1"),
    Piece("thought", own="t2"),
    Piece("text", "Two."),
    Piece("call", "own-2"),
)
CALLS = (ToolCall("a", "f", "{}"), ToolCall("b", "g", "{}"))


def message(text: str = "One. Two.", calls: tuple[ToolCall, ...] = CALLS, native: str | None = None) -> Message:
    return Message("assistant", text, calls, native=native_of("me", KEPT) if native is None else native)


def shape(said: Message) -> list[str]:
    """The pieces in short: kind, text, own, and the call's name."""
    pieces = pieces_of("me", said, " ")
    return [" ".join(filter(None, (p.kind, p.text, p.own, p.call.name if p.call else ""))) for p in pieces]


def test_an_unchanged_message_has_its_pieces_in_their_order() -> None:
    assert shape(message()) == ["thought t1", "text One.", "call own-1 s1 f", "thought t2", "text Two.", "call own-2 g"]


def test_another_text_stands_before_the_first_call() -> None:
    assert shape(message("Three.")) == ["thought t1", "text Three.", "call own-1 s1 f", "thought t2", "call own-2 g"]


def test_a_text_that_is_gone_leaves_nothing() -> None:
    assert shape(message(" ")) == ["thought t1", "call own-1 s1 f", "thought t2", "call own-2 g"]


def test_other_calls_have_nothing_of_the_providers() -> None:
    assert shape(message(calls=CALLS[:1])) == ["thought t1", "text One.", "thought t2", "text Two.", "call f"]


@pytest.mark.parametrize(
    "native",
    [
        "",
        "{",
        "7",
        "null",
        "[]",
        '{"of": "me"}',
        '{"of": "me", "pieces": 3}',
        '{"of": "me", "pieces": [["text", "One. Two."]]}',
        '{"of": "me", "pieces": [["joke", "", ""]]}',
        '{"of": "me", "pieces": [["call", 7, ""]]}',
        native_of("you", KEPT),
        "[" * 100_000,
    ],
)
def test_what_cannot_be_read_or_is_anothers_is_left_out(native: str) -> None:
    assert shape(message(native=native)) == ["text One. Two.", "call f", "call g"]


def test_it_is_text_that_any_file_can_hold() -> None:
    assert native_of("me", [Piece("text", "Zürich \u2028")]).isascii()
