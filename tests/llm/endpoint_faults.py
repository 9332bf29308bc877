"""Every fault of a provider that is provoked, and what each must come to."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

from missiontree.llm.chat import FaultKind
from missiontree.llm.features import FEATURES
from tests.llm.endpoint import Fault
from tests.llm.endpoint_replies import (
    Ending,
    Reply,
    Turn,
    completion,
    delta,
    deltas,
    error,
    events,
    json_body,
    written,
)

Fate = Literal["passes", "final", "told"]
HTML = b"<!doctype html><html><head><title>Sign in</title></head><body>Please sign in.</body></html>"


@dataclass(frozen=True)
class Case:
    """
    A fault and what it must come to.

    Parameters
    ----------
    name
        What it is called in the table.
    fault
        Makes it.
    fate
        ``passes``: met once, it leaves no trace, and met for ever it ends the dialogue. ``final``: it ends the dialogue at once.
        ``told``: the model is told of it and goes on to the same tree.
    kind
        The last word of the reason's rule, ``provider_<kind>``, when it ends the dialogue.
    waits
        Seconds slept before the second, third and fourth attempt.
    holds
        Whether it shows itself by silence, so that patience must be short.
    requests
        Most requests that a final fault may cost.
    refused
        Calls that are refused because of it.
    """

    name: str
    fault: Fault
    fate: Fate
    kind: FaultKind | Literal["filtered", "refused", ""] = ""
    waits: tuple[float, ...] = (1, 2, 4)
    holds: bool = False
    requests: int = 1
    refused: int = 0


def _error(status: int, message: str, code: str | None = None, **headers: str) -> Fault:
    return lambda turn, stream: error(status, message, code, **headers)


def _raw(content_type: str, body: bytes) -> Fault:
    return lambda turn, stream: Reply((body,), headers={"content-type": content_type})


def _silent(turn: Turn, stream: bool) -> Reply:
    return Reply(ending="hold")


def _reset(turn: Turn, stream: bool) -> Reply:
    return Reply(ending="reset")


def _broken_off(after: Literal["text", "arguments"], ending: Ending) -> Fault:
    """The answer begins, and breaks off in the middle of its text or of the arguments of its last call."""

    def fault(turn: Turn, stream: bool) -> Reply:
        said = turn if turn.calls or after == "text" else replace(turn, calls=(("checkTree", '{"sub'),))
        if not stream:
            body = json_body(completion(said)).pieces[0]
            end = body.index(b'"content"') + 20 if after == "text" else body.rindex(b'"arguments"') + 20
            return Reply((body[:end],), headers={"content-type": "application/json"}, ending=ending)
        parts = deltas(said)
        of_text = [at for at, part in enumerate(parts) if part["choices"][0]["delta"].get("content")]
        return events(parts[: of_text[0] + 1] if after == "text" else parts[:-2], ending)

    return fault


def _unfinished(turn: Turn, stream: bool) -> Reply:
    """The answer ends in good order, and does not say that it is finished; without a stream, it breaks off."""
    return events([*deltas(turn)[:-1], "[DONE]"]) if stream else _broken_off("arguments", "cut")(turn, stream)


def _error_inside(message: str, code: str) -> Fault:
    """The status is good, and the body brings an error."""

    def fault(turn: Turn, stream: bool) -> Reply:
        said: dict[str, Any] = {"error": {"message": message, "type": code, "code": code}}
        return events([*deltas(turn)[:2], said]) if stream else json_body(said)

    return fault


def _said(turn: Turn, stream: bool) -> Reply:
    """A turn that is said although it is not the one that was due."""
    return events([*deltas(turn), "[DONE]"]) if stream else json_body(completion(turn))


def _of_length(turn: Turn, stream: bool) -> Reply:
    """Cut at the most it may say, in the middle of its last call; the calls before that are whole."""
    return _said(replace(_with_last_cut(turn), finish="length"), stream)


def _cheerful(turn: Turn, stream: bool) -> Reply:
    """The arguments of the last call are cut, and nothing says so. What is said next is that call alone, whole."""
    rest = replace(turn, calls=turn.calls[-1:]) if turn.calls else turn
    return replace(_said(_with_last_cut(turn), stream), then=rest)


def _with_last_cut(turn: Turn) -> Turn:
    calls: Sequence[Any] = turn.calls or (("checkTree", {"subtask": "a"}),)
    name, arguments = calls[-1]
    text = written(arguments)
    return replace(turn, calls=(*calls[:-1], (name, text[: len(text) // 2])))


def _filtered(turn: Turn, stream: bool) -> Reply:
    return _said(Turn(turn.text[:9], finish="content_filter"), stream)


def _refusing(turn: Turn, stream: bool) -> Reply:
    words = "I cannot help with that."
    if stream:
        return events([delta({"role": "assistant"}), delta({"refusal": words}), delta({}, "stop"), "[DONE]"])
    plain = completion(Turn())
    plain["choices"][0]["message"]["refusal"] = words
    return json_body(plain)


def _no_choices(turn: Turn, stream: bool) -> Reply:
    plain = {"object": "chat.completion", "choices": []}
    return events([plain, "[DONE]"]) if stream else json_body(plain)


def _of_another_shape(turn: Turn, stream: bool) -> Reply:
    plain = {"choices": {"message": "hello"}}
    return events([plain, "[DONE]"]) if stream else json_body(plain)


def _garbage(turn: Turn, stream: bool) -> Reply:
    if stream:
        return events([deltas(turn)[0], '{"choices": [{"delta" 7}', "[DONE]"])
    return Reply((b'{"choices": [{"message" 7}',), headers={"content-type": "application/json"})


_OVERFLOW = "This model's maximum context length is 8192 tokens. However, your messages resulted in 9001 tokens."

CASES = (
    Case("429, Retry-After 2", _error(429, "Slow down.", retry_after="2"), "passes", "rate_limited", (2, 2, 2)),
    Case(
        "429, retry-after-ms 500", _error(429, "Slow down.", retry_after_ms="500"), "passes", "rate_limited", (0.5,) * 3
    ),
    Case("429, no Retry-After", _error(429, "Slow down."), "passes", "rate_limited"),
    Case("429, Retry-After beyond the cap", _error(429, "Slow down.", retry_after="3600"), "final", "rate_limited"),
    Case("429, insufficient_quota", _error(429, "You exceeded your quota.", "insufficient_quota"), "final", "failed"),
    Case("500", _error(500, "Oops."), "passes", "overloaded"),
    Case("503", _error(503, "Busy."), "passes", "overloaded"),
    Case(
        "503, an HTML page",
        lambda turn, stream: Reply((HTML,), 503, {"content-type": "text/html"}),
        "passes",
        "overloaded",
    ),
    Case("401", _error(401, "Incorrect API key provided."), "final", "unauthorised"),
    Case("404", _error(404, "The model does not exist.", "model_not_found"), "final", "no_such_model"),
    Case("400, unexplained", _error(400, "Bad request."), "final", "bad_request", requests=1 + len(FEATURES)),
    Case("context overflow", _error(400, _OVERFLOW, "context_length_exceeded"), "final", "context_overflow"),
    Case("silence", _silent, "passes", "timed_out", holds=True),
    Case("silence in mid text", _broken_off("text", "hold"), "passes", "timed_out", holds=True),
    Case("connection reset", _reset, "passes", "cut_off"),
    Case("reset in mid text", _broken_off("text", "reset"), "passes", "cut_off"),
    Case("cut in mid text", _broken_off("text", "cut"), "passes", "cut_off"),
    Case("cut in mid arguments", _broken_off("arguments", "cut"), "passes", "cut_off"),
    Case("no finish reason", _unfinished, "passes", "cut_off"),
    Case("error inside, of the server", _error_inside("The engine died.", "server_error"), "passes", "overloaded"),
    Case("error inside, of the rate", _error_inside("Slow down.", "rate_limit_exceeded"), "passes", "rate_limited"),
    Case(
        "error inside, of the length", _error_inside(_OVERFLOW, "context_length_exceeded"), "final", "context_overflow"
    ),
    Case("no choices", _no_choices, "passes", "empty"),
    Case("content filter", _filtered, "final", "filtered"),
    Case("content filter, as 400", _error(400, "Filtered.", "content_filter"), "final", "filtered"),
    Case("refusal", _refusing, "final", "refused"),
    Case("HTML page", _raw("text/html; charset=utf-8", HTML), "final", "failed"),
    Case("HTML page, called JSON", _raw("application/json", HTML), "final", "failed"),
    Case("JSON garbage", _garbage, "final", "failed"),
    Case("JSON of another shape", _of_another_shape, "final", "failed"),
    Case("length", _of_length, "told"),
    Case("arguments cut, cheerful finish", _cheerful, "told", refused=1),
)
