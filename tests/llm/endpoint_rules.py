"""What the strictest of providers demand of a request, together: a history that passes here is refused by none of them."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import Any

import jsonschema

NAME = re.compile(r"[a-zA-Z0-9_-]{1,64}")
CALL_ID = re.compile(r"[a-zA-Z0-9]{9}")  # Mistral's form, the narrowest


def violations(body: Any) -> list[str]:
    """What is wrong with the body of a request; empty if nothing is."""
    try:
        json.dumps(body, ensure_ascii=False).encode("utf-8")
    except UnicodeEncodeError:
        return ["half a character: the request cannot be written as UTF-8"]
    if not isinstance(body, dict) or not isinstance(body.get("messages"), list) or not body["messages"]:
        return ["no messages"]
    return [*_of_messages(body["messages"]), *_of_tools(body.get("tools", [])), *_of_choice(body)]


def _of_messages(messages: list[Any]) -> Iterator[str]:
    roles = [message.get("role") for message in messages]
    if roles[0] != "system" or "system" in roles[1:]:
        yield "the system's message is not the first and only one"
    if roles[-1] not in {"user", "tool"}:
        yield f"the last message is of {roles[-1]!r}: there is nothing to answer"
    for first, second in pairwise(roles):
        if (first == second != "tool") or (first, second) in {("tool", "user"), ("system", "assistant")}:
            yield f"a message of {second!r} after one of {first!r}"
    for number, message in enumerate(messages):
        yield from (f"messages[{number}] {wrong}" for wrong in _of_message(message))
    yield from _of_answers(messages)


def _of_message(message: Mapping[str, Any]) -> Iterator[str]:
    content, calls = message.get("content"), message.get("tool_calls")
    if message.get("role") == "assistant":
        if calls == [] or not isinstance(content, str | None):
            yield "has an empty list of calls, or content of another kind"
        if not calls and not (content or "").strip():
            yield "of the assistant says nothing"
        for call in calls or ():
            yield from _of_call(call)
    elif not isinstance(content, str) or not content.strip():
        yield f"of {message.get('role')!r} says nothing"


def _of_answers(messages: list[Any]) -> Iterator[str]:
    """Each call is answered once, directly after it was asked for, and no two have the same id."""
    seen: set[str] = set()
    waiting: list[str] = []
    for message in [*messages, {"role": "end"}]:
        if message.get("role") == "tool":
            if message.get("tool_call_id") not in waiting:
                yield f"{message.get('tool_call_id')!r} is answered and was not asked for just before"
            else:
                waiting.remove(message["tool_call_id"])
            continue
        if waiting:
            yield f"nobody answers {waiting}"
        waiting = [call["id"] for call in message.get("tool_calls", ())]
        if len({*waiting}) < len(waiting) or seen & {*waiting}:
            yield f"an id was used before: {waiting}"
        seen |= {*waiting}


def _of_call(call: Mapping[str, Any]) -> Iterator[str]:
    if not CALL_ID.fullmatch(call.get("id", "")):
        yield f"has the id {call.get('id')!r}, which is none"
    function = call.get("function", {})
    if call.get("type") != "function" or not NAME.fullmatch(function.get("name", "")):
        yield f"calls {function.get('name')!r}, which is no name of a function"
    try:
        if not isinstance(json.loads(function["arguments"]), dict):
            yield "has arguments that are no object"
    except (ValueError, KeyError, TypeError):
        yield "has arguments that are not JSON"


def _of_tools(tools: list[Any]) -> Iterator[str]:
    names = [tool["function"]["name"] for tool in tools]
    if len(set(names)) < len(names):
        yield "a tool is offered twice"
    for tool in tools:
        function = tool["function"]
        if tool.get("type") != "function" or not NAME.fullmatch(function["name"]):
            yield f"tool {function['name']!r} is none"
        try:
            jsonschema.Draft202012Validator.check_schema(function["parameters"])
        except jsonschema.SchemaError as error:
            yield f"tool {function['name']!r}: {error.message}"
        if function["parameters"].get("type") != "object":
            yield f"tool {function['name']!r} takes no object"
        if function.get("strict"):
            yield from _of_strict(function["parameters"], function["name"])


def _of_strict(schema: Any, where: str) -> Iterator[str]:
    """The rules of strict schemas: every property required, no others, lists with a type of entry."""
    if schema.get("type") == "object":
        if schema.get("additionalProperties") is not False:
            yield f"strict {where}: additionalProperties is not false"
        if sorted(schema.get("required", [])) != sorted(schema.get("properties", {})):
            yield f"strict {where}: not every property is required"
    if schema.get("type") == "array" and "items" not in schema:
        yield f"strict {where}: a list of anything"
    if not {"type", "anyOf"} & set(schema):
        yield f"strict {where}: a value of any type"
    for below in (*schema.get("properties", {}).values(), *schema.get("anyOf", ())):
        yield from _of_strict(below, where)
    if "items" in schema:
        yield from _of_strict(schema["items"], where)


def _of_choice(body: Mapping[str, Any]) -> Iterator[str]:
    choice = body.get("tool_choice", "auto")
    if "tool_choice" in body and not body.get("tools"):
        yield "tool_choice without tools"
    if isinstance(choice, Mapping):
        choice = choice["function"]["name"]
        if choice not in [tool["function"]["name"] for tool in body["tools"]]:
            yield f"tool_choice names {choice!r}, which is not offered"
    elif choice not in {"auto", "required", "none"}:
        yield f"tool_choice is {choice!r}"
    if "stream_options" in body and not body.get("stream"):
        yield "stream_options without a stream"
