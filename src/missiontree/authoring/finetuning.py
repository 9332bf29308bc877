"""
Dialogues that ended in a checked tree, as data to fine-tune a chat model on: messages and tools, in the form that trainers take.

Only what was checked is taught: the transcript is replayed against its mission, and the finish gate has the word.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from missiontree.authoring.builder import TreeBuilder
from missiontree.authoring.declaration import Declaration, Opinion
from missiontree.authoring.outcome import Authored, AuthoringStatus
from missiontree.authoring.retelling import retold
from missiontree.authoring.taught import tools_taught
from missiontree.authoring.transcript import replay
from missiontree.formats.digest import digest
from missiontree.llm.chat import Message
from missiontree.llm.recording import Answered, Recording, read_recording
from missiontree.mission.brief import MissionBrief

_BEFORE_THE_MISSION = "The mission: "


@dataclass(frozen=True, slots=True, kw_only=True)
class Choice:
    """
    What is taken.

    Parameters
    ----------
    slips
        Keep slips, in messages marked as not to be learnt; see :func:`missiontree.authoring.retelling.retold`. Default: leave them out.
    impossible
        Take dialogues, too, that ended with the declaration that the mission cannot be done, where nothing speaks against it. Default:
        only finished trees.
    """

    slips: bool = False
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
    lines: Sequence[str], brief: MissionBrief, choice: Choice | None = None, opinion: Opinion | None = None
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
        What is taken. Default: finished trees, without slips.
    opinion
        What an author without a model makes of the mission, for declarations; None if nobody is asked.

    Raises
    ------
    InputError
        With the line, if the transcript is damaged or does not replay.
    """
    choice = choice or Choice()
    recording = read_recording(lines)
    if why := why_not(recording, choice):
        return Unfit(why)
    if recording.mission != digest(brief):
        return Unfit("it was recorded with another mission, fleet, scene or set of routines")
    if why := _why_not_checked(replay(lines, brief), Declaration(TreeBuilder(brief), opinion)):
        return Unfit(why)
    messages = retold(recording, brief.routines, choice.slips)
    if not any(message.get("tool_calls") for message in messages):
        return Unfit("none of its calls is left")
    return Example(
        source=recording.source,
        model=recording.model,
        status=recording.end["status"],
        messages=messages,
        refused=sum(not answer.ok for answer in _answers(recording)),
    )


def mission_said(recording: Recording) -> str | None:
    """The mission in the words that the model was told; None if the transcript does not begin with words to a model."""
    said = [entry for _, entry in recording.entries[:2] if isinstance(entry, Message)]
    if [message.speaker for message in said] != ["system", "user"]:
        return None
    text = said[1].text
    return text.removeprefix(_BEFORE_THE_MISSION) if text.startswith(_BEFORE_THE_MISSION) else None


def why_not(recording: Recording, choice: Choice) -> str:
    """Why a dialogue is not taken whatever its mission was, in words; empty if it may be."""
    if mission_said(recording) is None:
        return "it holds calls only, and no words to a model; authors without a model leave such transcripts"
    status = recording.end["status"]
    if status == "cannot_be_done" and not choice.impossible:
        return "its mission was declared impossible; such dialogues are taken only if they are asked for"
    if status not in {"complete", "cannot_be_done"}:
        messages = [str(reason.get("message")) for reason in recording.end["reasons"] if isinstance(reason, dict)]
        return f"it ended as {str(status).replace('_', ' ')}{f': {messages[0]}' if messages else ''}"
    return ""


def _why_not_checked(made: Authored, declaration: Declaration) -> str:
    """Why what a dialogue came to, replayed, is not to be taught, in words; empty if it is."""
    if made.status == "complete":
        doubts = [notice.message for notice in made.notices if notice.rule == "perhaps_impossible"]
        return f"there is a doubt about its tree: {doubts[0]}" if doubts else ""
    if made.status != "cannot_be_done":
        return f"its tree does not pass the gate: {made.reasons[0].message}"
    against = declaration.refuted(made.reasons[0].needed) or declaration.doubted()
    return (
        f"its mission was declared impossible, and something speaks against that: {against[0].message}"
        if against
        else ""
    )


def _answers(recording: Recording) -> list[Answered]:
    return [entry for _, entry in recording.entries if isinstance(entry, Answered)]
