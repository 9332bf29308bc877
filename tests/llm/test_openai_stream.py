"""The same objects come out however the bytes are cut and whatever the endpoint calls them."""

from __future__ import annotations

import json
from contextlib import suppress
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.llm.chat import ProviderError
from missiontree.llm.openai_stream import DONE, objects_of

EVENTS = "text/event-stream; charset=utf-8"
BODY = ': hello\r\n\r\ndata: {"a": "ü€"}\r\n\r\nevent: x\ndata:{"b": 2}\n\ndata: {"c":\rdata: 3}\r\rdata: [DONE]\n\ndata: {"d": 4}\n\n'
OBJECTS = [{"a": "ü€"}, {"b": 2}, {"c": 3}, {DONE: True}]


def read(content_type: str, *pieces: bytes) -> list[object]:
    return list(objects_of(content_type, pieces))


def test_events_are_read_and_what_follows_the_end_is_not() -> None:
    assert read(EVENTS, BODY.encode()) == OBJECTS


@given(st.sets(st.integers(0, len(BODY.encode()))))
def test_it_does_not_matter_where_the_bytes_are_cut(cuts: set[int]) -> None:
    """In the middle of a letter, between CR and LF, inside a name."""
    data = BODY.encode()
    edges = [0, *sorted(cuts), len(data)]
    assert read(EVENTS, *(data[a:b] for a, b in pairwise(edges))) == OBJECTS


def test_a_line_of_data_that_is_whole_needs_no_blank_line_after_it() -> None:
    assert read(EVENTS, b'data: {"a": 1}\ndata: {"b": 2}\n') == [{"a": 1}, {"b": 2}]


def test_what_is_not_whole_when_the_stream_ends_is_nothing() -> None:
    assert read(EVENTS, b'data: {"a": 1}\n\ndata: {"b": ') == [{"a": 1}]


def test_the_last_line_may_lack_its_end() -> None:
    assert read(EVENTS, b'data: {"a": 1}') == [{"a": 1}]


def test_an_event_called_error_is_one() -> None:
    assert read(EVENTS, b'event: error\ndata: {"message": "no"}\n\n') == [{"error": {"message": "no"}}]


def test_a_byte_order_mark_and_blank_data_are_passed_over() -> None:
    assert read(EVENTS, b'\xef\xbb\xbfdata: {"a": 1}\n\ndata:\n\nretry: 5\n\n') == [{"a": 1}]


@pytest.mark.parametrize(
    "kind", ["application/json", "application/problem+json", "", "text/plain", "application/octet-stream"]
)
def test_one_object_is_one_object(kind: str) -> None:
    assert read(kind, b'{"a"', b": 1}") == [{"a": 1}]


@pytest.mark.parametrize("kind", ["", "text/plain; charset=utf-8"])
def test_events_that_are_not_called_so_are_known_by_their_first_letters(kind: str) -> None:
    assert read(kind, b"da", BODY.encode()[len(": hello\r\n\r\nda") :]) == OBJECTS


@pytest.mark.parametrize(
    ("kind", "body"),
    [
        ("text/html", b"<html>"),
        ("image/png", b"\x89PNG"),
        ("application/json", b"<html>"),
        ("application/json", b"[1]"),
        ("application/json", b"[" * 100_000),
        ("text/plain", b"welcome to nginx"),
        (EVENTS, b'data: {"a" 7}\n\n'),
        (EVENTS, b"data: 7\n\n"),
        (EVENTS, b"data: [\n" * 2000),
    ],
)
def test_anything_else_is_no_answer(kind: str, body: bytes) -> None:
    with pytest.raises(ProviderError) as raised:
        read(kind, body)
    assert raised.value.kind == "failed"
    assert "/v1" in raised.value.hint


@pytest.mark.parametrize("kind", ["application/json", ""])
def test_a_body_of_nothing_is_an_empty_answer(kind: str) -> None:
    with pytest.raises(ProviderError) as raised:
        read(kind, b" \n")
    assert raised.value.kind == "empty"


@given(st.binary(max_size=60), st.sampled_from([EVENTS, "application/json", "", "text/html"]))
def test_no_bytes_do_more_than_fail(body: bytes, kind: str) -> None:
    """Every object can be written again; whatever is none is a fault of ours and no other."""
    with suppress(ProviderError):
        json.dumps(read(kind, body))
