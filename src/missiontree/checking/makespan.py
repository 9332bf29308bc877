"""Is the schedule as long as it says, and as good?"""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.checking.case import Case
from missiontree.checking.clock import TOLERANCE, shown, tick
from missiontree.checking.errands import home_at
from missiontree.checking.fault import Fault


def makespan_wrong(case: Case) -> Iterator[Fault]:
    """The makespan is not the end of the last action, or of the last way home where robots return."""
    for timetable in case.timetables:
        ends = [deed.end for deed in timetable.deeds.values()]
        needed = max([*ends, *home_at(case, timetable).values()], default=0)
        found = tick(timetable.schedule.makespan_s)
        if abs(found - needed) > TOLERANCE:
            yield Fault(
                f"schedule {timetable.schedule.rank} claims to last {shown(found)}; what is last in it ends at {shown(needed)}.",
                found=shown(found),
                needed=shown(needed),
            )


def bound_above_makespan(case: Case) -> Iterator[Fault]:
    """The bound says that no schedule is shorter than a time longer than this one."""
    for timetable in case.timetables:
        schedule = timetable.schedule
        bound = schedule.certificate.bound
        if bound is not None and bound > schedule.makespan_s + TOLERANCE / 1000:
            yield Fault(
                f"schedule {schedule.rank} lasts {schedule.makespan_s:g} s and claims that none is shorter than {bound:g} s.",
                found=f"{bound:g} s",
                needed=f"at most {schedule.makespan_s:g} s",
            )


def optimality_unfounded(case: Case) -> Iterator[Fault]:
    """A schedule is called optimal and its certificate is not proven, or its bound falls short of the makespan."""
    for timetable in case.timetables:
        schedule = timetable.schedule
        certificate = schedule.certificate
        short = certificate.bound is not None and certificate.bound < schedule.makespan_s - TOLERANCE / 1000
        if schedule.status == "optimal" and (certificate.claim != "proven" or short):
            bound = "no bound" if certificate.bound is None else f"bound {certificate.bound:g} s"
            yield Fault(
                f"schedule {schedule.rank} is called optimal; its certificate is {certificate.claim} with {bound}, "
                f"its makespan {schedule.makespan_s:g} s.",
                found=f"{certificate.claim}, {bound}",
                needed=f"proven, bound {schedule.makespan_s:g} s",
            )


def solver_word_unfounded(case: Case) -> Iterator[Fault]:
    """Something else than the bound of a schedule that works is claimed as a solver's word, or it has no bound."""
    ranking = case.plan.ranking
    certificates = [("the ranking", ranking.certificate)] if ranking is not None else []
    certificates += [(f"alternative {one.rank}", one.certificate) for one in (ranking.alternatives if ranking else ())]
    certificates += [
        (f"schedule {schedule.rank}", schedule.certificate)
        for schedule in case.plan.schedules
        if schedule.status != "feasible" or schedule.certificate.bound is None
    ]
    for about, certificate in certificates:
        if certificate.claim == "solver_word":
            yield Fault(
                f"what is claimed of {about} is called a solver's word; only the bound of a schedule that works can be.",
                found="solver_word",
                needed="proven, bounded or unproven",
            )


def schedule_certificate_unfounded(case: Case) -> Iterator[Fault]:
    """A schedule that is only feasible, or unknown, carries a proof; one called infeasible carries none."""
    for schedule in case.plan.schedules:
        proven = schedule.certificate.claim == "proven"
        if (proven and schedule.status in {"feasible", "unknown"}) or (not proven and schedule.status == "infeasible"):
            yield Fault(
                f"schedule {schedule.rank} is {schedule.status} and its certificate {schedule.certificate.claim}.",
                found=schedule.certificate.claim,
                needed="proven" if schedule.status == "infeasible" else "bounded or unproven",
            )
