"""Is every claim of proof one that can be judged, and does it stand beside the checker's own bound?"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations

from missiontree.checking.case import Case
from missiontree.checking.clock import TOLERANCE, shown, tick
from missiontree.checking.fault import Fault
from missiontree.checking.haunts import ANYWHERE, Haunts
from missiontree.checking.lower_bound import least_makespan
from missiontree.checking.methods import (
    BOUND_PROOFS,
    CHOICE_PROOFS,
    IMPOSSIBILITY_PROOFS,
    RANKING_PROOFS,
    SEARCHES,
    SOLVERS,
)
from missiontree.checking.timetable import Timetable
from missiontree.mission.certificate import Certificate
from missiontree.mission.schedule import Schedule

PLAIN_BOUNDS = frozenset({"critical_path", "load", "resource_load", "refill_load"})
"""Methods that the checker's own bound is as strong as, where nothing but durations and order count; a search may show more."""

MOST_ROLES = 20
"""Roles of one robot, beyond which it is not asked how they are ordered."""


def claim_unfounded(case: Case) -> Iterator[Fault]:
    """A claim rests on a method that nobody documents; or the checker's own bound shows that a schedule is not proven least."""
    for about, certificate, methods in _certificates(case):
        if certificate.method not in methods:
            yield Fault(
                f"what is claimed of {about} rests on the method {certificate.method}, which is not a documented one.",
                found=certificate.method,
                needed=" or ".join(sorted(methods)),
            )
    for timetable in case.timetables:
        claimed = claimed_bound(timetable.schedule)
        documented = timetable.schedule.certificate.method in PLAIN_BOUNDS
        own = least_makespan(case, timetable) if documented and _own_is_as_strong(case, timetable) else None
        if own is not None and claimed > own + TOLERANCE:
            yield Fault(
                f"schedule {timetable.schedule.rank} claims that none is shorter than {shown(claimed)}; "
                f"all that its actions and their order show is {shown(own)}.",
                found=shown(claimed),
                needed=f"at most {shown(own)}",
            )


def claimed_bound(schedule: Schedule) -> int:
    """Ticks below which a schedule says that there is none; 0 if it says nothing."""
    bound = schedule.certificate.bound
    if schedule.status == "optimal":
        return tick(schedule.makespan_s)
    return tick(bound) if bound is not None else 0


def _certificates(case: Case) -> Iterator[tuple[str, Certificate, frozenset[str]]]:
    """Every certificate, with what it speaks of and the methods that may stand there."""
    ranking = case.plan.ranking
    if ranking is not None:
        yield "the ranking", ranking.certificate, RANKING_PROOFS
        for alternative in ranking.alternatives:
            options = CHOICE_PROOFS if alternative.certificate.claim == "unproven" else frozenset()
            yield f"alternative {alternative.rank}", alternative.certificate, RANKING_PROOFS | options
    for schedule in case.plan.schedules:
        by_status = {"infeasible": IMPOSSIBILITY_PROOFS, "unknown": SEARCHES | BOUND_PROOFS}
        methods = by_status.get(schedule.status, BOUND_PROOFS)
        if schedule.certificate.claim == "solver_word" and schedule.status == "feasible":
            methods = SOLVERS
        yield f"schedule {schedule.rank}", schedule.certificate, methods


def _own_is_as_strong(case: Case, timetable: Timetable) -> bool:
    """
    Whether nothing but durations and order can make a schedule long, so that the checker's bound is the documented ones' equal.

    That is so if no action has a place that is known, nothing lasts until something else ends, and holding adds no order: of two
    roles that one robot must fill, either all of one comes before all of the other, or nothing of either does. Ways to chargers count
    as well where it is known where robots start.
    """
    staffing = timetable.staffing
    if any(action.robot_type not in case.fleet.by_id for action in staffing.actions.values()):
        return False
    haunts = case.once(Haunts, timetable)
    return (
        all(bond.kind == "precedence" for bond in staffing.bonds)
        and all(haunts.of_leaf(leaf) == ANYWHERE for leaf in staffing.actions)
        and not staffing.teams
        and not (timetable.schedule.certificate.method == "refill_load" and _starts_known(case, haunts))
        and all(_wholly_ordered(timetable, roles) for roles in _sharing(case, timetable))
    )


def _starts_known(case: Case, haunts: Haunts) -> bool:
    return any(haunts.starts(kind.id) != ANYWHERE for kind in case.fleet.types)


def _sharing(case: Case, timetable: Timetable) -> Iterator[list[int]]:
    """Roles that one robot must fill, since its type has no other."""
    roles: dict[str, list[int]] = {}
    for role, type_id in timetable.staffing.type_of_role.items():
        roles.setdefault(type_id, []).append(role)
    return (own for type_id, own in roles.items() if case.most_in_use(type_id) <= 1)


def _wholly_ordered(timetable: Timetable, roles: list[int]) -> bool:
    if len(roles) > MOST_ROLES:
        return False
    leaves, before = timetable.staffing.leaves_of_role, timetable.surely_before
    return all(
        before(leaves[one][0], leaves[other][-1]) == before(leaves[one][-1], leaves[other][0])
        for one, other in permutations(roles, 2)
    )
