"""What the endpoint of the tests can put on the wire: answers, whole or in pieces, and everything that goes wrong with them."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

Arguments = str | Mapping[str, Any]
Ending = Literal["whole", "cut", "reset", "hold"]


@dataclass(frozen=True)
class Turn:
    """
    What the model of the endpoint says.

    Parameters
    ----------
    text
        Words.
    calls
        Functions and their arguments; arguments that are texts go out as they are.
    finish
        Why it ends.
    """

    text: str = ""
    calls: tuple[tuple[str, Arguments], ...] = ()
    finish: str | None = None

    @property
    def reason(self) -> str:
        return self.finish or ("tool_calls" if self.calls else "stop")


@dataclass(frozen=True)
class Reply:
    """
    Bytes for the wire.

    Parameters
    ----------
    pieces
        The body.
    status, headers
        As in HTTP.
    ending
        ``whole``: as announced. ``cut``: the connection is closed after the pieces. ``reset``: it is torn down, before the headers if
        there are no pieces. ``hold``: nothing more comes until the client gives up.
    then
        What the model says next, if it is not to say the same turn again.
    """

    pieces: tuple[bytes, ...] = ()
    status: int = 200
    headers: Mapping[str, str] = field(default_factory=dict)
    ending: Ending = "whole"
    then: Turn | None = None


def answered(turn: Turn, body: Mapping[str, Any], number: int) -> Reply:
    """The turn as the request wants it: as one JSON object, or as a stream of events."""
    if not body.get("stream"):
        return Reply((json.dumps(completion(turn, number)).encode(),), headers={"content-type": "application/json"})
    return events([*deltas(turn, number), *([usage_event()] if "stream_options" in body else []), "[DONE]"])


def events(data: Sequence[Any], ending: Ending = "whole") -> Reply:
    """Server-sent events, of objects or of texts as they are."""
    texts = [entry if isinstance(entry, str) else json.dumps(entry) for entry in data]
    pieces = tuple(f"data: {text}\n\n".encode() for text in texts)
    return Reply(pieces, headers={"content-type": "text/event-stream; charset=utf-8"}, ending=ending)


def json_body(plain: Any, status: int = 200, **headers: str) -> Reply:
    """A JSON body."""
    named = {name.replace("_", "-"): value for name, value in headers.items()}
    return Reply((json.dumps(plain).encode(),), status, {"content-type": "application/json", **named})


def error(status: int, message: str, code: str | int | None = None, **headers: str) -> Reply:
    """An error as OpenAI words it."""
    return json_body({"error": {"message": message, "type": "error", "param": None, "code": code}}, status, **headers)


def completion(turn: Turn, number: int = 1) -> dict[str, Any]:
    """A chat completion."""
    calls = [
        {"id": f"call_{number}_{at}", "type": "function", "function": {"name": name, "arguments": written(arguments)}}
        for at, (name, arguments) in enumerate(turn.calls)
    ]
    message: dict[str, Any] = {"role": "assistant", "content": turn.text or None}
    if calls:
        message["tool_calls"] = calls
    choice = {"index": 0, "message": message, "finish_reason": turn.reason}
    usage = {"prompt_tokens": 100, "completion_tokens": 10, "total_tokens": 110}
    return {"id": f"chatcmpl-{number}", "object": "chat.completion", "choices": [choice], "usage": usage}


def deltas(turn: Turn, number: int = 1) -> list[dict[str, Any]]:
    """The events of a chat completion, texts and arguments cut into pieces of seven letters."""
    made = [delta({"role": "assistant", "content": ""})]
    made += [delta({"content": piece}) for piece in cut(turn.text)]
    for at, (name, arguments) in enumerate(turn.calls):
        head = {
            "index": at,
            "id": f"call_{number}_{at}",
            "type": "function",
            "function": {"name": name, "arguments": ""},
        }
        made.append(delta({"tool_calls": [head]}))
        made += [
            delta({"tool_calls": [{"index": at, "function": {"arguments": part}}]}) for part in cut(written(arguments))
        ]
    made.append(delta({}, turn.reason))
    return made


def delta(said: Mapping[str, Any], finish: str | None = None) -> dict[str, Any]:
    """One event of a stream."""
    return {"object": "chat.completion.chunk", "choices": [{"index": 0, "delta": said, "finish_reason": finish}]}


def usage_event() -> dict[str, Any]:
    """The event that counts tokens, which has no choices."""
    usage = {"prompt_tokens": 100, "completion_tokens": 10, "total_tokens": 110}
    return {"object": "chat.completion.chunk", "choices": [], "usage": usage}


def cut(text: str) -> list[str]:
    """Pieces of seven letters."""
    return [text[start : start + 7] for start in range(0, len(text), 7)]


def written(arguments: Arguments) -> str:
    """Arguments as they stand on the wire."""
    return arguments if isinstance(arguments, str) else json.dumps(dict(arguments))
