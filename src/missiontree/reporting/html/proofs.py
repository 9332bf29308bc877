"""What is proven of a plan, by which method, and what its checker says."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from missiontree.mission.certificate import Certificate, Claim
from missiontree.mission.objective import IN_WORDS, WEIGHTED
from missiontree.mission.plan import Plan
from missiontree.reporting.html.quantity import number
from missiontree.reporting.html.times import lasts
from missiontree.reporting.known import by_word

MOST_PROOFS = 80
WORD = ", and is optimal by the solver's word"
_CLAIMS: dict[Claim, str] = {
    "proven": "proven",
    "bounded": "bounded",
    "solver_word": "by the solver's word",
    "unproven": "not proven",
}


@dataclass(frozen=True, slots=True)
class Proof:
    """
    A certificate.

    Parameters
    ----------
    what
        What it is about.
    says
        What is claimed: the status that it stands behind.
    claim
        ``proven``, ``bounded`` or ``not proven``.
    method, bound, detail
        How it is known; the bound and the sentence may be empty.
    """

    what: str
    says: str
    claim: str
    method: str
    bound: str
    detail: str


def proofs(plan: Plan) -> tuple[Proof, ...]:
    """The certificates of the list, of each alternative, and of each schedule."""
    return tuple(_proofs(plan))


def _proofs(plan: Plan) -> Iterator[Proof]:
    if plan.ranking is None:
        return
    says = {
        "exact": "complete and in order",
        "partial": "not all ranks proven",
        "infeasible": "there is no alternative",
        "unknown": "none found, none excluded",
    }[plan.ranking.status]
    yield _proof("the list of alternatives", says, plan.ranking.certificate, _utility(plan.ranking.certificate.bound))
    for alternative in plan.ranking.alternatives[:MOST_PROOFS]:
        certificate = alternative.certificate
        yield _proof(
            f"rank {alternative.rank}",
            f"{plan.brief.aim.worth} {number(alternative.utility)}",
            certificate,
            _utility(certificate.bound),
        )
    for schedule in plan.schedules[:MOST_PROOFS]:
        says = {
            "optimal": f"none is shorter than {lasts(schedule.makespan_s)}",
            "feasible": f"{lasts(schedule.makespan_s)} works{WORD if by_word(schedule) else ''}",
            "infeasible": "cannot be scheduled",
            "unknown": "no schedule found",
        }[schedule.status]
        bound = schedule.certificate.bound
        yield _proof(
            f"schedule {schedule.rank}",
            says,
            schedule.certificate,
            "" if bound is None else f"at least {lasts(bound)}",
        )
    yield from _of_options(plan)


def _of_options(plan: Plan) -> Iterator[Proof]:
    """Certificates of the front and of the choice."""
    if plan.front is not None:
        yield _proof("the front", "there are no other plans on it", plan.front.certificate, "")
        for option in plan.front.options:
            says = f"{number(option.alternative.utility)} in {lasts(option.schedule.makespan_s)} is unbeaten"
            yield _proof(f"plan {option.alternative.rank} of the front", says, option.certificate, "")
    if plan.chosen is not None:
        certificate = plan.chosen.option.certificate
        weighted = plan.brief.objective in WEIGHTED
        bound = "" if certificate.bound is None else _utility(certificate.bound)
        if certificate.bound is not None and not weighted:
            bound = f"at least {lasts(certificate.bound)}"
        worth = number(plan.chosen.worth) if weighted else lasts(plan.chosen.worth)
        yield _proof(
            "the choice", f"nothing is better by {IN_WORDS[plan.brief.objective]} than {worth}", certificate, bound
        )


def _proof(what: str, says: str, certificate: Certificate, bound: str) -> Proof:
    method = certificate.method.replace("_", " ")
    ended = "" if certificate.limit is None else f"Ended by {certificate.limit.in_words}."
    detail = " ".join(part for part in (certificate.detail, ended) if part)
    return Proof(what, says, _CLAIMS[certificate.claim], method, bound, detail)


def _utility(bound: float | None) -> str:
    return "" if bound is None else f"at most {number(bound)}"
