"""The verdict on what an author made of one mission of a suite."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from missiontree.authoring.outcome import Authored, AuthoringStatus
from missiontree.evaluation.differences import differences
from missiontree.evaluation.names import words_of
from missiontree.evaluation.suite_file import SuiteMission
from missiontree.mission.brief import MissionBrief
from missiontree.mission.reason import Reason
from missiontree.mission.value import Id, Value

VerdictKind = Literal["right", "declined_though_possible", "wrong_decline", "wrong"]
VERDICTS: tuple[VerdictKind, ...] = get_args(VerdictKind)
_RIGHT_STATUS: dict[str, AuthoringStatus] = {"impossible": "cannot_be_done", "unclear": "incomplete"}
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
        remarks, it would be carried out.
    status
        What authoring came to.
    differences
        Why it is not right, in words; empty if it is.
    reason_named
        Whether what should be named as the reason stands in the reasons or their hints; true for a right plan.
    """

    mission: Id
    kind: VerdictKind
    status: AuthoringStatus
    differences: tuple[str, ...] = ()
    reason_named: bool = True

    def _check(self) -> None:
        if (self.kind == "right") != (not self.differences):
            raise ValueError(f"the verdict on {self.mission!r} needs differences exactly if it is not right.")


def judge(mission: SuiteMission, authored: Authored, brief: MissionBrief) -> Verdict:
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
    """
    if mission.declined is None:
        return _on_plan(mission, authored, brief)
    return _on_decline(mission, authored)


def _on_plan(mission: SuiteMission, authored: Authored, brief: MissionBrief) -> Verdict:
    if authored.status != "complete" or authored.tree is None:
        why = (f"a plan was expected; authoring came to {authored.status}",)
        return Verdict(mission=mission.id, kind="declined_though_possible", status=authored.status, differences=why)
    tree = authored.tree
    found = min((differences(expected, tree, brief) for expected in mission.expected), key=len)
    return Verdict(mission=mission.id, kind="wrong" if found else "right", status="complete", differences=found)


def _on_decline(mission: SuiteMission, authored: Authored) -> Verdict:
    assert mission.declined is not None, "a mission without a plan is to be declined"
    right, named = _RIGHT_STATUS[mission.declined], _is_named(mission.because, authored.reasons)
    why: tuple[str, ...] = ()
    kind: VerdictKind = "wrong_decline"
    if authored.status == "complete":
        kind, why = (
            "wrong",
            (f"it should be declined as {mission.declined}, because of {mission.because!r}; there is a plan",),
        )
    elif authored.status != right:
        why = (f"it should be declined as {mission.declined} ({right}); authoring came to {authored.status}",)
    elif mission.declined == "impossible" and not _is_missing(mission.because, authored.reasons):
        why = (f"no reason says that {mission.because!r} is missing",)
    return Verdict(
        mission=mission.id,
        kind=kind if why else "right",
        status=authored.status,
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
    """Whether all words of the one stand in the other, endings aside."""
    return {_stem(word) for word in words_of(wanted)} <= {_stem(word) for word in words_of(text)}


def _stem(word: str) -> str:
    ending = next((ending for ending in _ENDINGS if word.endswith(ending) and len(word) - len(ending) >= 3), "")
    return word.removesuffix(ending)
