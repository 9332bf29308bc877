"""Why a plan is not delivered: the stage that failed tells it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from missiontree.explaining.causes.routines import routine_causes
from missiontree.explaining.shortfall import shortfall_of
from missiontree.mission.explanation import Cause, Stage
from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason


def causes_of(plan: Plan) -> tuple[Cause, ...]:
    """
    Why a plan is not delivered.

    Parameters
    ----------
    plan
        A plan of any outcome; one that is delivered has no causes.
    """
    if plan.outcome == "delivered":
        return ()
    if plan.grounding is None or plan.tree is None or plan.ranking is None:
        return tuple(_told(plan.reasons, "authoring"))
    if of_routines := routine_causes(plan.tree, plan.grounding):
        return of_routines
    if plan.ranking.status == "infeasible":
        return tuple(_told(_first(plan.ranking.reasons), "allocation"))
    scheduled = [reason for schedule in plan.schedules for reason in schedule.reasons]
    return tuple(_told(scheduled or plan.reasons, "schedule"))


def _first(reasons: tuple[Reason, ...]) -> tuple[Reason, ...]:
    """Limits that clash sum up what stands behind them."""
    clash = tuple(reason for reason in reasons if reason.rule == "limits_clash")
    return clash or reasons


def _told(reasons: Iterable[Reason], stage: Stage) -> Iterator[Cause]:
    for reason in dict.fromkeys(reason for reason in reasons if reason.severity == "error"):
        yield Cause(
            stage=stage,
            rule=reason.rule,
            words=reason.message,
            node=reason.node,
            reasons=(reason,),
            shortfall=shortfall_of(reason),
            hint=reason.hint,
        )
