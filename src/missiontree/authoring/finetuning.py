"""
Dialogues that ended in a checked tree, as data to fine-tune a chat model on: messages and tools, in the form that trainers take.

Only what was checked is taught: the transcript is replayed, and the finish gate has the word. By default the calls that were refused are
left out, and with them the words that speak of them.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

from missiontree.authoring.builder import TreeBuilder
from missiontree.authoring.declaration import Declaration, Opinion
from missiontree.authoring.outcome import Authored, AuthoringStatus
from missiontree.authoring.taught import call_taught, tools_taught
from missiontree.authoring.transcript import replay
from missiontree.formats.digest import digest
from missiontree.llm.chat import Message, ToolCall
from missiontree.llm.history import sendable
from missiontree.llm.recording import Answered, Recording, read_recording
from missiontree.mission.brief import MissionBrief

_SAID_BEFORE_THE_MISSION = "The mission: "
_MALFORMED = {"malformed_arguments", "unknown_function"}


@dataclass(frozen=True, slots=True, kw_only=True)
class Choice:
    """
    What is taken.

    Parameters
    ----------
    refused
        Keep the calls that were refused but well formed, with their answers, and mark the messages they stand in as not to be learnt
        (``"weight": 0``). Default: leave them out.
    impossible
        Take dialogues, too, that ended with the declaration that the mission cannot be done, where nothing speaks against it. Default:
        only finished trees.
    """

    refused: bool = False
    impossible: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Example:
    """
    One dialogue to learn from.

    Parameters
    ----------
    source, model
        Who held it, as the transcript's header says.
    status
        What it came to.
    messages
        The dialogue as chat endpoints take it.
    refused
        How many of its calls were refused.
    """

    source: str
    model: str
    status: AuthoringStatus
    messages: tuple[dict[str, Any], ...]
    refused: int

    @property
    def line(self) -> str:
        """The line of training data: ASCII, so that no letter can break it."""
        return json.dumps({"messages": self.messages, "tools": tools_taught()}, separators=(",", ":"))


@dataclass(frozen=True, slots=True)
class Unfit:
    """Why a dialogue is not taken, in words."""

    why: str


def example_from(
    lines: Sequence[str], brief: MissionBrief, choice: Choice = Choice(), opinion: Opinion | None = None
) -> Example | Unfit:
    """
    Make an example of a transcript.

    Parameters
    ----------
    lines
        The transcript, a line each.
    brief
        Its mission.
    choice
        What is taken.
    opinion
        What an author without a model makes of the mission, for declarations; None if nobody is asked.

    Raises
    ------
    InputError
        With the line, if the transcript is damaged or does not replay.
    """
    recording = read_recording(lines)
    if recording.mission != digest(brief):
        return Unfit("it was recorded with another mission, fleet, scene or set of routines")
    made = replay(lines, brief)
    if unfit := _not_checked(made, choice, brief, opinion):
        return unfit
    if mission_said(recording) is None:
        return Unfit("it holds calls only: it begins with no words to a model")
    messages = _Editing(recording, choice).messages()
    if not any(message.get("tool_calls") for message in messages):
        return Unfit("none of its calls is left")
    refused = sum(not entry.ok for _, entry in recording.entries if isinstance(entry, Answered))
    return Example(
        source=recording.source, model=recording.model, status=made.status, messages=messages, refused=refused
    )


def mission_said(recording: Recording) -> str | None:
    """The mission in the words that the model was told; None if the transcript begins with no words to a model."""
    said = [entry for _, entry in recording.entries[:2] if isinstance(entry, Message)]
    if [message.speaker for message in said] != ["system", "user"]:
        return None
    text = said[1].text
    return text.removeprefix(_SAID_BEFORE_THE_MISSION) if text.startswith(_SAID_BEFORE_THE_MISSION) else None


def _not_checked(made: Authored, choice: Choice, brief: MissionBrief, opinion: Opinion | None) -> Unfit | None:
    """Why what a dialogue came to is not to be taught; None if it is."""
    why = f": {made.reasons[0].message}" if made.reasons else ""
    if made.status == "complete":
        return None
    if made.status != "cannot_be_done" or not choice.impossible:
        return Unfit(f"it ended as {made.status.replace('_', ' ')}{why}")
    declaration = Declaration(TreeBuilder(brief), opinion)
    if against := declaration.refuted(made.reasons[0].needed) or declaration.doubted():
        return Unfit(f"it ended as cannot be done, and something speaks against that: {against[0].message}")
    return None


class _Editing:
    """Goes through a transcript once and keeps what is taught."""

    def __init__(self, recording: Recording, choice: Choice) -> None:
        self._choice = choice
        self._entries = [entry for _, entry in recording.entries]
        self._answers = {entry.call: entry for entry in self._entries if isinstance(entry, Answered)}
        self._turns = 0
        self._not_learnt: set[str] = set()  # ids of calls that stand there for the sake of what followed
        self._gap = False  # whether something was left out just before

    def messages(self) -> tuple[dict[str, Any], ...]:
        """The dialogue, up to the last message that the model said."""
        kept = list(sendable(self._kept()))
        while kept and kept[-1].speaker != "assistant":
            kept.pop()
        return tuple(self._plain(message) for message in kept)

    def _kept(self) -> Iterator[Message]:
        cut = False
        for entry in self._entries:
            if not isinstance(entry, Message):
                continue
            if entry.speaker != "assistant":
                if not cut or self._choice.refused:  # words about an answer that is left out go with it
                    yield entry
                cut = False
                continue
            self._turns += 1
            cut = entry.finish == "length"
            yield from self._cut(entry) if cut else self._turn(entry)

    def _cut(self, said: Message) -> Iterator[Message]:
        """An answer that was cut: none of its calls was made."""
        self._gap = not self._choice.refused
        if self._choice.refused:
            yield replace(said, calls=())

    def _turn(self, said: Message) -> Iterator[Message]:
        """A message and the answers to its calls."""
        after_a_gap, self._gap = self._gap, False
        kept: list[tuple[ToolCall, Answered]] = []
        for call in said.calls:
            answer = self._answers.get(call.id)
            if answer is None:  # the dialogue ended before it was this call's turn
                continue
            taught = self._taught(call, answer)
            if taught is None:
                self._gap = True
                continue
            taught = replace(taught, id=f"t{self._turns:04d}c{len(kept) + 1:03d}")
            if not answer.ok:
                self._not_learnt.add(taught.id)
            kept.append((taught, answer))
        if kept or not said.calls:
            yield replace(said, text="" if after_a_gap else said.text, calls=tuple(call for call, _ in kept))
        for call, answer in kept:
            yield Message("tool", answer.text, call_id=call.id)

    def _taught(self, call: ToolCall, answer: Answered) -> ToolCall | None:
        """The call as it is taught; None if it is left out."""
        if answer.ok or (self._choice.refused and not _rules(answer) & _MALFORMED):
            return call_taught(call)
        return None

    def _plain(self, message: Message) -> dict[str, Any]:
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
    """Rules that a refusal names; a refusal of a form that is not known counts as one of arguments."""
    try:
        return {str(refused["rule"]) for refused in json.loads(answer.text)["refused"]}
    except (ValueError, KeyError, TypeError, RecursionError):
        return {"malformed_arguments"}
