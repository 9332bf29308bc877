"""Whether a schedule of an instance claims no more than its certificate carries, in the same words as a schedule of a mission."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.checking.fault import Fault
from missiontree.checking.methods import BOUND_PROOFS, COMPLETE_SEARCHES, SOLVERS
from missiontree.mission.certificate import Certificate
from missiontree.mission.schedule import ScheduleStatus


def claim_faults(status: ScheduleStatus, certificate: Certificate) -> Iterator[Fault]:
    """Faults of the claim of a schedule that works: optimal is what is proven, and a solver's word is called one."""
    if (status == "optimal") != (certificate.claim == "proven"):
        yield Fault(
            f"the schedule is {status}, and its certificate {certificate.claim}.",
            found=f"{status}, {certificate.claim}",
            needed="proven if optimal, and only then",
        )
    methods = SOLVERS if certificate.claim == "solver_word" else BOUND_PROOFS | COMPLETE_SEARCHES
    if certificate.claim != "unproven" and certificate.method not in methods:
        yield Fault(
            f"what is claimed rests on the method {certificate.method}, which cannot carry it.",
            found=certificate.method,
            needed=" or ".join(sorted(methods)),
        )
