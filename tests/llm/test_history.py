"""Whatever a model said, what goes back is what every endpoint takes: JSON objects, names that are names, UTF-8, turns."""

from __future__ import annotations

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.llm.chat import Message, ToolCall
from missiontree.llm.history import NAME, arguments_of, sendable


@pytest.mark.parametrize(
    "arguments",
    [
        "",
        "{",
        '{"a": NaN}',
        '{"a": Infinity}',
        "[1]",
        "null",
        '"text"',
        "{'a': 1}",
        '{"a": 1} {"b": 2}',
        "[" * 100_000,
        '{"a":' * 100_000,
        '{"a":' + "[" * 900 + "]" * 900 + "}",
        '{"a": ' + "9" * 5000 + "}",
    ],
)
def test_arguments_that_are_no_object_are_sent_as_none(arguments: str) -> None:
    call = sendable([Message("assistant", calls=(ToolCall("1", "a", arguments),))])[0].calls[0]
    assert isinstance(json.loads(call.arguments), dict)


def test_sound_arguments_stay() -> None:
    assert arguments_of(ToolCall("1", "a", '{"a": ["ü", 1]}')) == {"a": ["ü", 1]}


@pytest.mark.parametrize("name", ["", "functions.addMultiSubtasks", "a b", "x" * 65, "adä", "a\n"])
def test_names_that_are_none_are_replaced(name: str) -> None:
    call = sendable([Message("assistant", calls=(ToolCall("1", name, "{}"),))])[0].calls[0]
    assert call.name == "not_a_function"


def test_messages_of_one_speaker_become_one_and_empty_ones_are_left_out() -> None:
    said = [
        Message("system", "s"),
        Message("user", "one"),
        Message("assistant", "  "),
        Message("user", "two", must_call=True),
        Message("assistant", "thought"),
        Message("assistant", calls=(ToolCall("1", "a", "{}"),)),
        Message("tool", "answer", call_id="1"),
        Message("user", "three"),
    ]
    sent = sendable(said)
    assert [(message.speaker, message.text) for message in sent] == [
        ("system", "s"),
        ("user", "one\n\ntwo"),
        ("assistant", "thought"),
        ("tool", "answer"),
        ("user", "three"),
    ]
    assert sent[1].must_call
    assert len(sent[2].calls) == 1


def test_an_answer_without_words_stands_between_a_tool_and_the_user() -> None:
    """Endpoints of one family take no message of the user directly after a tool's."""
    said = [
        Message("assistant", calls=(ToolCall("1", "a", "{}"),)),
        Message("tool", "x", call_id="1"),
        Message("assistant", ""),
        Message("user", "Review it."),
    ]
    sent = sendable(said)
    assert [message.speaker for message in sent] == ["assistant", "tool", "assistant", "user"]
    assert sent[2].text == "(no words)"


def test_answers_to_calls_are_never_merged() -> None:
    calls = (ToolCall("1", "a", "{}"), ToolCall("2", "a", "{}"))
    said = [Message("assistant", calls=calls), Message("tool", "x", call_id="1"), Message("tool", "y", call_id="2")]
    assert len(sendable(said)) == 3


@given(st.lists(st.tuples(st.text(), st.text(), st.text(alphabet=st.characters())), max_size=4))
def test_any_history_can_be_written_as_utf_8(texts: list[tuple[str, str, str]]) -> None:
    said = [Message("assistant", text, (ToolCall("1", name, arguments),)) for text, name, arguments in texts]
    for message in sendable(said):
        message.text.encode()
        for call in message.calls:
            assert NAME.fullmatch(call.name)
            assert isinstance(json.loads(call.arguments.encode()), dict)


def test_lone_surrogates_are_replaced() -> None:
    sent = sendable([Message("assistant", "\ud800", (ToolCall("1", "a", '{"a": "\\ud800"}'),))])[0]
    assert sent.text == "?"
    sent.calls[0].arguments.encode()
