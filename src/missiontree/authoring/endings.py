"""The two ways in which an author can end without a tree: the mission cannot be done, or it is not clear what it asks for."""

from __future__ import annotations

from missiontree.authoring.answer import refuse
from missiontree.authoring.entities import is_said
from missiontree.authoring.matching import listed, quoted
from missiontree.mission.brief import MissionBrief
from missiontree.mission.reason import Reason


def impossible(missing: str, reason: str, brief: MissionBrief) -> tuple[Reason, tuple[Reason, ...]]:
    """
    What is declared, and a notice if a robot type has what is called missing.

    Parameters
    ----------
    missing
        The capability or limit that is missing.
    reason
        Why the mission needs it.
    brief
        The mission, with its fleet.
    """
    declared = Reason(
        rule="declared_impossible",
        message=f"The mission cannot be done: {missing} is missing. {reason}",
        needed=missing,
        hint="Add a routine and a robot that can do it, or reword the mission.",
    )
    has = [kind.label for kind in brief.fleet.types if kind.capability(missing) is not None]
    doubt = Reason(
        rule="capability_present",
        message=f"{missing} was called missing, but {listed(has)} of this fleet has it.",
        severity="notice",
    )
    return declared, (doubt,) if has else ()


def unclear(words: str, question: str, brief: MissionBrief) -> Reason:
    """
    What is declared.

    Parameters
    ----------
    words
        Words of the mission.
    question
        What the operator should say.
    brief
        The mission.

    Raises
    ------
    RefusalError
        ``not_said``, if the words do not stand in the mission; nobody can be asked about what he has not said.
    """
    if not is_said(words, brief.text):
        hint = "Quote the mission word by word, a few words that stand side by side."
        raise refuse("not_said", f"The mission does not say {quoted(words)}.", hint=hint)
    return Reason(
        rule="declared_unclear",
        message=f"The mission cannot be planned as it stands, because of {quoted(words)}: {question}",
        found=words,
        hint="Reword the mission.",
    )
