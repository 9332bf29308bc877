"""
The bounded dialogue between a chat model and the tree-building functions.

A model thinks, then calls; calls of a turn run in the listed order and each is answered. A tree that passes the finish gate is put
before the model once more: is each part of the mission covered, is the order right? That stands with the answer to the call that
completed the tree, since that saves a turn and keeps to the order of speakers that every endpoint takes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from missiontree.authoring.answer import Answer, RefusalError
from missiontree.authoring.budgets import Budgets, Meter
from missiontree.authoring.builder import Draw, TreeBuilder
from missiontree.authoring.declaration import DECLARATIONS, Declaration, Opinion, missing_of
from missiontree.authoring.findings import gate
from missiontree.authoring.outcome import AuthoringStatus
from missiontree.authoring.prompt import CUT, opening, reminder, review, review_of
from missiontree.authoring.schema import offered_tools
from missiontree.authoring.tools import ToolBox
from missiontree.authoring.transcript import Transcript
from missiontree.authoring.wire import parse_arguments
from missiontree.llm.chat import ChatModel, Message, ProviderError, ToolCall
from missiontree.mission.brief import MissionBrief
from missiontree.mission.control import Control, Progress
from missiontree.mission.reason import Reason
from missiontree.mission.tree import MissionTree

End = tuple[AuthoringStatus, tuple[Reason, ...]]
"""What a dialogue came to, and why."""


@dataclass(frozen=True, slots=True)
class Company:
    """
    Who is there beside the model.

    Parameters
    ----------
    opinion
        What an author without a model makes of the mission, for declarations and trees that it contradicts; None if nobody is asked.
    draw
        Makes pictures for ``plotTree``.
    control
        Stop token, listener and clock.
    """

    opinion: Opinion | None = None
    draw: Draw | None = None
    control: Control = field(default_factory=Control)


class Dialogue:
    """One dialogue: what was said, and what is left of the budgets."""

    def __init__(
        self, brief: MissionBrief, model: ChatModel, budgets: Budgets, transcript: Transcript, company: Company
    ) -> None:
        self.box = ToolBox(TreeBuilder(brief), company.draw)
        self.transcript = transcript
        self.meter = Meter(budgets, company.control.clock)
        self.notices: list[Reason] = []  # what answers to calls noted
        self.remarks: list[Reason] = []  # what is noted beside them
        self._brief, self._model, self._control = brief, model, company.control
        self._declaration = Declaration(self.box.builder, company.opinion)
        self._messages: list[Message] = []
        self._sent_back = self._reminded = self._reviewed = self._nodes_reviewed = 0

    def hold(self) -> End:
        """Talk until there is an outcome. An interruption (Ctrl-C) is one, too: each call applies whole, so the tree so far stands."""
        try:
            for message in opening(self.box.builder):
                self._say(message)
            while True:
                if (end := self._unable_to_go_on() or self._turn()) is not None:
                    return end
        except KeyboardInterrupt:
            return "exhausted", (_INTERRUPTED,)

    def _unable_to_go_on(self) -> End | None:
        if self._control.stop():
            return "exhausted", (_INTERRUPTED,)
        spent = self.meter.over()
        return ("exhausted", spent) if spent else None

    def _turn(self) -> End | None:
        """One message of the model, and what follows from it; None if the dialogue goes on."""
        tools = offered_tools(self.box.builder)
        try:
            said = self._model(tuple(self._messages), tools)
        except ProviderError as error:
            return _failed(error.kind, str(error), error.hint)
        said = replace(said, calls=_named(said.calls, self.meter.turns + 1))
        self.meter.turn(self._messages, tools, said)
        self.transcript.say(said)
        if said.finish == "length":
            return self._cut(said)
        if said.finish != "stop":
            return _failed(
                said.finish, _UNWILLING[said.finish], f"It said: {said.text[:500]}" if said.text.strip() else ""
            )
        self._messages.append(said)
        end = self._run(said.calls) if said.calls else self._stopped()
        self._tell()
        return end

    def _cut(self, said: Message) -> End | None:
        """An answer that was cut: none of its calls is made, since the last one may lack its end and all the following."""
        self._messages.append(replace(said, calls=(), native=""))
        self._say(CUT)
        self.meter.cut()
        return None

    def _run(self, calls: Sequence[ToolCall]) -> End | None:
        """The calls of one turn, in the listed order."""
        answer = None
        for number, call in enumerate(calls, start=1):
            if over := self.meter.stuck():
                return "exhausted", (*over, *(answer.reasons if answer else ()))
            answer = self._answer(call)
            if number == len(calls) and self._is_due_for_review(answer):
                answer = self._with_review(answer)
            self.transcript.answer(call, answer)
            self._messages.append(Message("tool", answer.text, call_id=call.id))
            self.notices += answer.notices
            self.meter.call(answer.ok, any(reason.rule == "repeated_call" for reason in answer.reasons))
            if impossible := self.box.builder.state.impossible:
                return "cannot_be_done", impossible
            if unclear := self.box.builder.state.unclear:
                return "incomplete", unclear
            if self._sent_back > 1:
                return "incomplete", answer.reasons
        over = self.meter.stuck()
        return ("exhausted", (*over, *(answer.reasons if answer else ()))) if over else None

    def _answer(self, call: ToolCall) -> Answer:
        if call.name in DECLARATIONS and (evidence := self._contradiction(call)):
            self._sent_back += 1
            return Answer(ok=False, reasons=evidence)
        return self.box.call(call.name, call.arguments)

    def _contradiction(self, call: ToolCall) -> tuple[Reason, ...]:
        """What speaks against a declaration. Another reader's tree is a doubt, which is raised once; what the fleet has, decides."""
        try:
            missing = missing_of(parse_arguments(call.arguments))
        except RefusalError:
            return ()
        return self._declaration.refuted(missing) or (() if self._sent_back else self._declaration.doubted())

    def _stopped(self) -> End | None:
        """The model has no more to call: the gate has the word, then the model itself."""
        tree = self.box.builder.tree
        if faults := gate(tree, self._brief):
            if self._reminded == self.meter.budgets.reminders:
                return "incomplete", faults
            self._reminded += 1
            self._say(reminder(faults))
            return None
        assert tree is not None, "the gate lets no missing tree pass"
        if self._reviewed == self.meter.budgets.reviews or len(tree.nodes) <= self._nodes_reviewed:
            self.remarks += self._declaration.warnings()
            return "complete", ()
        self._count_review(tree)
        self._say(review(tree, self._declaration.against()))
        return None

    def _is_due_for_review(self, answer: Answer) -> bool:
        """Whether this answer is to the call that completed the tree for the first time."""
        first = self._reviewed == 0 < self.meter.budgets.reviews
        tree = self.box.builder.tree
        return first and answer.ok and tree is not None and not gate(tree, self._brief)

    def _with_review(self, answer: Answer) -> Answer:
        tree = self.box.builder.tree
        assert tree is not None, "only a tree is due for review"
        self._count_review(tree)
        return replace(answer, data={**answer.data, **review_of(tree, self._declaration.against())})

    def _count_review(self, tree: MissionTree) -> None:
        self._reviewed, self._nodes_reviewed = self._reviewed + 1, len(tree.nodes)

    def _tell(self) -> None:
        tree = self.box.builder.tree
        self._control.report(Progress("authoring", self.meter.calls, len(tree.nodes) if tree is not None else 0))

    def _say(self, message: Message) -> None:
        self._messages.append(message)
        self.transcript.say(message)


def _named(calls: Sequence[ToolCall], turn: int) -> tuple[ToolCall, ...]:
    """
    The calls under ids of our own.

    Some endpoints send no id, or the same in every turn; some take back only ids of nine letters and digits.
    """
    return tuple(replace(call, id=f"t{turn:04d}c{number:03d}") for number, call in enumerate(calls, start=1))


def _failed(kind: str, message: str, hint: str = "") -> End:
    return "provider_failed", (Reason(rule=f"provider_{kind}", message=message, hint=hint),)


_UNWILLING = {
    "filtered": "The provider's content filter cut the model's answer; nothing of it was done.",
    "refused": "The model declines to answer.",
}
_INTERRUPTED = Reason(
    rule="interrupted",
    message="The dialogue was interrupted; the tree is kept as far as it was built.",
    hint="A transcript (--record) of it can be looked at; planning anew starts a new dialogue.",
)
