"""What is known of a schedule, in words that are the same for missions and for instances, on every door."""

from __future__ import annotations

from collections.abc import Callable

from missiontree.mission.certificate import Certificate
from missiontree.mission.schedule import Schedule, ScheduleStatus
from missiontree.reporting.gantt.time import in_words

_HOW = {
    "critical_path": "a bound (critical path)",
    "load": "a bound (load)",
    "resource_load": "a bound (resource load)",
    "refill_load": "a bound (refill load)",
    "spanning_tree": "a bound (spanning tree)",
    "second_formulation": "a second formulation",
    "enumeration": "enumeration",
    "labels": "a complete search (labels)",
}

FURTHER = "missiontree plan --scheduler cpsat looks longer for a shorter one, and for a proof."


def known_in_words(
    status: ScheduleStatus, certificate: Certificate, makespan_s: float, told: Callable[[float], str] = in_words
) -> str:
    """
    One of five: optimal and by what it is confirmed; optimal by the solver's word; feasible, with the gap; infeasible; unknown.

    Parameters
    ----------
    status, certificate, makespan_s
        Of a schedule.
    told
        How a time is told. Default: as people say it, such as ``42 min 6 s``.
    """
    if status == "optimal":
        return f"optimal, confirmed by {how_in_words(certificate)}"
    if status == "infeasible":
        return f"infeasible, proven by {certificate.method.replace('_', ' ')}"
    if status == "unknown":
        return "unknown: none was found, none is excluded"
    if _optimal_by_word(status, certificate, makespan_s):
        return "optimal by the solver's word, which nothing confirms"
    if certificate.bound is None:
        return "feasible; nothing is known of shorter ones"
    word = " by the solver's word" if certificate.claim == "solver_word" else ""
    gap = gap_in_words(certificate.bound, makespan_s)
    return f"feasible; none is below {told(certificate.bound)}{word} (gap {gap})"


def known_of(schedule: Schedule) -> str:
    """The same of a schedule of a mission."""
    return known_in_words(schedule.status, schedule.certificate, schedule.makespan_s)


def by_word(schedule: Schedule) -> bool:
    """Whether a solver says that nothing is shorter than a schedule, and nothing confirms it."""
    return _optimal_by_word(schedule.status, schedule.certificate, schedule.makespan_s)


def _optimal_by_word(status: ScheduleStatus, certificate: Certificate, makespan_s: float) -> bool:
    word = status == "feasible" and certificate.claim == "solver_word"
    return word and certificate.bound is not None and certificate.bound >= makespan_s


def may_look_further(schedule: Schedule, scheduler: str) -> bool:
    """Whether another scheduler takes more time for a schedule that is not known to be the shortest."""
    return schedule.status == "feasible" and scheduler in {"greedy", "auto"}


def how_in_words(certificate: Certificate) -> str:
    """What confirms that a schedule is optimal: a bound, a second formulation or an enumeration, and which."""
    return _HOW.get(certificate.method, certificate.method.replace("_", " "))


def gap_in_words(bound: float, makespan_s: float) -> str:
    """How far a makespan may be above the least, as a share of it: ``15.4 %``."""
    return f"{100 * max(0.0, makespan_s - bound) / makespan_s:.3g} %" if makespan_s > 0 else "0 %"
