"""A dialogue as the body of a Chat Completions request, and which features of the endpoint that body makes use of."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from missiontree.llm.chat import Message, Tool, ToolCall
from missiontree.llm.features import Features
from missiontree.llm.history import sendable
from missiontree.llm.openai_native import thoughts_of
from missiontree.llm.openai_strict import restored, simple_form, strict_form


@dataclass(frozen=True, slots=True)
class Wish:
    """
    What is asked for beside an answer.

    Parameters
    ----------
    model
        Name of the model.
    stream
        Whether the answer is to come piece by piece.
    max_output_tokens
        Most tokens an answer may have; None leaves it to the endpoint.
    temperature
        None leaves it to the endpoint.
    """

    model: str
    stream: bool = True
    max_output_tokens: int | None = None
    temperature: float | None = None


@dataclass(frozen=True, slots=True)
class Request:
    """
    A request, ready to be sent.

    Parameters
    ----------
    body
        The JSON object.
    used
        Features that it makes use of.
    strict
        Schemas, before they were made strict, of the tools that were sent in strict form.
    """

    body: dict[str, Any]
    used: frozenset[str]
    strict: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)

    def restored(self, call: ToolCall) -> ToolCall:
        """The call as it would have been made without the strict form."""
        schema = self.strict.get(call.name)
        return call if schema is None else replace(call, arguments=restored(call.arguments, schema))

    @property
    def demanded(self) -> str | None:
        """Name of the tool that must be called; empty if any will do, None if none must."""
        choice = self.body.get("tool_choice")
        if isinstance(choice, Mapping):
            return str(choice["function"]["name"])
        return "" if choice == "required" else None


def request_of(messages: Sequence[Message], tools: Sequence[Tool], wish: Wish, features: Features) -> Request:
    """
    The request for the next message of a dialogue.

    Parameters
    ----------
    messages, tools
        See :class:`ChatModel`.
    wish
        What is asked for beside.
    features
        What may be made use of.
    """
    sent = sendable(messages)
    used: set[str] = set()
    body: dict[str, Any] = {"model": wish.model, "messages": _messages(sent, features, used)}
    strict: dict[str, Mapping[str, Any]] = {}
    if tools:
        body["tools"] = _tools(tools, features, used, strict)
        body |= _choice(sent, tools, features, used)
        if features.parallel_calls:
            body["parallel_tool_calls"] = True
            used.add("parallel_calls")
    body |= _limits(wish, features, used)
    if wish.stream and features.stream:
        body["stream"] = True
        used.add("stream")
        if features.usage_in_stream:
            body["stream_options"] = {"include_usage": True}
            used.add("usage_in_stream")
    return Request(body, frozenset(used), strict)


def _messages(sent: Iterable[Message], features: Features, used: set[str]) -> list[dict[str, Any]]:
    made: list[dict[str, Any]] = []
    for message in sent:
        if message.speaker == "tool":
            made.append({"role": "tool", "tool_call_id": message.call_id, "content": message.text})
        elif message.speaker == "assistant":
            made.append(_said(message, features, used))
        else:
            made.append({"role": message.speaker, "content": message.text})
    return made


def _said(message: Message, features: Features, used: set[str]) -> dict[str, Any]:
    made: dict[str, Any] = {"role": "assistant", "content": message.text or None}
    calls = [
        {"id": call.id, "type": "function", "function": {"name": call.name, "arguments": call.arguments}}
        for call in message.calls
    ]
    thoughts, beside = thoughts_of(message.native) if features.thoughts else ({}, ())
    if thoughts or any(beside):
        used.add("thoughts")
        made |= thoughts
    if len(beside) == len(calls):
        calls = [call | extra for call, extra in zip(calls, beside, strict=True)]
    return made | ({"tool_calls": calls} if calls else {})


def _tools(
    tools: Iterable[Tool], features: Features, used: set[str], strict: dict[str, Mapping[str, Any]]
) -> list[dict[str, Any]]:
    made = []
    for tool in tools:
        function: dict[str, Any] = {"name": tool.name, "description": tool.description}
        form = strict_form(tool.parameters) if features.strict else None
        if form is not None:
            function |= {"parameters": form, "strict": True}
            strict[tool.name] = tool.parameters
            used.add("strict")
        else:
            function["parameters"] = dict(tool.parameters) if features.rich_schema else simple_form(tool.parameters)
        made.append({"type": "function", "function": function})
    if features.rich_schema:
        used.add("rich_schema")
    return made


def _choice(sent: Sequence[Message], tools: Sequence[Tool], features: Features, used: set[str]) -> dict[str, Any]:
    must_call = bool(sent) and sent[-1].must_call
    if must_call and len(tools) == 1 and features.named:
        used.add("named")
        return {"tool_choice": {"type": "function", "function": {"name": tools[0].name}}}
    if must_call and features.required:
        used.add("required")
        return {"tool_choice": "required"}
    if features.choice:
        used.add("choice")
        return {"tool_choice": "auto"}
    return {}


def _limits(wish: Wish, features: Features, used: set[str]) -> dict[str, Any]:
    made: dict[str, Any] = {}
    if wish.max_output_tokens is not None:
        name = "max_completion_tokens" if features.completion_tokens else "max_tokens"
        made[name] = wish.max_output_tokens
        if features.completion_tokens:
            used.add("completion_tokens")
    if wish.temperature is not None and features.temperature:
        made["temperature"] = wish.temperature
        used.add("temperature")
    return made
