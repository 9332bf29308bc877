"""Where an author without a model makes its calls: the same functions and the same transcript that a model has."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from missiontree.authoring.answer import Answer
from missiontree.authoring.builder import TreeBuilder
from missiontree.authoring.outcome import Authored, AuthoringStatus
from missiontree.authoring.tools import ToolBox
from missiontree.authoring.transcript import Origin, Transcript
from missiontree.formats.digest import canonical
from missiontree.llm.chat import Message, ToolCall
from missiontree.mission.brief import MissionBrief
from missiontree.mission.reason import Reason


@dataclass
class Desk:
    """
    Makes the calls and keeps what was said. One call is one turn.

    Parameters
    ----------
    brief
        The mission.
    reading
        How the mission was understood, a line for each clause or goal.
    said
        What the answers to calls noted.
    remarks
        What the author notes of its own accord.
    """

    brief: MissionBrief
    box: ToolBox = field(init=False)
    transcript: Transcript = field(init=False)
    reading: tuple[str, ...] = ()
    said: list[Reason] = field(default_factory=list)
    remarks: list[Reason] = field(default_factory=list)
    calls: int = 0

    def __post_init__(self) -> None:
        self.box = ToolBox(TreeBuilder(self.brief))
        self.transcript = Transcript(self.brief, Origin("offline"))

    def call(self, name: str, arguments: Mapping[str, Any]) -> Answer:
        """Make one call."""
        self.calls += 1
        call = ToolCall(f"call-{self.calls}", name, canonical(dict(arguments)))
        self.transcript.say(Message("assistant", calls=(call,)))
        answer = self.box.call(call.name, call.arguments)
        self.transcript.answer(call, answer)
        self.said += answer.notices
        return answer

    def ended(self, status: AuthoringStatus, reasons: Sequence[Reason] = ()) -> Authored:
        """What it came to."""
        said = tuple(dict.fromkeys((*self.said, *self.remarks)))
        return Authored(
            status=status,
            tree=self.box.builder.tree,
            reasons=tuple(reasons),
            notices=tuple(reason for reason in said if reason.severity != "assumption"),
            assumptions=tuple(reason for reason in said if reason.severity == "assumption"),
            transcript=self.transcript.end(status, tuple(reasons), self.reading, self.remarks),
            reading=self.reading,
            author="offline",
        )

    def declared_impossible(self, reasons: tuple[Reason, ...], missing: str) -> Authored:
        """Declare that the mission cannot be done, with what is missing."""
        if self.box.builder.tree is None:
            self.call("HierarchicalTree_init", {"objective": " ".join(self.brief.text.split())})
        self.call(
            "declareImpossible",
            {"missing": missing[:200], "reason": " ".join(reason.message for reason in reasons)[:2000]},
        )
        return self.ended("cannot_be_done", reasons)  # the declaration says the same in other words
