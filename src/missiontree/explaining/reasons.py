"""Reasons of a plan that is not delivered, as causes: for what no tree over the fleet shows more closely."""

from __future__ import annotations

from collections.abc import Iterable

from missiontree.explaining.shortfall import shortfall_of
from missiontree.mission.explanation import Cause, Stage
from missiontree.mission.reason import Reason


def cause_of(reason: Reason, stage: Stage, node: str = "") -> Cause:
    """One reason as a cause."""
    return Cause(
        stage=stage,
        rule=reason.rule,
        words=reason.message,
        node=node,
        reasons=(reason,),
        shortfall=shortfall_of(reason),
        hint=reason.hint,
    )


def causes_of(reasons: Iterable[Reason], stage: Stage) -> tuple[Cause, ...]:
    """Errors as causes, each once."""
    told = dict.fromkeys(reason for reason in reasons if reason.severity == "error")
    return tuple(cause_of(reason, stage) for reason in told)
