"""An outline to the tree-building calls that make it, and what comes of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from missiontree.authoring.answer import Answer
from missiontree.authoring.composing.composition import Composition, mentions_of
from missiontree.authoring.desk import Desk
from missiontree.authoring.entities import is_said
from missiontree.authoring.findings import gate
from missiontree.authoring.language.kinds import kind_of
from missiontree.authoring.links import name_of_kind
from missiontree.authoring.methods.mention import Mention
from missiontree.authoring.methods.outline import Piece
from missiontree.authoring.outcome import Authored
from missiontree.mission.fleet import Fleet
from missiontree.mission.reason import Reason

_NO_LACK = frozenset({"resource_excluded", "kind_refused"})  # who is not asked, and whom it is not done to


def built(desk: Desk, made: Composition, assumptions: Sequence[Reason] = ()) -> Authored:
    """
    Build the tree.

    Parameters
    ----------
    desk
        Where the calls are made.
    made
        What is built.
    assumptions
        What was taken for granted in understanding the mission.
    """
    desk.remarks += assumptions
    desk.remarks += made.notices
    refusal = Building(desk, made).build()
    if refusal is not None:
        return _refused(desk, refusal)
    faults = gate(desk.box.builder.tree, desk.brief)
    reasons = (*made.doubts, *faults)
    return desk.ended("incomplete" if reasons else "complete", reasons)


def _refused(desk: Desk, refusal: Answer) -> Authored:
    """A call was refused: if nobody can do it, the mission cannot be done; else the tree stays unfinished."""
    if refusal.reasons[0].rule != "no_robot_able":
        return desk.ended("incomplete", refusal.reasons)
    why = [reason for reason in refusal.reasons[1:] if reason.needed and reason.rule not in _NO_LACK]
    lacks = _decisive(desk.brief.fleet, why)
    needed = [reason.needed for reason in lacks]
    somebody = f"a robot that can do {refusal.reasons[0].node}"
    missing = ", ".join(dict.fromkeys(needed)) or somebody
    first = replace(refusal.reasons[0], needed=missing[:200])
    here = any(kind.capability(need) is not None for need in needed for kind in desk.brief.fleet.types)
    return desk.declared_impossible((first, *refusal.reasons[1:]), somebody if here else missing)


def _decisive(fleet: Fleet, why: Sequence[Reason]) -> list[Reason]:
    """
    The reasons that name what the fleet lacks.

    A capability that nobody has; else what those lack who have all capabilities (a payload, say), since the others are not even asked
    for it; else everything.
    """
    skills = [reason for reason in why if reason.rule == "capability_missing"]
    nobody = [one for one in skills if all(kind.capability(one.needed) is None for kind in fleet.types)]
    unskilled = {reason.robot for reason in skills}
    return nobody or [reason for reason in why if reason.robot not in unskilled] or list(why)


@dataclass
class Building:
    """
    Turns an outline into calls, level by level.

    Parameters
    ----------
    desk
        Where the calls are made.
    made
        What is built.
    """

    desk: Desk
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
        return self._time() or self._link()

    def _time(self) -> Answer | None:
        for piece in self.made.outline.all_pieces:
            if piece in self.ids and (piece.release_s or piece.deadline_s is not None):
                times = {"release_s": piece.release_s or None, "deadline_s": piece.deadline_s}
                given = {name: time for name, time in times.items() if time is not None}
                if not (answer := self.desk.call("setTimes", {"subtask": self.ids[piece], **given})).ok:
                    return answer
        return None

    def _introduce(self, mention: Mention) -> Answer | None:
        self.names[mention.name] = mention.name
        if not mention.new:
            return None
        said = self.desk.brief.scene is None and is_said(mention.name, self.desk.brief.words)
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
