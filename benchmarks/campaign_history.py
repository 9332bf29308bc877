"""What must hold of every dialogue with a model, whatever it said: read off the outcome, the transcript and the messages."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, get_args

from missiontree.authoring.budgets import Budgets
from missiontree.authoring.builder import State, TreeBuilder
from missiontree.authoring.findings import gate
from missiontree.authoring.outcome import Authored, AuthoringStatus
from missiontree.authoring.tools import ToolBox
from missiontree.authoring.transcript import replay
from missiontree.formats.document import write_text
from missiontree.llm.chat import Message
from missiontree.llm.history import NAME, sendable
from missiontree.mission.brief import MissionBrief
from missiontree.routines.ground import ground

INVALID = "invalid trees accepted"
TRACES = "refused calls that left a trace"
REPLAYS = "histories that do not replay"
REJECTED = "histories that a provider would reject"
UNBOUNDED = "unbounded runs"
UNNAMED = "outcomes without a name"
NEVER = (INVALID, TRACES, REPLAYS, REJECTED, UNBOUNDED, UNNAMED)

Violation = tuple[str, str]


@dataclass(frozen=True, slots=True)
class Asked:
    """A call as the transcript has it, and whether it was accepted."""

    name: str
    arguments: str
    ok: bool


def asked_of(transcript: Sequence[str]) -> list[Asked]:
    """Every call that was answered, in order."""
    calls: dict[str, dict[str, Any]] = {}
    found = []
    for line in transcript:
        entry = json.loads(line)
        calls |= {call["id"]: call for call in entry.get("calls", ())}
        if entry.get("kind") == "answer":
            call = calls[entry["call"]]
            found.append(Asked(call["name"], call["arguments"], entry["ok"]))
    return found


def faults_of(
    made: Authored, brief: MissionBrief, budgets: Budgets, last_seen: Sequence[Message]
) -> Iterator[Violation]:
    """
    What is wrong with a dialogue.

    Parameters
    ----------
    made
        What it came to.
    brief, budgets
        What it was about, and how long it was allowed to be.
    last_seen
        The messages that the model was shown last.
    """
    if made.status not in get_args(AuthoringStatus) or bool(made.reasons) == (made.status == "complete"):
        yield UNNAMED, f"the status is {made.status!r}, with {len(made.reasons)} reasons"
    yield from _tree_faults(made, brief)
    asked = asked_of(made.transcript)
    yield from _bounds(made, budgets, asked)
    yield from _traces(made, brief, asked)
    yield from _replay_faults(made, brief)
    yield from ((REJECTED, fault) for fault in history_faults(last_seen))


def _tree_faults(made: Authored, brief: MissionBrief) -> Iterator[Violation]:
    if made.status != "complete":
        return
    if made.tree is None or gate(made.tree, brief):
        yield INVALID, f"complete, and the gate says {gate(made.tree, brief)}"
        return
    try:
        ground(made.tree, brief)
    except Exception as error:
        yield INVALID, f"complete, and cannot be grounded: {error!r}"


def _bounds(made: Authored, budgets: Budgets, asked: Sequence[Asked]) -> Iterator[Violation]:
    turns = sum('"speaker":"assistant"' in line for line in made.transcript)
    if turns > budgets.turns:
        yield UNBOUNDED, f"{turns} turns of {budgets.turns}"
    if len(asked) > budgets.calls:
        yield UNBOUNDED, f"{len(asked)} calls of {budgets.calls}"
    refused = most = 0
    for call in asked:
        refused = 0 if call.ok else refused + 1
        most = max(most, refused)
    if most > budgets.refusals:
        yield UNBOUNDED, f"{most} refusals one after the other, of {budgets.refusals}"


def _traces(made: Authored, brief: MissionBrief, asked: Sequence[Asked]) -> Iterator[Violation]:
    """Make the accepted calls alone, then all of them: both must give the tree of the dialogue, and refused ones must change nothing."""
    builder = TreeBuilder(brief)
    box = ToolBox(builder)
    for call in asked:
        if call.name.startswith("declare") and not call.ok:
            continue  # sent back by the dialogue, which knows more than the functions
        before = builder.state
        answer = box.call(call.name, call.arguments)
        if answer.ok != call.ok:
            yield REPLAYS, f"{call.name} is answered {answer.ok}, and was {call.ok}"
        if not answer.ok and builder.state is not before:
            yield TRACES, f"{call.name} {call.arguments[:300]!r}"
    if builder.tree != made.tree:
        yield REPLAYS, "the same calls give another tree"
    builder.state = State()
    for call in asked:
        if call.ok:
            box.call(call.name, call.arguments)
    if builder.tree != made.tree:
        yield TRACES, "the accepted calls alone give another tree"


def _replay_faults(made: Authored, brief: MissionBrief) -> Iterator[Violation]:
    try:
        again = replay(made.transcript, brief)
    except Exception as error:
        yield REPLAYS, f"the transcript cannot be played: {error!r}"
        return
    if (again.status, again.reasons) != (made.status, made.reasons):
        yield REPLAYS, f"{made.status} {made.reasons} replays to {again.status} {again.reasons}"
    if made.tree != again.tree or _bytes(made) != _bytes(again):
        yield REPLAYS, "it replays to another tree"


def _bytes(made: Authored) -> str:
    return "" if made.tree is None else write_text(made.tree, "tree")


def history_faults(messages: Sequence[Message]) -> Iterator[str]:
    """What an endpoint would reject of the messages as they are sent: calls without answer, foreign answers, letters that are none."""
    waiting: list[str] = []
    ids: set[str] = set()
    before = ""
    for message in sendable(messages):
        if message.speaker == "tool":
            if not waiting or waiting.pop(0) != message.call_id:
                yield f"an answer to {message.call_id!r} stands where none is due"
        elif waiting:
            yield f"call {waiting[0]!r} is not answered"
            waiting = []
        if message.speaker == before and before in {"user", "assistant"} and not message.calls:
            yield f"two messages of the {before} in a row"
        before = message.speaker
        for call in message.calls:
            if call.id in ids or not NAME.fullmatch(call.name) or not isinstance(json.loads(call.arguments), dict):
                yield f"call {call.id!r} of {call.name!r} cannot be sent"
            ids.add(call.id)
            waiting.append(call.id)
        for text in (message.text, *(call.arguments for call in message.calls)):
            text.encode()  # raises on half a letter
    if waiting:
        yield f"call {waiting[0]!r} is not answered"
