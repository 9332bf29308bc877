"""Every turn of a dialogue kept; a transcript replays to the same tree without a model."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import get_args

from missiontree.authoring.answer import Answer
from missiontree.authoring.builder import TreeBuilder
from missiontree.authoring.declaration import DECLARATIONS
from missiontree.authoring.findings import gate
from missiontree.authoring.outcome import Authored, AuthoringStatus
from missiontree.authoring.tools import ToolBox
from missiontree.formats.digest import digest
from missiontree.formats.plain import to_plain
from missiontree.llm.chat import Message, ToolCall
from missiontree.llm.recording import (
    Recording,
    answer_line,
    damaged,
    header_line,
    line_of,
    message_line,
    read_recording,
)
from missiontree.mission.brief import MissionBrief
from missiontree.mission.reason import Reason
from missiontree.mission.spent import Spent

STAND_INS = frozenset({"offline", "scripted"})


@dataclass(frozen=True, slots=True)
class Origin:
    """
    Where the turns of a dialogue come from.

    Parameters
    ----------
    source
        ``offline``, ``scripted``, ``recorded``, or a provider.
    model
        The provider's model; empty for stand-ins, so that nothing is presented as a model's that is not.
    endpoint
        Address of the endpoint, without anything secret; empty for the provider's own.

    Raises
    ------
    ValueError
        If a stand-in claims a model or an endpoint.
    """

    source: str
    model: str = ""
    endpoint: str = ""

    def __post_init__(self) -> None:
        if self.source in STAND_INS and (self.model or self.endpoint):
            named = self.model or self.endpoint
            raise ValueError(
                f"turns that are {self.source} come from no model, so they cannot bear the name {named!r}."
            )


class Transcript:
    """
    A dialogue while it is being held.

    Parameters
    ----------
    brief
        The mission; its digest stands in the header.
    origin
        Where the turns come from.
    """

    def __init__(self, brief: MissionBrief, origin: Origin) -> None:
        self.lines = [header_line(origin.source, origin.model, origin.endpoint, digest(brief))]

    def say(self, message: Message) -> None:
        """Keep a message and the calls it asks for."""
        self.lines.append(message_line(message))

    def answer(self, call: ToolCall, answer: Answer) -> None:
        """Keep the answer to a call."""
        self.lines.append(answer_line(call.id, answer.ok, answer.text))

    def end(
        self,
        status: AuthoringStatus,
        reasons: Sequence[Reason],
        reading: Sequence[str] = (),
        remarks: Sequence[Reason] = (),
        spent: Spent | None = None,
    ) -> tuple[str, ...]:
        """
        Keep what it came to, and give all lines.

        Parameters
        ----------
        status, reasons, reading
            See :class:`Authored`.
        remarks
            Notices and assumptions of the author's own, which no answer holds.
        spent
            What it took; None if no model was asked.
        """
        plain = {
            "kind": "end",
            "status": status,
            "reasons": [to_plain(reason) for reason in reasons],
            "reading": list(reading),
            "remarks": [to_plain(remark) for remark in remarks],
            "spent": {} if spent is None else to_plain(spent),
        }
        self.lines.append(line_of(plain))
        return tuple(self.lines)


def replay(lines: Sequence[str], brief: MissionBrief) -> Authored:
    """
    Make the calls of a transcript again, without a model.

    With the same inputs the same tree comes out, byte for byte. With other inputs the calls are judged anew, a notice says so, and
    the finish gate has the last word in any case.

    Parameters
    ----------
    lines
        The transcript, a line each.
    brief
        The mission.

    Raises
    ------
    InputError
        If the transcript is damaged, or its calls are answered otherwise than it says although the inputs are the same.
    """
    recording = read_recording(lines)
    same_inputs = recording.mission == digest(brief)
    builder = TreeBuilder(brief)
    answers = _answers(recording, ToolBox(builder), same_inputs)
    said = [notice for answer in answers for notice in answer.notices]
    said += _reasons(recording, "remarks", len(lines))
    if not same_inputs:
        said.append(_OTHER_INPUTS)
    notices = tuple(dict.fromkeys(said))
    status, reasons = _outcome(recording, builder, len(lines))
    return Authored(
        status=status,
        tree=builder.tree,
        reasons=reasons,
        notices=tuple(notice for notice in notices if notice.severity != "assumption"),
        assumptions=tuple(notice for notice in notices if notice.severity == "assumption"),
        transcript=tuple(lines),
        reading=tuple(recording.end["reading"]),
        author="recorded",
        model=recording.model,
        spent=_spent(recording, len(lines)),
    )


def _answers(recording: Recording, box: ToolBox, same_inputs: bool) -> list[Answer]:
    """Run every call that was answered, in order."""
    asked: list[ToolCall] = []
    answers = []
    for number, entry in recording.entries:
        if isinstance(entry, Message):
            asked = list(entry.calls)
            continue
        if not asked or asked[0].id != entry.call:
            raise damaged(number, f"call {entry.call!r} is answered here, and was not asked for at this point")
        call = asked.pop(0)
        if call.name in DECLARATIONS and not entry.ok:
            continue  # sent back with evidence, or refused: it had no effect then, and has none now
        answer = box.call(call.name, call.arguments)
        if same_inputs and answer.ok != entry.ok:
            raise damaged(
                number, f"call {call.id!r} of {call.name} is {_word(answer.ok)} now and was {_word(entry.ok)}"
            )
        answers.append(answer)
    return answers


def _outcome(recording: Recording, builder: TreeBuilder, last: int) -> tuple[AuthoringStatus, tuple[Reason, ...]]:
    """What the transcript says it came to, as far as the calls bear it out."""
    status = recording.end["status"]
    if status not in get_args(AuthoringStatus):
        raise damaged(last, f"there is no status {status!r}", accepted=", ".join(get_args(AuthoringStatus)))
    said = _reasons(recording, "reasons", last)
    if not all(isinstance(line, str) for line in recording.end["reading"]):
        raise damaged(last, "reading is not a list of texts")
    if builder.state.impossible:
        return "cannot_be_done", (said if status == "cannot_be_done" and said else builder.state.impossible)
    if builder.state.unclear:
        return "incomplete", (said if status == "incomplete" and said else builder.state.unclear)
    faults = gate(builder.tree, builder.brief)
    if status == "complete":
        return ("incomplete", faults) if faults else ("complete", ())
    if status == "cannot_be_done":
        raise damaged(last, "the mission is said to be impossible, and no call declares it")
    return status, said


def _reasons(recording: Recording, key: str, last: int) -> tuple[Reason, ...]:
    """The reasons that the end line holds under a key."""
    try:
        return tuple(Reason(**plain) for plain in recording.end[key])
    except (TypeError, ValueError) as error:
        raise damaged(last, f"one of the {key} is none: {error}") from error


def _spent(recording: Recording, last: int) -> Spent | None:
    """What the dialogue took, as the end line says."""
    if not recording.end["spent"]:
        return None
    try:
        return Spent(**recording.end["spent"])
    except (TypeError, ValueError) as error:
        raise damaged(last, f"spent cannot be read: {error}") from error


def _word(ok: bool) -> str:
    return "accepted" if ok else "refused"


_OTHER_INPUTS = Reason(
    rule="other_inputs",
    message="The transcript was recorded with another mission, fleet, scene or set of routines; its calls were judged anew.",
    severity="warning",
    hint="Look the tree over before you rely on it.",
)
