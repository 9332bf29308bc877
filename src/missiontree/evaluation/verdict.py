"""The verdict on what an author made of one mission of a suite."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from missiontree.authoring.outcome import Authored, AuthoringStatus
from missiontree.evaluation.differences import differences
from missiontree.evaluation.holding import held
from missiontree.evaluation.names import words_of
from missiontree.evaluation.score import score
from missiontree.evaluation.suite_file import Decline, SuiteMission
from missiontree.mission.brief import MissionBrief
from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason
from missiontree.mission.tree import MissionTree
from missiontree.mission.value import Id, NonNegative, Value

VerdictKind = Literal["right", "declined_though_possible", "wrong_decline", "wrong", "no_answer"]
VERDICTS: tuple[VerdictKind, ...] = get_args(VerdictKind)
_RIGHT_STATUS: dict[str, AuthoringStatus] = {"impossible": "cannot_be_done", "unclear": "incomplete"}
_NO_ANSWERS: tuple[AuthoringStatus, ...] = ("exhausted", "provider_failed")
_ENDINGS = ("ing", "ed", "es", "s", "e")


@dataclass(frozen=True, kw_only=True)
class Verdict(Value):
    """
    What an author made of a mission, held against what was right.

    Parameters
    ----------
    mission
        Id of the mission.
    kind
        ``right``. ``declined_though_possible``: a plan was expected, and there is none. ``wrong_decline``: it was to be declined and
        was, for another reason than the right one. ``wrong``: there is a plan, and another or none was expected; whatever the plan
        remarks, it would be carried out. ``no_answer``: a budget ran out, or the model could not be used.
    status
        What authoring came to, or planning the whole if that went on.
    score
        How near it came to what is right, from 0 to 1. A plan: see :func:`missiontree.evaluation.score.score`; against loose
        expectations the share of them that hold. Where there is no plan, or none was to be made: 1 if that is right, else 0.
    differences
        Why it is not right, in words; empty if it is.
    reason_named
        Whether what should be named as the reason stands in the reasons or their hints; true for a right plan.
    """

    mission: Id
    kind: VerdictKind
    status: AuthoringStatus
    score: NonNegative
    differences: tuple[str, ...] = ()
    reason_named: bool = True

    def _check(self) -> None:
        if (self.kind == "right") != (not self.differences):
            raise ValueError(f"the verdict on {self.mission!r} needs differences exactly if it is not right.")
        if self.score > 1:
            raise ValueError(f"score must be at most 1, got {self.score}.")


@dataclass(frozen=True, slots=True)
class _CameTo:
    """What an author, and planning after it if that was done, came to."""

    status: AuthoringStatus
    reasons: tuple[Reason, ...]
    tree: MissionTree | None


def judge(mission: SuiteMission, authored: Authored, brief: MissionBrief, plan: Plan | None = None) -> Verdict:
    """
    The verdict on a mission.

    Parameters
    ----------
    mission
        The mission, which says what is right.
    authored
        What the author made of it.
    brief
        What the author was given.
    plan
        What planning its tree to the end came to. Default: the tree alone is judged.
    """
    came_to = _CameTo(authored.status, authored.reasons, authored.tree)
    if plan is not None and authored.status == "complete" and plan.outcome != "delivered":
        status: AuthoringStatus = "cannot_be_done" if plan.outcome == "partial" else plan.outcome
        came_to = _CameTo(status, plan.reasons, authored.tree)
    if came_to.status in _NO_ANSWERS:
        why = (f"there is no answer; it came to {came_to.status}",)
        named = mission.declined is None
        return Verdict(
            mission=mission.id,
            kind="no_answer",
            status=came_to.status,
            score=0,
            differences=why,
            reason_named=named,
        )
    if mission.declined is not None:
        return _on_decline(mission, mission.declined, came_to)
    return _on_plan(mission, came_to, brief, whole=plan is not None and authored.status == "complete")


def _on_plan(mission: SuiteMission, came_to: _CameTo, brief: MissionBrief, whole: bool) -> Verdict:
    status: AuthoringStatus = "cannot_be_done" if whole and mission.outcome == "cannot_be_done" else "complete"
    kind: VerdictKind = "wrong"
    if came_to.tree is None or came_to.status not in {"complete", status}:
        stage = "planning" if whole else "authoring"
        why: tuple[str, ...] = (f"a plan was expected; {stage} came to {came_to.status}",)
        kind, near = "declined_though_possible", 0.0
    else:
        why, near = _on_tree(mission, came_to.tree, brief)
        if came_to.status != status:
            why = (*why, "the mission cannot be done as planned; the plan was delivered")
    return Verdict(
        mission=mission.id, kind=kind if why else "right", status=came_to.status, score=near, differences=why
    )


def _on_tree(mission: SuiteMission, tree: MissionTree, brief: MissionBrief) -> tuple[tuple[str, ...], float]:
    """In what a tree differs, and how near it comes."""
    if tree.open_leaves:
        return tuple(f"unfinished: {node.label}" for node in tree.open_leaves), 0.0
    if mission.loose is not None:
        found = held(mission.loose, tree, brief)
        return found.broken, found.share
    differing = min((differences(expected, tree, brief) for expected in mission.expected), key=len)
    return differing, max(score(expected, tree, brief) for expected in mission.expected) if differing else 1.0


def _on_decline(mission: SuiteMission, declined: Decline, came_to: _CameTo) -> Verdict:
    right, named = _RIGHT_STATUS[declined], _is_named(mission.because, came_to.reasons)
    why: tuple[str, ...] = ()
    kind: VerdictKind = "wrong_decline"
    if came_to.status == "complete":
        kind, why = (
            "wrong",
            (f"it should be declined as {declined}, because of {mission.because!r}; there is a plan",),
        )
    elif came_to.status != right:
        why = (f"it should be declined as {declined} ({right}); authoring came to {came_to.status}",)
    elif declined == "impossible" and not _is_missing(mission.because, came_to.reasons):
        why = (f"no reason says that {mission.because!r} is missing",)
    return Verdict(
        mission=mission.id,
        kind=kind if why else "right",
        status=came_to.status,
        score=0 if why else 1,
        differences=why,
        reason_named=named,
    )


def _is_missing(because: str, reasons: tuple[Reason, ...]) -> bool:
    """
    Whether a reason says that this is missing: in what it needs, or in its first clause.

    Behind the semicolon stands what there is instead.
    """
    return any(_says(f"{reason.needed} {reason.message.partition(';')[0]}", because) for reason in reasons)


def _is_named(because: str, reasons: tuple[Reason, ...]) -> bool:
    return any(_says(f"{reason.needed} {reason.found} {reason.message} {reason.hint}", because) for reason in reasons)


def _says(text: str, wanted: str) -> bool:
    """Whether all words between two ``|`` of the one stand in the other, endings aside."""
    said = {_stem(word) for word in words_of(text)}
    return any({_stem(word) for word in words_of(either)} <= said for either in wanted.split("|"))


def _stem(word: str) -> str:
    ending = next((ending for ending in _ENDINGS if word.endswith(ending) and len(word) - len(ending) >= 3), "")
    return word.removesuffix(ending)
