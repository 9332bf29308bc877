"""Reasons as the page shows them: what needs a thought one by one, and what is only lacking, gathered."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason
from missiontree.reporting.text import MARKS, said_once

MOST_REMARKS = 120


@dataclass(frozen=True, slots=True)
class Remark:
    """
    A reason.

    Parameters
    ----------
    mark, severity
        Sign and word for how much it weighs.
    message, hint
        The reason, and what to do about it; the hint may be empty.
    rule
        Code of the rule.
    """

    mark: str
    severity: str
    message: str
    hint: str
    rule: str


@dataclass(frozen=True, slots=True)
class Remarks:
    """Remarks, and how many more there are."""

    listed: tuple[Remark, ...]
    more: int = 0

    def __len__(self) -> int:
        return len(self.listed) + self.more


def remarks(reasons: Sequence[Reason]) -> Remarks:
    """Reasons in their order; what the first sums up is not said twice."""
    said = said_once(reasons)
    return Remarks(tuple(map(_remark, said[:MOST_REMARKS])), max(0, len(said) - MOST_REMARKS))


def _remark(reason: Reason) -> Remark:
    return Remark(
        MARKS[reason.severity][0], reason.severity, " ".join(reason.message.split()), sentence(reason.hint), reason.rule
    )


def sentence(text: str) -> str:
    """A hint as a sentence: a capital at its beginning, unless a name stands there, and a full stop at its end."""
    words = text.split(maxsplit=1)
    if not words:
        return ""
    start = text[:1].upper() if words[0].isalpha() else text[:1]
    return start + text[1:] + ("" if text.endswith((".", "?", "!", ":", ")", "…")) else ".")


@dataclass(frozen=True, slots=True)
class Refused:
    """
    What was not offered for a task.

    Parameters
    ----------
    task
        The task in the words of the tree.
    remarks
        Refusals that need a thought.
    lacking
        Capability, and the types that lack it.
    """

    task: str
    remarks: Remarks
    lacking: tuple[tuple[str, str], ...]


def not_offered(plan: Plan) -> tuple[Refused, ...]:
    """Refusals of grounding that are not already among the plan's reasons, task by task in the order of the tree."""
    told = frozenset(plan.reasons)
    by_node: dict[str, list[Reason]] = {}
    for reason in plan.grounding.not_offered if plan.grounding else ():
        if reason not in told:
            by_node.setdefault(reason.node, []).append(reason)
    return tuple(_refused(node, reasons, plan) for node, reasons in by_node.items())


def _refused(node: str, reasons: Sequence[Reason], plan: Plan) -> Refused:
    plain = [reason for reason in reasons if reason.rule == "capability_missing" and reason.robot]
    others = [reason for reason in reasons if reason not in plain]
    known = plan.tree.by_id.get(node) if plan.tree is not None else None
    return Refused(known.label if known is not None else node, remarks(others), tuple(_lacking(plain, plan)))


def _lacking(reasons: Sequence[Reason], plan: Plan) -> Iterator[tuple[str, str]]:
    types = plan.brief.fleet.by_id
    lacking: dict[str, list[str]] = {}
    for reason in reasons:
        lacking.setdefault(reason.needed, []).append(
            types[reason.robot].label if reason.robot in types else reason.robot
        )
    for capability, names in lacking.items():
        yield capability, ", ".join(dict.fromkeys(names))
