"""A recorded dialogue as it is taught: its slips left out, or marked as not to be learnt."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Any

from missiontree.authoring.prompt import reminder
from missiontree.authoring.taught import call_taught
from missiontree.llm.chat import Message, ToolCall
from missiontree.llm.history import sendable
from missiontree.llm.recording import Answered, Recording
from missiontree.mission.routine import RoutineLibrary

_MALFORMED = {"malformed_arguments", "unknown_function"}
_REMINDER = reminder(()).text.partition("\n")[0]
Turn = tuple[Message, list[Answered]]
"""A message, and the answers to its calls, in order; the calls behind the last answer were not made."""
Told = tuple[Message, bool]
"""A message, and whether it is to be learnt."""


def retold(recording: Recording, library: RoutineLibrary, slips: bool) -> tuple[dict[str, Any], ...]:
    """
    The dialogue as chat endpoints take it, up to the last message that the model said.

    Parameters
    ----------
    recording
        The transcript, which replays.
    library
        The routines of its mission.
    slips
        Slips are refused calls, answers that were cut, and stopping before the tree is finished. True: they stay, with what was said to
        them, in messages that have ``"weight": 0``; only malformed calls are left out. False: they are left out, and so are the words that
        the model said next, since these may speak of them.
    """
    made: list[dict[str, Any]] = []
    for message, learnt in _Telling(library, slips).told(_turns(recording)):
        for clean in sendable((message,)):
            _put(made, _plain(clean) | ({} if learnt else {"weight": 0}))
    while made and made[-1]["role"] != "assistant":
        made.pop()
    return tuple(made)


def _turns(recording: Recording) -> list[Turn]:
    turns: list[Turn] = []
    for _, entry in recording.entries:
        if isinstance(entry, Message):
            turns.append((entry, []))
        elif turns:
            turns[-1][1].append(entry)
    return turns


class _Telling:
    """Goes through a dialogue once."""

    def __init__(self, library: RoutineLibrary, slips: bool) -> None:
        self._library, self._slips = library, slips
        self._number = 0  # of the model's message
        self._gap = False  # whether something was left out since the model spoke last

    def told(self, turns: list[Turn]) -> Iterator[Told]:
        """What stays of a dialogue."""
        following = [said for said, _ in turns[1:]] + [Message("user")]
        answer_left_out = False
        for (said, answers), then in zip(turns, following, strict=True):
            if said.speaker != "assistant":
                if not answer_left_out:  # words about an answer that is left out go with it
                    yield said, True
                answer_left_out = False
                continue
            self._number += 1
            if said.finish == "length" or (not said.calls and _is_reminder(then)):
                answer_left_out = self._gap = not self._slips
                if self._slips:
                    yield replace(said, calls=()), False
            else:
                yield from self._turn(said, answers)

    def _turn(self, said: Message, answers: list[Answered]) -> Iterator[Told]:
        kept = self._kept(said.calls, answers)
        gap, self._gap = self._gap, len(kept) < len(answers)
        if kept or not answers:
            text = "" if gap else said.text
            yield replace(said, text=text, calls=tuple(call for call, _ in kept)), all(answer.ok for _, answer in kept)
        for call, answer in kept:
            yield Message("tool", answer.text, call_id=call.id), True

    def _kept(self, calls: Iterable[ToolCall], answers: Iterable[Answered]) -> list[tuple[ToolCall, Answered]]:
        kept: list[tuple[ToolCall, Answered]] = []
        for call, answer in zip(calls, answers, strict=False):
            stays = answer.ok or (self._slips and not _rules(answer) & _MALFORMED)
            if stays and (taught := call_taught(call, self._library)) is not None:
                kept.append((replace(taught, id=f"t{self._number:04d}c{len(kept) + 1:03d}"), answer))
        return kept


def _is_reminder(message: Message) -> bool:
    return message.speaker == "user" and message.text.startswith(_REMINDER)


def _rules(answer: Answered) -> set[str]:
    """Rules that a refusal names; one in a form that is not known counts as malformed."""
    try:
        return {str(refused["rule"]) for refused in json.loads(answer.text)["refused"]}
    except (ValueError, KeyError, TypeError, RecursionError):
        return _MALFORMED


def _put(made: list[dict[str, Any]], message: dict[str, Any]) -> None:
    """Put a message behind the others; the user speaks once at a time."""
    if made and made[-1]["role"] == message["role"] == "user":
        made[-1]["content"] += f"\n\n{message['content']}"
    else:
        made.append(message)


def _plain(message: Message) -> dict[str, Any]:
    if message.speaker == "tool":
        return {"role": "tool", "tool_call_id": message.call_id, "content": message.text}
    if message.speaker != "assistant":
        return {"role": message.speaker, "content": message.text}
    calls = [
        {"id": call.id, "type": "function", "function": {"name": call.name, "arguments": call.arguments}}
        for call in message.calls
    ]
    return {"role": "assistant", "content": message.text or None} | ({"tool_calls": calls} if calls else {})
