"""A recorded dialogue as it is taught: what was refused left out, or marked as not to be learnt."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from missiontree.authoring.taught import call_taught
from missiontree.llm.chat import Message, ToolCall
from missiontree.llm.history import sendable
from missiontree.llm.recording import Answered, Recording

_MALFORMED = {"malformed_arguments", "unknown_function"}
Turn = tuple[Message, list[Answered]]
"""A message, and the answers to its calls, in order; the calls behind the last answer were not made."""


def retold(recording: Recording, refused: bool) -> tuple[dict[str, Any], ...]:
    """
    The dialogue as chat endpoints take it, up to the last message that the model said.

    Parameters
    ----------
    recording
        The transcript, which replays.
    refused
        Whether refused calls that were well formed stay, with their answers, and likewise answers that were cut; their messages have
        ``"weight": 0``. Otherwise they are left out, and so are the words that the model said next, which may speak of them.
    """
    telling = _Telling(refused)
    kept = list(sendable(message for turn in _turns(recording) for message in telling.told(*turn)))
    while kept and kept[-1].speaker != "assistant":
        kept.pop()
    return tuple(telling.plain(message) for message in kept)


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

    def __init__(self, refused: bool) -> None:
        self._refused = refused
        self._number = 0  # of the model's message
        self._was_cut = self._gap = False  # of the message before; whether something of it was left out
        self._not_learnt: set[str] = set()  # ids of calls that stay for the sake of what follows them

    def told(self, said: Message, answers: list[Answered]) -> Iterator[Message]:
        """What stays of a message and of the answers to its calls."""
        was_cut, gap = self._was_cut, self._gap
        self._was_cut = False
        if said.speaker != "assistant":
            if not was_cut or self._refused:  # words about an answer that is left out go with it
                yield said
            return
        self._number += 1
        if said.finish == "length":  # none of its calls was made
            self._was_cut, self._gap = True, not self._refused
            if self._refused:
                yield replace(said, calls=())
            return
        kept = self._kept(said, answers)
        self._gap = len(kept) < len(answers)
        if kept or not answers:
            yield replace(said, text="" if gap else said.text, calls=tuple(call for call, _ in kept))
        for call, answer in kept:
            yield Message("tool", answer.text, call_id=call.id)

    def _kept(self, said: Message, answers: list[Answered]) -> list[tuple[ToolCall, Answered]]:
        kept: list[tuple[ToolCall, Answered]] = []
        for call, answer in zip(said.calls, answers, strict=False):
            stays = answer.ok or (self._refused and not _rules(answer) & _MALFORMED)
            if stays and (taught := call_taught(call)) is not None:
                taught = replace(taught, id=f"t{self._number:04d}c{len(kept) + 1:03d}")
                kept.append((taught, answer))
                if not answer.ok:
                    self._not_learnt.add(taught.id)
        return kept

    def plain(self, message: Message) -> dict[str, Any]:
        """A message as chat endpoints take it."""
        if message.speaker == "tool":
            return {"role": "tool", "tool_call_id": message.call_id, "content": message.text}
        if message.speaker != "assistant":
            return {"role": message.speaker, "content": message.text}
        made: dict[str, Any] = {"role": "assistant", "content": message.text or None}
        if message.calls:
            made["tool_calls"] = [
                {"id": call.id, "type": "function", "function": {"name": call.name, "arguments": call.arguments}}
                for call in message.calls
            ]
        if message.finish == "length" or any(call.id in self._not_learnt for call in message.calls):
            made["weight"] = 0
        return made


def _rules(answer: Answered) -> set[str]:
    """Rules that a refusal names; one in a form that is not known counts as malformed."""
    try:
        return {str(refused["rule"]) for refused in json.loads(answer.text)["refused"]}
    except (ValueError, KeyError, TypeError, RecursionError):
        return _MALFORMED
