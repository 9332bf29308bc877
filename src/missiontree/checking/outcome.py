"""Does the plan deliver what its outcome says, and a schedule for every alternative?"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import zip_longest

from missiontree.checking.case import WORKING, Case
from missiontree.checking.fault import Fault


def nothing_delivered(case: Case) -> Iterator[Fault]:
    """A plan is called delivered and holds no alternative with a schedule that works."""
    plan = case.plan
    if plan.outcome == "delivered" and not case.timetables:
        yield Fault(
            "the plan is called delivered and holds no alternative with a schedule that works.",
            found=f"{len(case.staffings)} alternatives, 0 schedules that work",
            needed="at least 1",
        )


def delivered_unsaid(case: Case) -> Iterator[Fault]:
    """A plan that is not called delivered holds a schedule that works."""
    for schedule in case.plan.schedules:
        if case.plan.outcome != "delivered" and schedule.status in WORKING:
            yield Fault(
                f"the plan's outcome is {case.plan.outcome}, and schedule {schedule.rank} is {schedule.status}.",
                found=case.plan.outcome,
                needed="delivered",
            )


def reason_missing(case: Case) -> Iterator[Fault]:
    """A plan is not delivered, or an alternative not scheduled, and no reason is given."""
    plan = case.plan
    if plan.outcome != "delivered" and not plan.reasons:
        yield Fault(
            f"the plan's outcome is {plan.outcome} and no reason is given.", found="0 reasons", needed="at least 1"
        )
    for schedule in plan.schedules:
        if schedule.status not in WORKING and not schedule.reasons:
            yield Fault(
                f"schedule {schedule.rank} is {schedule.status} and gives no reason.",
                found="0 reasons",
                needed="at least 1",
            )


def reason_uncalled(case: Case) -> Iterator[Fault]:
    """A delivered plan gives reasons why it is not delivered."""
    if case.plan.outcome == "delivered" and case.plan.reasons:
        yield Fault(
            f"the plan is delivered and says why it is not: {case.plan.reasons[0].message}",
            found=case.plan.reasons[0].rule,
            needed="no reason",
        )


def schedule_astray(case: Case) -> Iterator[Fault]:
    """The schedules are not one for each alternative, in rank order."""
    ranks = [staffing.alternative.rank for staffing in case.staffings]
    found = [schedule.rank for schedule in case.plan.schedules]
    for rank, scheduled in zip_longest(ranks, found):
        if rank != scheduled:
            yield Fault(
                f"alternatives have ranks {_list(ranks)}, schedules {_list(found)}: each alternative needs its own, in order.",
                found=_list(found),
                needed=_list(ranks),
            )
            return


def schedule_not_empty(case: Case) -> Iterator[Fault]:
    """A schedule that is infeasible or unknown schedules something."""
    for schedule in case.plan.schedules:
        if schedule.status not in WORKING and (schedule.actions or schedule.legs or schedule.assignments):
            yield Fault(
                f"schedule {schedule.rank} is {schedule.status} and still schedules {len(schedule.actions)} actions.",
                found=f"{len(schedule.actions)} actions",
                needed="none",
            )


def _list(ranks: list[int]) -> str:
    return ", ".join(map(str, ranks)) or "none"
