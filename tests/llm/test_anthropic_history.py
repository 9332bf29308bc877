"""Whatever was said, Anthropic's API takes the history; and what it wants back verbatim comes back verbatim."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given

from missiontree.llm.chat import Message, Tool, ToolCall
from missiontree.llm.native import Piece, native_of
from tests.llm.anthropic_endpoint import Answered, Said, answering, text, thinking, use
from tests.llm.histories import DIALOGUES, MISSION, SYSTEM, answered, called, dialogues

TOOL = Tool("a", "Does it.", {"type": "object", "properties": {}})


def sent(*dialogue: Message) -> list[dict[str, Any]]:
    """The messages as they went over the wire, and were not rejected."""
    with answering(Said([text("ok")])) as asked:
        assert asked.model(dialogue, [TOOL]).text == "ok"
    messages: list[dict[str, Any]] = asked.bodies[0]["messages"]
    return messages


@pytest.fixture(scope="module")
def patient() -> Iterator[Answered]:
    """An endpoint that answers as often as it is asked."""
    with answering(*[Said([text("ok")])] * 1000) as asked:
        yield asked


@pytest.mark.parametrize("name", DIALOGUES)
def test_no_history_is_rejected(name: str, patient: Answered) -> None:
    assert patient.model(DIALOGUES[name], [TOOL]).text == "ok"


@given(dialogue=dialogues("anthropic"))
def test_no_history_at_all_is_rejected(dialogue: list[Message], patient: Answered) -> None:
    assert patient.model(dialogue, [TOOL]).text == "ok"


def test_a_dialogue_from_elsewhere_is_sent_as_turns() -> None:
    first = called(("1", "a", '{"x": null}'), ("2", "b", "{broken"), text="Look.")
    messages = sent(SYSTEM, MISSION, first, answered("2", "no"), answered("1", "yes"), Message("user", "And?"))
    assert messages == [
        {"role": "user", "content": [text("Build.")]},
        {"role": "assistant", "content": [text("Look."), use("a", {"x": None}, "1"), use("b", {}, "2")]},
        {
            "role": "user",
            "content": [
                {"type": "tool_result", "tool_use_id": "1", "content": "yes"},
                {"type": "tool_result", "tool_use_id": "2", "content": "no"},
                text("And?"),
            ],
        },
    ]


def test_what_the_user_says_in_a_row_is_one_turn() -> None:
    messages = sent(MISSION, Message("user", "And quickly."))
    assert messages == [{"role": "user", "content": [text("Build.\n\nAnd quickly.")]}]


def test_a_call_that_was_not_made_is_answered_so() -> None:
    messages = sent(MISSION, called(("1", "a", "{}")))
    assert "not made" in messages[-1]["content"][0]["content"]


THOUGHTS = [
    thinking("First.", "sig/1+="),
    text("So:"),
    use("a", {"x": 1}, "toolu_1"),
    {"type": "redacted_thinking", "data": "b3BhcXVl"},
    text("and:"),
    use("b", {}, "toolu_2"),
]


@pytest.mark.parametrize("stream", [True, False], ids=["stream", "whole"])
def test_thoughts_go_back_as_they_came(stream: bool) -> None:
    """Verbatim and in their places; even the ids are Anthropic's own again, though the dialogue has others."""
    with answering(Said(THOUGHTS), Said([text("ok")]), stream=stream) as asked:
        said = asked.model([MISSION], [TOOL])
        assert [call.id for call in said.calls] == ["toolu_1", "toolu_2"]
        said = replace(said, calls=tuple(replace(call, id=f"t{call.id[-1]}") for call in said.calls))
        asked.model([MISSION, said, answered("t1", "x"), answered("t2", "y")], [TOOL])
    assistant, results = asked.bodies[1]["messages"][1:]
    assert assistant["content"] == THOUGHTS
    assert [(block["tool_use_id"], block["content"]) for block in results["content"]] == [
        ("toolu_1", "x"),
        ("toolu_2", "y"),
    ]


def test_thoughts_go_before_a_text_that_has_changed() -> None:
    """Two messages of the assistant in a row are sent as one, so the texts that were kept are no longer its text."""
    with answering(Said([thinking("Hm.", "s"), text("Later."), use("a", {}, "toolu_1")]), Said([text("ok")])) as asked:
        said = asked.model([MISSION], [TOOL])
        asked.model([MISSION, Message("assistant", "Before."), said, answered("toolu_1")], [TOOL])
    content = asked.bodies[1]["messages"][1]["content"]
    assert content == [thinking("Hm.", "s"), text("Before.\n\nLater."), use("a", {}, "toolu_1")]


def test_thoughts_stay_when_calls_were_dropped() -> None:
    with answering(Said([thinking("Hm.", "s"), text("Now."), use("a", {}, "toolu_1")]), Said([text("ok")])) as asked:
        said = replace(asked.model([MISSION], [TOOL]), calls=())
        asked.model([MISSION, said, Message("user", "Go on.")], [TOOL])
    assert asked.bodies[1]["messages"][1]["content"] == [thinking("Hm.", "s"), text("Now.")]


def test_an_answer_without_thoughts_keeps_nothing() -> None:
    with answering(Said([text("So."), use("a", {}, "toolu_1")])) as asked:
        assert asked.model([MISSION], [TOOL]).native == ""


@pytest.mark.parametrize("kept", ["{", "7", "[]", '{"type": "image"}', "{}"])
def test_a_thought_that_is_none_is_left_out(kept: str) -> None:
    native = native_of("anthropic", [Piece("thought", own=kept), Piece("call", "toolu_1")])
    messages = sent(MISSION, called(("1", "a", "{}"), native=native), answered("1"))
    assert messages[1]["content"] == [use("a", {}, "toolu_1")]


def test_what_another_provider_kept_is_left_out() -> None:
    native = '{"of": "gemini", "pieces": [["thought", "Hm.", "c2ln"], ["call", "abc", "c2ln"]]}'
    messages = sent(MISSION, called(("1", "a", "{}"), native=native), answered("1"))
    assert messages[1]["content"] == [use("a", {}, "1")]


def test_an_id_that_the_dialogue_has_already_is_not_given_again() -> None:
    with answering(Said([use("a", {}, "toolu_1"), use("a", {}, "toolu_2")])) as asked:
        earlier = [MISSION, called(("toolu_1", "a", "{}")), answered("toolu_1")]
        ids = [call.id for call in asked.model(earlier, [TOOL]).calls]
    assert ids[1] == "toolu_2"
    assert len({"toolu_1", *ids}) == 3


def test_arguments_that_no_one_can_read_are_sent_as_none() -> None:
    damaged = Message("assistant", calls=(ToolCall("1", "a", '{"x": '),))
    assert sent(MISSION, damaged, answered("1"))[1]["content"] == [use("a", {}, "1")]
