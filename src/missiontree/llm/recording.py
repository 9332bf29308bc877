"""
A dialogue as text: JSON Lines, one canonical object per line, ASCII throughout so that no letter can break a line.

The first line is the header: format, where the turns came from, the digest of the mission. Then come messages and answers in the order
in which they were said, and an end line with what it came to. A model's message says how it ended and what tokens it took.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, get_args

from missiontree.errors import InputError
from missiontree.llm.chat import Finish, Message, ToolCall, Usage

FORMAT = "transcript/2"
_CALL_KEYS = {"id": str, "name": str, "arguments": str}
_KEYS: dict[str, dict[str, type]] = {
    "message": {"speaker": str, "text": str, "calls": list, "finish": str, "usage": list},
    "answer": {"call": str, "ok": bool, "text": str},
    "end": {"status": str, "reasons": list, "reading": list, "remarks": list, "spent": dict},
}
_SPEAKERS = {"system", "user", "assistant"}
_MOST_TOKENS = 10**12


@dataclass(frozen=True, slots=True)
class Answered:
    """The answer a call was given, as recorded."""

    call: str
    ok: bool
    text: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Recording:
    """
    A transcript, read.

    Parameters
    ----------
    source
        Who the turns came from: ``offline``, ``scripted``, ``recorded``, or a provider.
    model
        The provider's model; empty if there was none.
    endpoint
        Address of the endpoint, without anything secret; empty for the provider's own and for stand-ins.
    mission
        Digest of the mission and its inputs.
    entries
        Messages and answers with the lines they stand on.
    end
        What the dialogue came to: ``status``, ``reasons``, ``reading``, ``remarks``, and what it took, ``spent``.
    """

    source: str
    model: str
    endpoint: str
    mission: str
    entries: tuple[tuple[int, Message | Answered], ...]
    end: Mapping[str, Any]


def line_of(plain: Mapping[str, Any]) -> str:
    """One line of a transcript: keys sorted, no blanks, ASCII."""
    return json.dumps(plain, sort_keys=True, separators=(",", ":"), allow_nan=False)


def header_line(source: str, model: str, endpoint: str, mission: str) -> str:
    """The first line."""
    return line_of({"format": FORMAT, "source": source, "model": model, "endpoint": endpoint, "mission": mission})


def message_line(message: Message) -> str:
    """A message with the calls it asks for."""
    calls = [{"id": call.id, "name": call.name, "arguments": call.arguments} for call in message.calls]
    usage: list[float] = [] if message.usage is None else [message.usage.input_tokens, message.usage.output_tokens]
    if message.usage is not None and message.usage.cost_usd is not None:
        usage.append(message.usage.cost_usd)
    plain = {"kind": "message", "speaker": message.speaker, "text": message.text, "calls": calls}
    return line_of(plain | {"finish": message.finish, "usage": usage})


def answer_line(call: str, ok: bool, text: str) -> str:
    """The answer to a call."""
    return line_of({"kind": "answer", "call": call, "ok": ok, "text": text})


def read_recording(lines: Sequence[str]) -> Recording:
    """
    Read a transcript.

    Raises
    ------
    InputError
        With the line, if the transcript is damaged: not JSON, not of the format, cut off, or with something after its end.
    """
    header = _header(lines)
    entries: list[tuple[int, Message | Answered]] = []
    end: dict[str, Any] | None = None
    for number, line in enumerate(lines[1:], start=2):
        if end is not None:
            raise damaged(number, "something stands after the end line")
        plain = _plain(line, number)
        kind = plain.get("kind")
        if not isinstance(kind, str) or kind not in _KEYS:
            raise damaged(number, f"there is no kind of line {kind!r}", accepted=", ".join(_KEYS))
        _check_keys(plain, _KEYS[kind], {"kind"}, number)
        if kind == "end":
            end = plain
        elif kind == "answer":
            entries.append((number, Answered(plain["call"], plain["ok"], plain["text"])))
        else:
            entries.append((number, _message(plain, number)))
    if end is None:
        raise damaged(len(lines), "the transcript is cut off: its end line is missing")
    return Recording(
        source=header["source"],
        model=header["model"],
        endpoint=header["endpoint"],
        mission=header["mission"],
        entries=tuple(entries),
        end=end,
    )


def damaged(number: int, message: str, accepted: str = "") -> InputError:
    """The error of a damaged transcript, with its line."""
    return InputError(message, file="transcript", line=number, accepted=accepted, hint="Record the dialogue again.")


def _header(lines: Sequence[str]) -> dict[str, Any]:
    if not lines:
        raise damaged(1, "the transcript is empty", accepted=f'a first line with "format": "{FORMAT}"')
    header = _plain(lines[0], 1)
    if header.get("format") != FORMAT:
        raise damaged(1, f"the format is {header.get('format')!r}", accepted=FORMAT)
    _check_keys(header, {"source": str, "model": str, "endpoint": str, "mission": str}, {"format"}, 1)
    return header


def _plain(line: str, number: int) -> dict[str, Any]:
    try:
        plain = json.loads(line)
    except (ValueError, RecursionError) as error:
        raise damaged(number, f"the line is not JSON: {error}") from error
    if not isinstance(plain, dict):
        raise damaged(number, "the line is not a JSON object")
    return plain


def _check_keys(plain: Mapping[str, Any], wanted: Mapping[str, type], beside: set[str], number: int) -> None:
    if set(plain) != set(wanted) | beside:
        raise damaged(
            number, f"the line has the keys {', '.join(sorted(plain))}", accepted=", ".join(sorted({*wanted, *beside}))
        )
    for key, kind in wanted.items():
        if not isinstance(plain[key], kind):
            raise damaged(number, f"{key} is {plain[key]!r}", accepted=f"a {kind.__name__}")


def _message(plain: Mapping[str, Any], number: int) -> Message:
    if plain["speaker"] not in _SPEAKERS:
        raise damaged(number, f"the speaker is {plain['speaker']!r}", accepted=", ".join(sorted(_SPEAKERS)))
    calls = []
    for call in plain["calls"]:
        if not isinstance(call, dict):
            raise damaged(number, f"a call is {call!r}", accepted="an object")
        _check_keys(call, _CALL_KEYS, set(), number)
        calls.append(ToolCall(call["id"], call["name"], call["arguments"]))
    if plain["finish"] not in get_args(Finish):
        raise damaged(number, f"finish is {plain['finish']!r}", accepted=", ".join(get_args(Finish)))
    return Message(
        plain["speaker"],
        plain["text"],
        tuple(calls),
        finish=plain["finish"],
        usage=_usage(plain["usage"], number),
    )


def _usage(plain: list[Any], number: int) -> Usage | None:
    """Tokens in and out, and money where it was known."""
    if not plain:
        return None
    whole = all(isinstance(tokens, int) and not isinstance(tokens, bool) for tokens in plain[:2])
    numbers = whole and all(isinstance(entry, int | float) and 0 <= entry < _MOST_TOKENS for entry in plain)
    if len(plain) not in {2, 3} or not numbers or isinstance(plain[-1], bool):
        raise damaged(number, f"usage is {plain!r:.80}", accepted="nothing, or tokens in, tokens out, and US dollars")
    return Usage(plain[0], plain[1], float(plain[2]) if len(plain) == 3 else None)
