"""
A dialogue as rounds: what was said, each call with its answer.

Providers that want the answers of a turn in one message take a dialogue down if a call stays without answer, an answer without call,
or if it does not begin and end with the user. Here none of these is left.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from missiontree.llm.chat import Message, ToolCall
from missiontree.llm.history import arguments_of, sendable

UNANSWERED = json.dumps({"ok": False, "refused": [{"message": "This call was not made."}]})
BEGIN, GO_ON = "Begin.", "Go on."
DEEPEST = 16
"""Levels of nesting in arguments that every provider takes back; what the tree-building functions take has at most six."""


@dataclass(frozen=True, slots=True)
class Round:
    """
    One message of the user or the assistant.

    Parameters
    ----------
    message
        What was said; never blank without calls.
    answers
        Answers to its calls, one each, in their order.
    """

    message: Message
    answers: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Rounds:
    """
    A dialogue.

    Parameters
    ----------
    system
        What the model is told before all else.
    said
        What was said; begins with the user and ends with the user or with answers.
    """

    system: str
    said: tuple[Round, ...]


@dataclass(slots=True)
class _Open:
    message: Message
    answers: list[str | None] = field(default_factory=list)

    def answer(self, call_id: str, text: str) -> None:
        for number, call in enumerate(self.message.calls):
            if call.id == call_id and self.answers[number] is None:
                self.answers[number] = text
                return


def rounds_of(messages: Iterable[Message]) -> Rounds:
    """The dialogue in rounds. Calls without answer get one that says so; answers to nothing are left out."""
    system: list[str] = []
    said: list[_Open] = []
    for message in sendable(messages):
        if message.speaker == "system":
            system.append(message.text)
        elif message.speaker == "tool":
            if asked := next((entry for entry in reversed(said) if entry.message.calls), None):
                asked.answer(message.call_id, message.text)
        elif message.text.strip() or message.calls:
            said.append(_Open(message, [None] * len(message.calls)))
    if not said or said[0].message.speaker == "assistant":
        said.insert(0, _Open(Message("user", BEGIN)))
    if said[-1].message.speaker == "assistant" and not said[-1].message.calls:
        said.append(_Open(Message("user", GO_ON)))
    return Rounds("\n\n".join(text for text in system if text.strip()), tuple(_closed(entry) for entry in said))


def must_call(messages: Sequence[Message]) -> bool:
    """Whether what is asked for is a call: the user said so, and said it last."""
    return bool(messages) and messages[-1].must_call


def plain_arguments(call: ToolCall) -> dict[str, object]:
    """The arguments of a call, as every provider takes them back; of none if they are nested too deep or hold a number too large."""
    given = arguments_of(call)
    return given if _takeable(given, DEEPEST) else {}


def named_apart(given: Sequence[str], messages: Sequence[Message]) -> tuple[str, ...]:
    """
    Ids for the calls of the next message, none of which the dialogue has yet.

    Parameters
    ----------
    given
        Ids as the provider gave them; empty where it gave none.
    messages
        The dialogue so far.
    """
    taken = {call.id for message in messages for call in message.calls}
    ids: list[str] = []
    for number, wanted in enumerate(given, start=1):
        made = f"call-{len(messages)}-{number}"
        name = wanted if wanted and wanted not in taken else made
        while name in taken:
            name += "-again"
        taken.add(name)
        ids.append(name)
    return tuple(ids)


def _closed(entry: _Open) -> Round:
    answers = (UNANSWERED if text is None or not text.strip() else text for text in entry.answers)
    return Round(entry.message, tuple(answers))


def _takeable(value: object, levels: int) -> bool:
    if isinstance(value, dict | list):
        within = value.values() if isinstance(value, dict) else value
        return levels > 0 and all(_takeable(entry, levels - 1) for entry in within)
    if isinstance(value, int | float):
        try:
            return math.isfinite(float(value))
        except OverflowError:
            return False
    return True
