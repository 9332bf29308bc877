"""Anthropic's Messages API on loopback: plays scripted answers in its wire form, and rejects what the API rejects."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

from jsonschema import Draft202012Validator

from missiontree.llm.anthropic import AnthropicModel
from tests.llm.loopback import Loopback, Reply, Request, serving

KEY = "sk-ant-loopback-0123456789"
Block = dict[str, Any]

_ID = re.compile(r"[a-zA-Z0-9_-]+")
_TOOL = re.compile(r"[a-zA-Z0-9_-]{1,128}")
_REQUEST = {"model", "max_tokens", "messages", "system", "tools", "tool_choice", "stream"}
_BLOCKS = {
    "text": {"type", "text"},
    "tool_use": {"type", "id", "name", "input"},
    "tool_result": {"type", "tool_use_id", "content"},
    "thinking": {"type", "thinking", "signature"},
    "redacted_thinking": {"type", "data"},
}
_BY_ROLE = {
    "user": {"text", "tool_result"},
    "assistant": {"text", "tool_use", "thinking", "redacted_thinking"},
}


def text(words: str) -> Block:
    return {"type": "text", "text": words}


def use(name: str, arguments: str | Mapping[str, Any], call_id: str = "") -> Block:
    """A call; arguments that are text are streamed as they are, however malformed."""
    return {"type": "tool_use", "id": call_id, "name": name, "input": arguments}


def thinking(words: str, signature: str) -> Block:
    return {"type": "thinking", "thinking": words, "signature": signature}


@dataclass(frozen=True)
class Said:
    """One answer of the model."""

    content: Sequence[Block]
    stop_reason: str = ""
    usage: Mapping[str, int] = field(default_factory=lambda: {"input_tokens": 10, "output_tokens": 5})
    stop_details: Mapping[str, Any] | None = None

    @property
    def reason(self) -> str:
        called = any(block["type"] == "tool_use" for block in self.content)
        return self.stop_reason or ("tool_use" if called else "end_turn")


@dataclass
class AnthropicEndpoint:
    """
    The API.

    Parameters
    ----------
    script
        Answers, in order; a ``Reply`` is sent as it is, a ``Said`` in the form that was asked for.
    """

    script: list[Said | Reply]
    issued: list[Block] = field(default_factory=list)
    refusals: list[str] = field(default_factory=list)

    def __call__(self, request: Request) -> Reply:
        try:
            self._check(request)
        except ValueError as error:
            self.refusals.append(str(error))
            return failure(400, "invalid_request_error", str(error))
        said = self.script.pop(0)
        if isinstance(said, Reply):
            return said
        content = [self._named(block) for block in said.content]
        if request.body.get("stream"):
            return Reply.of_events(events_of(said, content))
        return Reply.of_json(_message(said, [_whole(block) for block in content], said.reason, said.usage))

    def _named(self, block: Block) -> Block:
        """The block as it is issued; a call gets an id that no other has."""
        if block["type"] == "tool_use" and not block["id"]:
            block = {**block, "id": f"toolu_{len(self.issued) + 1:02d}"}
        self.issued.append(block)
        return block

    def _check(self, request: Request) -> None:
        _demand(request.path == "/v1/messages", f"there is no {request.path}")
        key = request.headers.get("x-api-key") or request.headers.get("authorization", "").removeprefix("Bearer ")
        _demand(key == KEY, "invalid x-api-key")
        _demand("anthropic-version" in request.headers, "anthropic-version: header is required")
        body = request.body
        _only(body, _REQUEST, "request")
        _demand(isinstance(body["model"], str) and bool(body["model"]), "model: a name is required")
        _demand(isinstance(body["max_tokens"], int) and body["max_tokens"] > 0, "max_tokens: must be positive")
        if "system" in body:
            _demand(bool(body["system"].strip()), "system: text content blocks must be non-empty")
        _check_tools(body)
        self._check_messages(body["messages"])

    def _check_messages(self, messages: list[Block]) -> None:
        _demand(bool(messages) and messages[0]["role"] == "user", "messages: first message must use the user role")
        _demand(messages[-1]["role"] == "user", "This model does not support assistant message prefill.")
        ids: set[str] = set()
        asked: list[str] = []
        role = ""
        for number, message in enumerate(messages):
            where = f"messages.{number}"
            _only(message, {"role", "content"}, where)
            _demand(message["role"] != role, f"{where}: roles must alternate between user and assistant")
            role = message["role"]
            blocks = message["content"]
            _demand(isinstance(blocks, list) and bool(blocks), f"{where}: content must be non-empty")
            for block in blocks:
                self._check_block(block, role, where)
            _check_answers(blocks, asked, where)
            asked = [block["id"] for block in blocks if block["type"] == "tool_use"]
            _demand(len({*asked, *ids}) == len(asked) + len(ids), f"{where}: `tool_use` ids must be unique")
            ids.update(asked)

    def _check_block(self, block: Block, role: str, where: str) -> None:
        kind = block["type"]
        _demand(kind in _BY_ROLE[role], f"{where}: a {kind} block cannot stand there")
        _only(block, _BLOCKS[kind], f"{where}.{kind}")
        if kind == "text":
            _demand(bool(block["text"].strip()), f"{where}: text content blocks must contain non-whitespace text")
        elif kind == "tool_use":
            _demand(bool(_ID.fullmatch(block["id"])), f"{where}: tool_use.id should match pattern")
            _demand(bool(_TOOL.fullmatch(block["name"])), f"{where}: tool_use.name should match pattern")
            _demand(isinstance(block["input"], dict), f"{where}: tool_use.input should be a valid dictionary")
        elif kind != "tool_result":
            _demand(block in self.issued, f"{where}: `{kind}` blocks cannot be modified")


def _check_answers(blocks: Sequence[Block], asked: Sequence[str], where: str) -> None:
    answered = [block["tool_use_id"] for block in blocks if block["type"] == "tool_result"]
    _demand(set(answered) <= set(asked), f"{where}: unexpected `tool_use_id` found in `tool_result` blocks")
    _demand(len(set(answered)) == len(answered), f"{where}: each tool_use must have a single result")
    missing = ", ".join(sorted(set(asked) - set(answered)))
    _demand(
        not missing, f"{where}: `tool_use` ids were found without `tool_result` blocks immediately after: {missing}"
    )
    first = [block["type"] for block in blocks[: len(answered)]]
    _demand(first == ["tool_result"] * len(answered), f"{where}: tool_result blocks must come first")


def _check_tools(body: Block) -> None:
    tools = body.get("tools", [])
    names = [tool["name"] for tool in tools]
    _demand(len(set(names)) == len(names), "tools: Tool names must be unique")
    for tool in tools:
        _only(tool, {"name", "description", "input_schema"}, "tools")
        _demand(bool(_TOOL.fullmatch(tool["name"])), "tools.name should match pattern")
        _demand(tool["input_schema"].get("type") == "object", "tools.input_schema.type: must be object")
        Draft202012Validator.check_schema(tool["input_schema"])
    if choice := body.get("tool_choice"):
        _demand(bool(tools), "tool_choice may only be specified while providing tools")
        _demand(choice in ({"type": "any"}, {"type": "auto"}), "tool_choice: unknown")


def _only(plain: Block, allowed: set[str], where: str) -> None:
    _demand(isinstance(plain, dict), f"{where}: must be an object")
    extra = ", ".join(sorted(set(plain) - allowed))
    _demand(not extra, f"{where}: Extra inputs are not permitted: {extra}")


def _demand(held: bool, words: str) -> None:
    if not held:
        raise ValueError(words)


def failure(status: int, kind: str, words: str, **headers: str) -> Reply:
    """An error in the API's form."""
    return Reply.of_json({"type": "error", "error": {"type": kind, "message": words}}, status, **headers)


def events_of(said: Said, content: Sequence[Block]) -> list[bytes]:
    """The answer as the stream of events that the API sends, texts in two pieces each and a ping in between."""
    start = _message(said, [], None, {**said.usage, "output_tokens": 1})
    events: list[Block] = [{"type": "message_start", "message": start}]
    for index, block in enumerate(content):
        empty, deltas = _in_deltas(block)
        events.append({"type": "content_block_start", "index": index, "content_block": empty})
        events.append({"type": "ping"})
        events += [{"type": "content_block_delta", "index": index, "delta": delta} for delta in deltas]
        events.append({"type": "content_block_stop", "index": index})
    delta = {"stop_reason": said.reason, "stop_sequence": None, "stop_details": said.stop_details}
    events.append({"type": "message_delta", "delta": delta, "usage": {"output_tokens": said.usage["output_tokens"]}})
    events.append({"type": "message_stop"})
    return [event(plain) for plain in events]


def event(plain: Block) -> bytes:
    return f"event: {plain['type']}\ndata: {json.dumps(plain)}\n\n".encode()


def _in_deltas(block: Block) -> tuple[Block, list[Block]]:
    """How a block begins, and what makes it grow."""
    if block["type"] == "text":
        return {**block, "text": ""}, [{"type": "text_delta", "text": half} for half in _halves(block["text"])]
    if block["type"] == "thinking":
        grown = [{"type": "thinking_delta", "thinking": half} for half in _halves(block["thinking"])]
        grown.append({"type": "signature_delta", "signature": block["signature"]})
        return {**block, "thinking": "", "signature": ""}, grown
    if block["type"] == "tool_use":
        written = block["input"] if isinstance(block["input"], str) else json.dumps(block["input"])
        halves = ["", *_halves("" if written == "{}" else written)]
        return {**block, "input": {}}, [{"type": "input_json_delta", "partial_json": half} for half in halves]
    return block, []


def _halves(words: str) -> list[str]:
    middle = len(words) // 2
    return [half for half in (words[:middle], words[middle:]) if half]


def _whole(block: Block) -> Block:
    """A block of an answer that is not streamed: the API has read the arguments by then."""
    if block["type"] == "tool_use" and isinstance(block["input"], str):
        return {**block, "input": json.loads(block["input"])}
    return block


def _message(said: Said, content: Sequence[Block], reason: str | None, usage: Mapping[str, int]) -> Block:
    return {
        "id": "msg_1",
        "type": "message",
        "role": "assistant",
        "model": "claude-loopback",
        "content": list(content),
        "stop_reason": reason,
        "stop_sequence": None,
        "stop_details": said.stop_details if reason else None,
        "usage": dict(usage),
    }


@dataclass
class Answered:
    """A model, and the endpoint that it asks."""

    model: AnthropicModel
    endpoint: AnthropicEndpoint
    server: Loopback

    @property
    def bodies(self) -> list[Block]:
        return [request.body for request in self.server.requests]


@contextmanager
def answering(*script: Said | Reply, **settings: Any) -> Iterator[Answered]:
    """A model of Anthropic's whose API answers from the script."""
    endpoint = AnthropicEndpoint(list(script))
    with serving(endpoint) as server:
        model = AnthropicModel(**{"model": "claude-loopback", "api_key": KEY, "base_url": server.url, **settings})
        yield Answered(model, endpoint, server)
