"""author_tree: the bounded dialogue between a chat model and the tree-building functions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from missiontree.authoring.builder import Draw, TreeBuilder
from missiontree.authoring.findings import findings, gate
from missiontree.authoring.outcome import Authored, AuthoringStatus
from missiontree.authoring.prompt import opening, reminder
from missiontree.authoring.schema import offered_tools
from missiontree.authoring.tools import ToolBox
from missiontree.authoring.transcript import Transcript
from missiontree.llm.chat import ChatModel, Message, ProviderError, ToolCall
from missiontree.mission.brief import MissionBrief
from missiontree.mission.reason import Reason
from missiontree.mission.tree import MissionTree
from missiontree.mission.value import Count, Index, Value


@dataclass(frozen=True, slots=True)
class Budgets(Value):
    """
    How long a dialogue may go on.

    Parameters
    ----------
    turns
        Messages of the model. Default 60.
    calls
        Calls of all turns together. Default 500.
    refusals
        Calls refused one after the other. Default 12.
    reminders
        How often a model that stops early is told what is missing. Default 2.
    """

    turns: Count = 60
    calls: Count = 500
    refusals: Count = 12
    reminders: Index = 2


def author_tree(
    brief: MissionBrief,
    model: ChatModel,
    budgets: Budgets = Budgets(),
    source: str = "scripted",
    model_name: str = "",
    draw: Draw | None = None,
    reading: Sequence[str] = (),
    doubts: Sequence[Reason] = (),
) -> Authored:
    """
    Have a mission tree built.

    Parameters
    ----------
    brief
        The mission.
    model
        Who makes the calls.
    budgets
        How long it may take.
    source, model_name
        Who the model is, for the transcript's header: ``offline``, ``scripted``, ``recorded``, or a provider with its model.
    draw
        Makes pictures for ``plotTree``.
    reading
        How the text was understood, by an author that reads plain language.
    doubts
        What was not understood; with any, even a tree that passes the gate is ``incomplete``.

    Returns
    -------
    Authored
        Whatever happened; see its status.
    """
    dialogue = _Dialogue(brief, model, budgets, Transcript(brief, source, model_name), draw)
    status, reasons = dialogue.hold()
    if status == "complete" and doubts:
        status, reasons = "incomplete", tuple(doubts)
    elif status == "incomplete":
        reasons = (*doubts, *reasons)
    said = tuple(dict.fromkeys(dialogue.notices))
    return Authored(
        status=status,
        tree=dialogue.box.builder.tree,
        reasons=reasons,
        notices=tuple(notice for notice in said if notice.severity != "assumption"),
        assumptions=tuple(notice for notice in said if notice.severity == "assumption"),
        transcript=dialogue.transcript.end(status, reasons, reading),
        reading=tuple(reading),
        author=source,
        model=model_name,
    )


def authored_from_tree(tree: MissionTree, brief: MissionBrief) -> Authored:
    """A tree that was handed in, as far as it passes the gate that every tree passes."""
    found = findings(tree, brief)
    faults = tuple(finding for finding in found if finding.severity == "error")
    return Authored(
        status="incomplete" if faults else "complete",
        tree=tree,
        reasons=faults,
        notices=tuple(finding for finding in found if finding.severity != "error"),
        author="given",
    )


class _Dialogue:
    """One dialogue: what was said, and what is left of the budgets."""

    def __init__(
        self, brief: MissionBrief, model: ChatModel, budgets: Budgets, transcript: Transcript, draw: Draw | None
    ) -> None:
        self.box = ToolBox(TreeBuilder(brief), draw)
        self.transcript = transcript
        self.notices: list[Reason] = []
        self._brief, self._model, self._budgets = brief, model, budgets
        self._messages: list[Message] = []
        self._calls = self._refused = self._reminded = 0

    def hold(self) -> tuple[AuthoringStatus, tuple[Reason, ...]]:
        """Talk until there is an outcome."""
        for message in opening(self.box.builder):
            self._say(message)
        for _ in range(self._budgets.turns):
            try:
                turn = self._model(tuple(self._messages), offered_tools(self.box.builder))
            except ProviderError as error:
                return "provider_failed", (Reason(rule="provider_failed", message=str(error)),)
            self._say(turn)
            outcome = self._run(turn.calls) if turn.calls else self._stopped()
            if outcome is not None:
                return outcome
        return _exhausted("turns", self._budgets.turns)

    def _run(self, calls: Sequence[ToolCall]) -> tuple[AuthoringStatus, tuple[Reason, ...]] | None:
        """The calls of one turn, in the listed order."""
        for call in calls:
            if self._calls == self._budgets.calls:
                return _exhausted("calls", self._budgets.calls)
            self._calls += 1
            answer = self.box.call(call.name, call.arguments)
            self.transcript.answer(call, answer)
            self._messages.append(Message("tool", answer.text, call_id=call.id))
            self.notices += answer.notices
            self._refused = 0 if answer.ok else self._refused + 1
            if impossible := self.box.builder.state.impossible:
                return "cannot_be_done", impossible
            if self._refused == self._budgets.refusals:
                return _exhausted("refusals one after the other", self._budgets.refusals, answer.reasons)
        return None

    def _stopped(self) -> tuple[AuthoringStatus, tuple[Reason, ...]] | None:
        """The model has no more to call: the gate has the word."""
        faults = gate(self.box.builder.tree, self._brief)
        if not faults:
            return "complete", ()
        if self._reminded == self._budgets.reminders:
            return "incomplete", faults
        self._reminded += 1
        self._say(reminder(faults))
        return None

    def _say(self, message: Message) -> None:
        self._messages.append(message)
        self.transcript.say(message)


def _exhausted(what: str, limit: int, reasons: tuple[Reason, ...] = ()) -> tuple[AuthoringStatus, tuple[Reason, ...]]:
    spent = Reason(
        rule="budget_exhausted",
        message=f"The dialogue used up its {limit} {what}; the tree was not finished by then.",
        hint="Allow more, or use another model.",
    )
    return "exhausted", (spent, *reasons)
