"""What a plan claims and the checker can neither refute nor confirm: taken on the word of the solver, or of the author."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.checking.case import WORKING, Case
from missiontree.checking.claims import judge
from missiontree.checking.clock import TOLERANCE, shown
from missiontree.checking.lower_bound import least_makespan
from missiontree.checking.part import judge_part
from missiontree.checking.proofs import claimed_bound
from missiontree.checking.written_out import covers_choice, covers_front, written_out
from missiontree.mission.as_ranking import as_ranking
from missiontree.mission.front import Option
from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason


def taken_on_trust(plan: Plan) -> tuple[Reason, ...]:
    """
    List the claims of a plan that its checker cannot confirm.

    Parameters
    ----------
    plan
        A plan, best one without findings.

    Returns
    -------
    tuple of Reason
        A notice for each such claim; empty if the checker confirms all of them.
    """
    case = Case(plan)
    return (
        *_estimates(case),
        *_ranking(case),
        *_bounds(case),
        *_impossible(case),
        *_declared(case),
        *_part(case),
        *_front(case),
        *_chosen(case),
    )


def _estimates(case: Case) -> Iterator[Reason]:
    source = case.plan.brief.estimator
    if source is not None and case.plan.grounding is not None:
        yield _notice(
            "estimates_on_trust",
            f"Quality, duration and cost of every action are taken on the word of {source.shown}.",
            source.name,
            "the fleet",
        )


def _ranking(case: Case) -> Iterator[Reason]:
    ranking = case.plan.ranking
    claimed = ranking is not None and ranking.status in {"exact", "infeasible"}
    if ranking is not None and claimed and judge(case) is False:
        what = "there is no alternative" if ranking.status == "infeasible" else "no better alternative is missing"
        yield _notice(
            "ranking_on_trust",
            f"That {what} is taken on the allocator's word ({ranking.certificate.method}): there are too many to write out.",
            ranking.certificate.method,
        )


def _bounds(case: Case) -> Iterator[Reason]:
    for timetable in case.timetables:
        schedule = timetable.schedule
        claimed, own = claimed_bound(schedule), least_makespan(case, timetable)
        if own is not None and claimed > own + TOLERANCE:
            what = "optimal" if schedule.status == "optimal" else f"at least {shown(claimed)} for all others"
            yield _notice(
                "bound_on_trust",
                f"That schedule {schedule.rank} is {what} is taken on the scheduler's word ({schedule.certificate.method}): "
                f"the checker's own bound is {shown(own)}.",
                shown(claimed),
                shown(own),
            )


def _impossible(case: Case) -> Iterator[Reason]:
    for schedule in case.plan.schedules:
        if schedule.status == "infeasible":
            yield _notice(
                "infeasibility_on_trust",
                f"That alternative {schedule.rank} cannot be scheduled is taken on the scheduler's word "
                f"({schedule.certificate.method}).",
                schedule.certificate.method,
            )
        elif schedule.status not in WORKING and schedule.certificate.bound:
            yield _notice(
                "bound_on_trust",
                f"That no schedule of alternative {schedule.rank} is shorter than {schedule.certificate.bound:g} s is taken on the "
                "scheduler's word.",
                f"{schedule.certificate.bound:g} s",
            )


def _declared(case: Case) -> Iterator[Reason]:
    if case.plan.outcome == "cannot_be_done" and case.plan.ranking is None:
        yield _notice(
            "declaration_on_trust",
            "That the mission cannot be done is taken on the word of the author, whose dialogue ends with it.",
            case.plan.provenance.author,
        )


def _part(case: Case) -> Iterator[Reason]:
    partial = case.plan.partial
    if partial is not None and judge_part(case) is not True:
        larger = "" if partial.claim == "found" else ", and that no larger part of it can,"
        yield _notice(
            "part_on_trust",
            f"That the whole mission cannot be done{larger} is taken on the planner's word.",
            partial.claim,
        )


def _front(case: Case) -> Iterator[Reason]:
    """The options that the front claims to be all, or to be unbeaten, unless all alternatives written out show it."""
    front = case.plan.front
    if front is None or all(option.certificate.claim != "proven" for option in front.options):
        return
    if not written_out(case, front.options, covers_front):
        yield _notice(
            "front_on_trust",
            "That nothing beats the options of the front is taken on the word of the search "
            f"({front.certificate.method}): the checker cannot tell of every other alternative how short its schedules can be.",
            front.certificate.method,
        )
    yield from _of_options(case, front.options, "Option {} of the front")


def _chosen(case: Case) -> Iterator[Reason]:
    chosen = case.plan.chosen
    if chosen is None or chosen.option.certificate.claim == "unproven":
        return
    proven = chosen.option.certificate.claim == "proven"
    if not (proven and written_out(case, (chosen.option,), covers_choice)):
        what = "nothing is better" if proven else f"nothing is better than {chosen.option.certificate.bound:g}"
        yield _notice(
            "choice_on_trust",
            f"That {what} by {case.plan.brief.objective} is taken on the word of the search "
            f"({chosen.option.certificate.method}): the checker cannot tell of every other alternative how short its schedules can be.",
            chosen.option.certificate.method,
        )
    yield from _of_options(case, (chosen.option,), "What is chosen")


def _of_options(case: Case, options: tuple[Option, ...], name: str) -> Iterator[Reason]:
    """Schedules of options that are called optimal on the scheduler's word, and are not among those listed."""
    listed = {schedule.actions for schedule in case.plan.schedules}
    for timetable in Case(as_ranking(case.plan, options)).timetables:
        claimed, own = claimed_bound(timetable.schedule), least_makespan(case, timetable)
        if timetable.schedule.actions not in listed and own is not None and claimed > own + TOLERANCE:
            about = name.format(timetable.schedule.rank)
            yield _notice(
                "bound_on_trust",
                f"{about}: that no schedule of it is shorter than {shown(claimed)} is taken on the scheduler's word "
                f"({timetable.schedule.certificate.method}): the checker's own bound is {shown(own)}.",
                shown(claimed),
                shown(own),
            )


def _notice(rule: str, message: str, found: str, needed: str = "") -> Reason:
    return Reason(rule=rule, message=message, severity="notice", found=found, needed=needed)
