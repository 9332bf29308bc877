"""A strict reader of training data, written from what trainers document, sharing nothing with what writes it."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from functools import lru_cache
from typing import Any

from jsonschema import Draft202012Validator
from openai.types.chat import ChatCompletionFunctionToolParam, ChatCompletionMessageParam
from pydantic import ConfigDict, TypeAdapter

NAME = re.compile(r"[A-Za-z0-9_-]{1,64}")
KEYS = {
    "system": {"role", "content"},
    "user": {"role", "content"},
    "tool": {"role", "content", "tool_call_id"},
    "assistant": {"role", "content", "tool_calls", "weight"},
}
MESSAGES = TypeAdapter(list[ChatCompletionMessageParam])
TOOLS = TypeAdapter(list[ChatCompletionFunctionToolParam], config=ConfigDict(arbitrary_types_allowed=True))


def accept(line: str) -> dict[str, Any]:
    """The example, if a strict trainer takes it; AssertionError if not."""
    assert "\n" not in line
    assert line.isascii()
    example = json.loads(line)
    assert set(example) == {"messages", "tools"}
    _messages(example["messages"], _schemas(json.dumps(example["tools"])))
    MESSAGES.validate_python(example["messages"])
    assert isinstance(example, dict)
    return example


def calls_of(example: dict[str, Any]) -> list[tuple[str, str]]:
    """Names and arguments of all calls, in order."""
    return [
        (call["function"]["name"], call["function"]["arguments"])
        for message in example["messages"]
        for call in message.get("tool_calls", ())
    ]


@lru_cache
def _schemas(tools: str) -> dict[str, Draft202012Validator]:
    """Schemas by function, each looked over; the same list of tools stands in every line."""
    TOOLS.validate_json(tools)
    return dict(_tools(json.loads(tools)))


def _tools(tools: list[dict[str, Any]]) -> Iterator[tuple[str, Draft202012Validator]]:
    names = [tool["function"]["name"] for tool in tools]
    assert tools
    assert len(set(names)) == len(names)
    for tool in tools:
        assert set(tool) == {"type", "function"}
        assert tool["type"] == "function"
        function = tool["function"]
        assert set(function) == {"name", "description", "parameters"}
        assert NAME.fullmatch(function["name"])
        assert function["description"].strip()
        assert function["parameters"]["type"] == "object"
        Draft202012Validator.check_schema(function["parameters"])
        _check_arrays(function["parameters"])
        yield function["name"], Draft202012Validator(function["parameters"])


def _check_arrays(schema: Any) -> None:
    """Endpoints refuse arrays that do not say what is in them."""
    if isinstance(schema, list):
        for entry in schema:
            _check_arrays(entry)
    if isinstance(schema, dict):
        assert schema.get("type") != "array" or "items" in schema
        for entry in schema.values():
            _check_arrays(entry)


def _messages(messages: list[dict[str, Any]], schemas: dict[str, Draft202012Validator]) -> None:
    roles = [message["role"] for message in messages]
    assert roles[:2] == ["system", "user"]
    assert "system" not in roles[1:]
    assert roles[-1] == "assistant", "there is nothing to learn behind the last answer"
    seen: set[str] = set()
    open_calls: list[str] = []
    before = ""
    for message in messages:
        assert set(message) <= KEYS[message["role"]]
        assert {"role", "content"} <= set(message)
        if message["role"] == "tool":
            assert message["tool_call_id"] == open_calls.pop(0), "calls are answered in order, each once"
        else:
            assert not open_calls, "every call is answered before anything else is said"
            assert message["role"] != before, "speakers take turns"
        if message["role"] == "assistant":
            open_calls = _said(message, schemas, seen)
        else:
            assert isinstance(message["content"], str)
            assert message["content"].strip()
        before = "" if message["role"] == "tool" else message["role"]


def _said(message: dict[str, Any], schemas: dict[str, Draft202012Validator], seen: set[str]) -> list[str]:
    calls = message.get("tool_calls")
    assert calls is None or calls
    assert message.get("weight", 1) in {0, 1}
    assert isinstance(message["content"], str) or (calls and message["content"] is None)
    assert message["content"] is None or message["content"].strip()
    ids = []
    for call in calls or ():
        assert set(call) == {"id", "type", "function"}
        assert call["type"] == "function"
        assert set(call["function"]) == {"name", "arguments"}
        arguments = json.loads(call["function"]["arguments"])
        assert isinstance(arguments, dict)
        schemas[call["function"]["name"]].validate(arguments)
        assert re.fullmatch(r"[a-zA-Z0-9]{9}", call["id"]), "the strictest endpoints take nine letters and digits"
        assert call["id"] not in seen
        seen.add(call["id"])
        ids.append(call["id"])
    return ids
