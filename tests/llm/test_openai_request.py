"""What is sent: the dialogue in the endpoint's form, and only what it may be asked for."""

from __future__ import annotations

from typing import Any

import pytest

from missiontree.llm.chat import Message, Tool, ToolCall
from missiontree.llm.features import FEATURES, Features
from missiontree.llm.openai_native import native_of
from missiontree.llm.openai_request import Request, Wish, request_of

SCHEMA = {
    "type": "object",
    "properties": {"word": {"type": "string"}, "times": {"type": "integer"}},
    "required": ["word"],
    "additionalProperties": False,
}
PING, PONG = Tool("ping", "Pings.", SCHEMA), Tool("pong", "Pongs.", {"type": "object"})
ALL = Features()
TALK = [Message("system", "s"), Message("user", "u", must_call=True)]
ALL_USED = frozenset(FEATURES) - {"thoughts", "required", "choice"}


def request(tools: list[Tool], features: Features = ALL, talk: list[Message] = TALK, **wish: Any) -> Request:
    return request_of(talk, tools, Wish("m", **wish), features)


def test_a_dialogue_is_sent_in_turns() -> None:
    talk = [
        Message("system", "s"),
        Message("user", "u"),
        Message("assistant", "", (ToolCall("1", "ping", '{"word": "a"}'), ToolCall("2", "p ng", "{"))),
        Message("tool", "done", call_id="1"),
        Message("tool", "no", call_id="2"),
    ]
    assert request([], talk=talk).body["messages"] == [
        {"role": "system", "content": "s"},
        {"role": "user", "content": "u"},
        {
            "role": "assistant",
            "content": None,
            "tool_calls": [
                {"id": "1", "type": "function", "function": {"name": "ping", "arguments": '{"word": "a"}'}},
                {"id": "2", "type": "function", "function": {"name": "not_a_function", "arguments": "{}"}},
            ],
        },
        {"role": "tool", "tool_call_id": "1", "content": "done"},
        {"role": "tool", "tool_call_id": "2", "content": "no"},
    ]


def test_tools_are_strict_where_their_schema_can_be() -> None:
    sent = request([PING, PONG])
    assert [tool["function"].get("strict") for tool in sent.body["tools"]] == [True, None]
    assert sent.body["tools"][0]["function"]["parameters"]["required"] == ["word", "times"]
    assert sent.body["tools"][1]["function"]["parameters"] == {"type": "object"}
    assert set(sent.strict) == {"ping"}


def test_calls_of_strict_tools_come_back_without_the_nulls_and_others_as_they_are() -> None:
    sent, given = request([PING, PONG]), '{"word": "a", "times": null}'
    assert sent.restored(ToolCall("1", "ping", given)).arguments == '{"word": "a"}'
    assert sent.restored(ToolCall("1", "pong", given)).arguments == given


def test_without_strict_the_schema_stands_as_it_is_and_then_in_its_simplest_form() -> None:
    features = Features(strict=False)
    assert request([PING], features).body["tools"][0]["function"]["parameters"] == SCHEMA
    simple = request([PING], features.without(["rich_schema"])).body["tools"][0]["function"]["parameters"]
    assert simple == {key: value for key, value in SCHEMA.items() if key != "additionalProperties"}


def test_everything_is_asked_for_at_first() -> None:
    sent = request([PING], max_output_tokens=9, temperature=0.0)
    assert {key: value for key, value in sent.body.items() if key not in {"messages", "tools"}} == {
        "model": "m",
        "tool_choice": {"type": "function", "function": {"name": "ping"}},
        "parallel_tool_calls": True,
        "max_completion_tokens": 9,
        "temperature": 0.0,
        "stream": True,
        "stream_options": {"include_usage": True},
    }
    assert sent.used == ALL_USED


def test_without_any_feature_there_is_the_bare_request() -> None:
    sent = request([PING], Features().without(FEATURES), max_output_tokens=9, temperature=0.0)
    assert {key for key in sent.body if key not in {"messages", "tools"}} == {"model", "max_tokens"}
    assert sent.used == frozenset()


def test_nothing_is_said_of_limits_or_calls_if_there_are_none() -> None:
    assert set(request([], stream=False).body) == {"model", "messages"}


@pytest.mark.parametrize(
    ("tools", "must", "missing", "choice", "demanded"),
    [
        ([PING], True, [], {"type": "function", "function": {"name": "ping"}}, "ping"),
        ([PING], True, ["named"], "required", ""),
        ([PING, PONG], True, [], "required", ""),
        ([PING, PONG], True, ["required"], "auto", None),
        ([PING, PONG], True, ["required", "choice"], None, None),
        ([PING], False, [], "auto", None),
        ([PING], False, ["choice"], None, None),
    ],
)
def test_a_call_is_demanded_as_far_as_it_can_be(
    tools: list[Tool], must: bool, missing: list[str], choice: Any, demanded: str | None
) -> None:
    talk = [Message("user", "u", must_call=must)]
    sent = request(tools, Features().without(missing), talk)
    assert (sent.body.get("tool_choice"), sent.demanded) == (choice, demanded)


def test_a_demand_is_met_once_there_was_a_call() -> None:
    talk = [*TALK, Message("assistant", calls=(ToolCall("1", "ping", "{}"),)), Message("tool", "done", call_id="1")]
    assert request([PING], talk=talk).body["tool_choice"] == "auto"


def test_thoughts_are_handed_back_with_the_message_they_led_to() -> None:
    signature = {"extra_content": {"google": {"thought_signature": "xyz"}}}
    said = Message("assistant", calls=(ToolCall("1", "ping", "{}"),), native=native_of("hm", [signature]))
    talk = [*TALK, said, Message("tool", "done", call_id="1")]
    sent = request([PING], talk=talk)
    assert sent.body["messages"][2]["reasoning_content"] == "hm"
    assert sent.body["messages"][2]["tool_calls"][0]["extra_content"] == signature["extra_content"]
    assert "thoughts" in sent.used
    bare = request([PING], Features(thoughts=False), talk)
    assert set(bare.body["messages"][2]) == {"role", "content", "tool_calls"}
    assert set(bare.body["messages"][2]["tool_calls"][0]) == {"id", "type", "function"}
