"""Why a plan is not delivered: the stage that failed tells it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from missiontree.explaining.causes.routines import routine_causes
from missiontree.explaining.causes.unable import unable
from missiontree.explaining.shortfall import shortfall_of
from missiontree.mission.explanation import Cause, Stage
from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason

EVERYTHING_TRIED = "no_schedule"
PROVEN = "It is proven that no choice of robots and no order keeps to this and to all other rules."


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
        first = _first(plan.ranking.reasons)
        # A clash is sought among the ways that are in time: deadlines that leave no others stand behind it.
        late = [reason for reason in plan.ranking.reasons if reason.rule == "deadline_missed" and reason not in first]
        causes = _told(first, "allocation")
        return tuple(replace(cause, reasons=(*cause.reasons, *late, *unable(plan, cause.words))) for cause in causes)
    return _unscheduled(plan)


def _unscheduled(plan: Plan) -> tuple[Cause, ...]:
    """What no schedule keeps. That nothing is left to be tried is a proof, and what the best tries broke is the cause."""
    scheduled = [reason for schedule in plan.schedules for reason in schedule.reasons] or list(plan.reasons)
    broken = [reason for reason in scheduled if reason.rule != EVERYTHING_TRIED]
    causes = tuple(_told(broken or scheduled, "schedule"))
    if len(broken) < len(scheduled) and plan.outcome == "cannot_be_done":
        return tuple(replace(cause, hint=PROVEN) for cause in causes) if broken else causes
    return causes


def _first(reasons: tuple[Reason, ...]) -> tuple[Reason, ...]:
    """Limits that clash sum up what stands behind them."""
    clash = tuple(reason for reason in reasons if reason.rule == "limits_clash")
    return clash or reasons


def _told(reasons: Iterable[Reason], stage: Stage) -> Iterator[Cause]:
    said: set[str] = set()
    for reason in reasons:
        if reason.severity != "error" or reason.message in said:
            continue
        said.add(reason.message)
        yield Cause(
            stage=stage,
            rule=reason.rule,
            words=reason.message,
            node=reason.node,
            reasons=(reason,),
            shortfall=shortfall_of(reason),
            hint=reason.hint,
        )
