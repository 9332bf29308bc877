"""
The author that needs no model: mission methods turn what is said into the tree-building calls that a language model would make.

Same functions, same checks, same transcript. It never guesses: words that may matter and are not understood make the outcome
*incomplete*, and a goal that no routine serves makes it *cannot be done*.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from missiontree.authoring.answer import Answer
from missiontree.authoring.builder import TreeBuilder
from missiontree.authoring.entities import is_said
from missiontree.authoring.findings import gate
from missiontree.authoring.language.kinds import kind_of
from missiontree.authoring.links import name_of_kind
from missiontree.authoring.methods.composition import Composition, composed, mentions_of
from missiontree.authoring.methods.method import MethodLibrary, built_in_methods
from missiontree.authoring.methods.outline import Piece
from missiontree.authoring.outcome import Authored, AuthoringStatus
from missiontree.authoring.reading.clauses import MAX_WORDS, Clause, Word, clauses_of, words_of_text
from missiontree.authoring.reading.entities import Mention
from missiontree.authoring.reading.goals import GoalReader
from missiontree.authoring.reading.outcomes import Goal, Trouble, Unserved
from missiontree.authoring.reading.robots import robots_carried, robots_marked
from missiontree.authoring.reading.taking import errands_joined
from missiontree.authoring.reading.wording import verbs_repeated
from missiontree.authoring.tools import ToolBox
from missiontree.authoring.transcript import Transcript
from missiontree.formats.digest import canonical
from missiontree.llm.chat import Message, ToolCall
from missiontree.mission.brief import MissionBrief
from missiontree.mission.reason import Reason

_NO_LACK = frozenset({"resource_excluded", "kind_refused"})  # who is not asked, and whom it is not done to
WAY_OUT = "Say what is to be done, such as 'Find the keys, then bring them to Anna', set a model, or add a method."


def author_offline(brief: MissionBrief, methods: MethodLibrary | None = None) -> Authored:
    """
    Have a mission tree built without a model.

    Parameters
    ----------
    brief
        The mission.
    methods
        The mission methods; default: those that ship with missiontree.

    Returns
    -------
    Authored
        ``complete``, ``cannot_be_done`` or ``incomplete``; ``reading`` says, clause by clause, what was understood by which method.
    """
    library = methods or built_in_methods()
    words = words_of_text(brief.text[: MAX_WORDS * 60])
    desk = _Desk(brief)
    if not words:
        empty = Reason(rule="empty_mission", message="The mission is empty: there is nothing to be done.", hint=WAY_OUT)
        return desk.ended("incomplete", (empty,))
    if len(words) > MAX_WORDS or len(brief.text) > MAX_WORDS * 60:
        message = f"The mission is too long for the offline author: it reads {MAX_WORDS} words and signs."
        return desk.ended(
            "incomplete", (Reason(rule="mission_too_long", message=message, hint="Shorten it, or set a model."),)
        )
    reader = GoalReader(brief, library)
    clauses = _clauses(words, reader)
    results = [reader.read(clause, following) for clause, following in zip(clauses, (*clauses[1:], None), strict=False)]
    desk.reading = tuple(_line(clause.text, result) for clause, result in zip(clauses, results, strict=True))
    troubles = tuple(result.reason for result in results if isinstance(result, Trouble))
    unserved = [result for result in results if isinstance(result, Unserved)]
    goals = [result for result in results if isinstance(result, Goal)]
    if troubles or not (unserved or any(goal.outline.pieces for goal in goals)):
        nothing = Reason(rule="nothing_asked", message="The mission asks for nothing.", hint=WAY_OUT)
        return desk.ended("incomplete", (*(troubles or (nothing,)), *(_missing(brief, one) for one in unserved)))
    if unserved:
        return desk.declined(unserved)
    desk.remarks += reader.unused_statements(goals)
    return desk.built(goals)


def _clauses(words: tuple[Word, ...], reader: GoalReader) -> tuple[Clause, ...]:
    """The clauses of the text, with what they leave out."""
    marked = robots_marked(words, reader.brief.fleet, reader.lexicon, frozenset(reader.phrases.known))
    clauses = verbs_repeated(clauses_of(marked, reader.lexicon), reader.lexicon)
    return robots_carried(errands_joined(clauses, reader.lexicon))


def _line(text: str, result: Goal | Unserved | Trouble) -> str:
    if isinstance(result, Goal):
        return result.reading
    if isinstance(result, Unserved):
        return f"{text!r}: understood as a goal ({result.goal}) that no method and no routine serves"
    return f"not understood: {result.reason.message}"


def _missing(brief: MissionBrief, unserved: Unserved) -> Reason:
    served = ", ".join(routine.id for routine in brief.routines.routines)
    asked = f"{unserved.goal} ('{unserved.verb}')" if unserved.verb != unserved.goal else unserved.goal
    return Reason(
        rule="capability_missing",
        message=f"The mission needs the capability {asked}, which no routine has; there are {served}.",
        needed=unserved.goal,
        hint=f"Write a routine with '{unserved.verb}' among its verbs and give the capability to a robot type, or reword the mission.",
    )


@dataclass
class _Desk:
    """Makes the calls and keeps what was said. One call is one turn."""

    brief: MissionBrief
    box: ToolBox = field(init=False)
    transcript: Transcript = field(init=False)
    reading: tuple[str, ...] = ()
    said: list[Reason] = field(default_factory=list)
    remarks: list[Reason] = field(default_factory=list)
    calls: int = 0

    def __post_init__(self) -> None:
        self.box = ToolBox(TreeBuilder(self.brief))
        self.transcript = Transcript(self.brief, "offline")

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

    def declined(self, unserved: Sequence[Unserved]) -> Authored:
        """Declare that the mission cannot be done, since a goal is served by nobody."""
        reasons = tuple(dict.fromkeys(_missing(self.brief, one) for one in unserved))
        return self._impossible(reasons, ", ".join(dict.fromkeys(one.goal for one in unserved)))

    def _impossible(self, reasons: tuple[Reason, ...], missing: str) -> Authored:
        if self.box.builder.tree is None:
            self.call("HierarchicalTree_init", {"objective": " ".join(self.brief.text.split())})
        self.call(
            "declareImpossible",
            {"missing": missing[:200], "reason": " ".join(reason.message for reason in reasons)[:2000]},
        )
        return self.ended("cannot_be_done", reasons)  # the declaration says the same in other words

    def built(self, goals: Sequence[Goal]) -> Authored:
        """Build the tree of all goals."""
        made = composed(goals, self.brief.routines)
        self.remarks += [assumption for goal in goals for assumption in goal.assumptions]
        self.remarks += made.notices
        refusal = _Building(self, made).build()
        if refusal is not None:
            return self._refused(refusal)
        faults = gate(self.box.builder.tree, self.brief)
        reasons = (*made.doubts, *faults)
        return self.ended("incomplete" if reasons else "complete", reasons)

    def _refused(self, refusal: Answer) -> Authored:
        """A call was refused: if nobody can do it, the mission cannot be done; else the tree stays unfinished."""
        if refusal.reasons[0].rule != "no_robot_able":
            return self.ended("incomplete", refusal.reasons)
        why = [reason for reason in refusal.reasons[1:] if reason.needed and reason.rule not in _NO_LACK]
        lacks = [reason for reason in why if reason.rule == "capability_missing"] or why
        needed = [reason.needed for reason in lacks]
        missing = ", ".join(dict.fromkeys(needed)) or f"a robot that can do {refusal.reasons[0].node}"
        first = replace(refusal.reasons[0], needed=missing[:200])
        return self._impossible((first, *refusal.reasons[1:]), missing)


@dataclass
class _Building:
    """Turns an outline into calls, level by level."""

    desk: _Desk
    made: Composition
    ids: dict[Piece, str] = field(default_factory=dict)
    linked: set[int] = field(default_factory=set)
    names: dict[str, str] = field(default_factory=dict)

    def build(self) -> Answer | None:
        """Make all calls; answers with the refusal that could not be got over."""
        outline = self.made.outline
        begun = self.desk.call("HierarchicalTree_init", {"objective": " ".join(self.desk.brief.text.split())})
        if not begun.ok:
            return begun
        for mention in mentions_of(outline):
            if (refusal := self._introduce(mention)) is not None:
                return refusal
        waiting = [(str(begun.data["root"]), outline.pieces, "AND")]
        while waiting:
            parent, pieces, logic = waiting.pop(0)
            for run in _runs(pieces):
                if (refusal := self._added(parent, run, logic)) is not None:
                    return refusal
            waiting += [
                (self.ids[piece], piece.pieces, piece.gate.upper())
                for piece in pieces
                if piece.pieces and piece in self.ids
            ]
        return self._link()

    def _introduce(self, mention: Mention) -> Answer | None:
        self.names[mention.name] = mention.name
        if not mention.new:
            return None
        said = self.desk.brief.scene is None and is_said(mention.name, self.desk.brief.text)
        if (
            said
            and (kind_of(mention.name) or "object") == mention.kind
            and self.desk.box.builder.cast.find(mention.name) is None
        ):
            return None  # the words of the mission are enough: the call that names it introduces it
        answer = self.desk.call("introduceEntity", {"name": mention.name, "kind": mention.kind})
        if answer.ok:
            self.names[mention.name] = str(answer.data["entity"])
            return None
        return answer

    def _added(self, parent: str, pieces: list[Piece], logic: str) -> Answer | None:
        while True:
            pairs = self._pairs(pieces)
            answer = self.desk.call(*self._call(parent, pieces, logic, pairs))
            if answer.ok:
                self.ids.update(zip(pieces, (str(added["id"]) for added in answer.data["added"]), strict=True))
                return None
            nobody = answer.reasons[0].rule == "no_robot_able" and logic == "XOR" and len(pieces) > 1
            unable = next((p for p in pieces if nobody and p.label == answer.reasons[0].node), None)
            if unable is None:
                return answer
            pieces.remove(unable)
            self.desk.remarks.append(replace(answer.reasons[0], severity="notice"))

    def _call(self, parent: str, pieces: list[Piece], logic: str, pairs: list[list[Any]]) -> tuple[str, dict[str, Any]]:
        where = {"parentString": parent, "LogicalConstraint": logic, "constraintPairs": pairs}
        if pieces[0].routine is None:
            return "addMultiSubtasks", where | {
                "isPrimitiveList": [False] * len(pieces),
                "taskNameList": [p.label for p in pieces],
            }
        trees = [piece.routine.wire_name for piece in pieces if piece.routine is not None]
        arguments = [[*self._named(piece), *([list(piece.resources)] if piece.resources else [])] for piece in pieces]
        return "attachMultiSubTrees", where | {"treeNames": trees, "treeArguments": arguments}

    def _named(self, piece: Piece) -> list[str]:
        return [self.names[mention.name] for mention in piece.mentions]

    def _pairs(self, pieces: list[Piece]) -> list[list[Any]]:
        """The links within one call, by place in its list."""
        pairs: list[list[Any]] = []
        for number, (first, second, kind) in enumerate(self.made.outline.links):
            if first in pieces and second in pieces:
                pairs.append(
                    [pieces.index(first), pieces.index(second), *([] if kind == "precedence" else [name_of_kind(kind)])]
                )
                self.linked.add(number)
        return pairs

    def _link(self) -> Answer | None:
        """The links that join what different calls made; what nobody said is left out if it contradicts what was."""
        for number, (first, second, kind) in enumerate(self.made.outline.links):
            if number not in self.linked and first in self.ids and second in self.ids:
                ends = {"first": self.ids[first], "second": self.ids[second], "kind": name_of_kind(kind)}
                if not (answer := self.desk.call("setLink", ends)).ok:
                    return answer
        for first, second in self.made.implied:
            if first in self.ids and second in self.ids:
                self.desk.call("setLink", {"first": self.ids[first], "second": self.ids[second], "kind": "Precedence"})
        return None


def _runs(pieces: Sequence[Piece]) -> list[list[Piece]]:
    """Neighbours that one call can make: tasks or routines."""
    runs: list[list[Piece]] = []
    for piece in pieces:
        if runs and (runs[-1][0].routine is None) == (piece.routine is None):
            runs[-1].append(piece)
        else:
            runs.append([piece])
    return runs
