"""Does the plan deliver what its outcome says, and a schedule for every alternative?"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import zip_longest

from missiontree.checking.case import WORKING, Case
from missiontree.checking.fault import Fault
from missiontree.checking.provenance import GIVEN
from missiontree.llm.recording import Recording
from missiontree.mission.reason import Reason

NOTHING_FOUND = "nothing_found"
"""Rule of the reason that time was up before anything was found or excluded."""

DELIVERING = ("delivered", "partial")
"""Outcomes of plans that can be carried out."""

ONE_PER_TEAM = "one_per_team"
"""Rule of the reason that the best alternative of every team cannot be scheduled, where teams are to differ."""


def nothing_delivered(case: Case) -> Iterator[Fault]:
    """A plan is called delivered, or a plan of a part, and holds no alternative with a schedule that works."""
    plan = case.plan
    if plan.outcome in DELIVERING and not case.timetables:
        yield Fault(
            f"the plan is called {plan.outcome} and holds no alternative with a schedule that works.",
            found=f"{len(case.staffings)} alternatives, 0 schedules that work",
            needed="at least 1",
        )


def delivered_unsaid(case: Case) -> Iterator[Fault]:
    """A plan that is called neither delivered nor partial holds a schedule that works."""
    for schedule in case.plan.schedules:
        if case.plan.outcome not in DELIVERING and schedule.status in WORKING:
            yield Fault(
                f"the plan's outcome is {case.plan.outcome}, and schedule {schedule.rank} is {schedule.status}.",
                found=case.plan.outcome,
                needed="delivered",
            )


def impossibility_unproven(case: Case) -> Iterator[Fault]:
    """A mission is said to be impossible, and nothing in the plan shows it: no proof of ranking or schedules, no dialogue that ends so."""
    plan, ranking = case.plan, case.plan.ranking
    if plan.outcome != "cannot_be_done":
        return
    if ranking is None:
        judged_anew = isinstance(case.recording, Recording) and not case.same_inputs
        shown = plan.grounding is None and (_ends_with(case) == "cannot_be_done" or judged_anew)
    elif ranking.status == "infeasible":
        shown = ranking.certificate.claim == "proven"
    else:
        complete = ranking.status == "exact" and ranking.certificate.bound is None and not plan.brief.diverse
        shown = complete and all(schedule.status == "infeasible" for schedule in plan.schedules)
    if not shown:
        yield Fault(
            "the plan says that the mission cannot be done, and holds no proof of it.",
            found="no proof",
            needed="a ranking proven infeasible, all alternatives listed and unschedulable, or a dialogue that ends so",
        )


def outcome_contradicted(case: Case) -> Iterator[Fault]:
    """The outcome is not the one that authoring ended with, or belongs to a plan without a tree over the fleet and has one."""
    plan, ended = case.plan, _ends_with(case)
    if plan.grounding is not None:
        fits = plan.outcome in {*DELIVERING, "cannot_be_done", "exhausted"} and ended in {"", "complete"}
        needed = "for ranking and schedules to tell"
    elif plan.provenance.author == GIVEN:
        fits, needed = plan.outcome == "incomplete", "incomplete"
    else:
        fits, needed = ended in {"", "complete", plan.outcome}, ended
    if not fits:
        yield Fault(
            f"the outcome is {plan.outcome}, where it is {needed}.",
            found=plan.outcome,
            needed=needed,
        )


def reason_invented(case: Case) -> Iterator[Fault]:
    """A reason for not delivering is none that ranking, schedules, grounding or dialogue give."""
    plan = case.plan
    known = _known_reasons(case)
    for reason in plan.reasons if known is not None else ():
        if (
            known is not None
            and reason not in known
            and not (plan.outcome == "exhausted" and reason.rule == NOTHING_FOUND)
            and not (plan.outcome == "exhausted" and plan.brief.diverse and reason.rule == ONE_PER_TEAM)
        ):
            yield Fault(
                f"nothing in the plan gives the reason: {reason.message}",
                node=reason.node,
                robot=reason.robot,
                found=reason.rule,
                needed="a reason of the ranking, a schedule, the grounding or the dialogue",
            )


def _known_reasons(case: Case) -> set[Reason] | None:
    """Reasons that stand behind an outcome; None where they cannot be told from the plan."""
    plan = case.plan
    if plan.outcome == "partial":
        return None  # they speak of the whole mission, see trust
    if plan.grounding is not None:
        scheduled = [reason for schedule in plan.schedules for reason in schedule.reasons]
        return {*(plan.ranking.reasons if plan.ranking else ()), *scheduled, *plan.grounding.not_offered}
    if not isinstance(case.recording, Recording) or not case.same_inputs or _ends_with(case) == "complete":
        return None
    return set(case.ending("reasons"))


def _ends_with(case: Case) -> str:
    """What the dialogue came to; empty if there is none, or if it was held about something else."""
    if not isinstance(case.recording, Recording) or not case.same_inputs:
        return ""
    return str(case.recording.end["status"])


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
        if schedule.status not in WORKING and (
            schedule.actions or schedule.legs or schedule.recharges or schedule.returns or schedule.assignments
        ):
            yield Fault(
                f"schedule {schedule.rank} is {schedule.status} and still schedules {len(schedule.actions)} actions.",
                found=f"{len(schedule.actions)} actions",
                needed="none",
            )


def _list(ranks: list[int]) -> str:
    return ", ".join(map(str, ranks)) or "none"
