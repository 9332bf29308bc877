"""The rules by which the tests' endpoint judges a history: it takes a good one, and sees each thing that a strict provider refuses."""

from __future__ import annotations

from collections.abc import Callable
from copy import deepcopy
from typing import Any

import pytest

from tests.llm.endpoint_rules import violations

CALL = {"id": "t0001c001", "type": "function", "function": {"name": "ping", "arguments": '{"word": "one"}'}}
SCHEMA = {
    "type": "object",
    "properties": {"word": {"type": "string"}},
    "required": ["word"],
    "additionalProperties": False,
}
GOOD: dict[str, Any] = {
    "model": "m",
    "messages": [
        {"role": "system", "content": "s"},
        {"role": "user", "content": "u"},
        {"role": "assistant", "content": None, "tool_calls": [CALL, {**CALL, "id": "t0001c002"}]},
        {"role": "tool", "tool_call_id": "t0001c002", "content": "done"},
        {"role": "tool", "tool_call_id": "t0001c001", "content": "done"},
        {"role": "assistant", "content": "words"},
        {"role": "user", "content": "go on"},
    ],
    "tools": [{"type": "function", "function": {"name": "ping", "parameters": SCHEMA, "strict": True}}],
    "tool_choice": {"type": "function", "function": {"name": "ping"}},
}


def test_a_good_request_is_taken() -> None:
    assert violations(GOOD) == []


def _set(*path: str | int, to: Any) -> Callable[[Any], None]:
    def change(body: Any) -> None:
        for key in path[:-1]:
            body = body[key]
        body[path[-1]] = to

    return change


def _without(number: int) -> Callable[[Any], None]:
    def change(body: Any) -> None:
        del body["messages"][number]

    return change


CALLS: tuple[str | int, ...] = ("messages", 2, "tool_calls", 0)
PARAMETERS: tuple[str | int, ...] = ("tools", 0, "function", "parameters")


@pytest.mark.parametrize(
    "change",
    [
        pytest.param(_set("messages", to=[]), id="no messages"),
        pytest.param(_without(0), id="no system"),
        pytest.param(_without(3), id="a call unanswered"),
        pytest.param(_without(5), id="user after tool"),
        pytest.param(_without(6), id="nothing to answer"),
        pytest.param(_set("messages", 5, to={"role": "user", "content": "x"}), id="two of the user"),
        pytest.param(_set("messages", 5, "content", to="  "), id="an assistant of nothing"),
        pytest.param(_set("messages", 5, "tool_calls", to=[]), id="a list of no calls"),
        pytest.param(_set("messages", 6, "content", to=""), id="a user of nothing"),
        pytest.param(_set("messages", 6, "content", to="\ud800"), id="half a character"),
        pytest.param(_set("messages", 4, "tool_call_id", to="t0001c002"), id="answered twice"),
        pytest.param(_set("messages", 4, "tool_call_id", to="t0001c009"), id="answered unasked"),
        pytest.param(_set(*CALLS, "id", to="t0001c002"), id="one id twice"),
        pytest.param(_set(*CALLS, "id", to="call-1"), id="an id of another form"),
        pytest.param(_set(*CALLS, "type", to="custom"), id="a call of another type"),
        pytest.param(_set(*CALLS, "function", "name", to="a b"), id="a name that is none"),
        pytest.param(_set(*CALLS, "function", "arguments", to="{"), id="arguments that are no JSON"),
        pytest.param(_set(*CALLS, "function", "arguments", to="[]"), id="arguments that are no object"),
        pytest.param(_set(*PARAMETERS, "type", to="objekt"), id="a schema that is none"),
        pytest.param(_set(*PARAMETERS, "required", to=[]), id="strict with an optional property"),
        pytest.param(_set(*PARAMETERS, "additionalProperties", to=True), id="strict with any property"),
        pytest.param(
            _set(*PARAMETERS, "properties", "word", to={"type": "array"}), id="strict with a list of anything"
        ),
        pytest.param(_set(*PARAMETERS, "properties", "word", to={"description": "x"}), id="strict with any type"),
        pytest.param(_set("tool_choice", "function", "name", to="pong"), id="a choice that is not offered"),
        pytest.param(_set("tool_choice", to="any"), id="a choice that is none"),
        pytest.param(_set("stream_options", to={"include_usage": True}), id="options of no stream"),
    ],
)
def test_what_a_strict_provider_refuses_is_seen(change: Callable[[Any], None]) -> None:
    body = deepcopy(GOOD)
    assert violations(body) == []
    change(body)
    assert violations(body) != []
