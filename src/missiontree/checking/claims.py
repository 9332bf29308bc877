"""Is no more claimed of the ranking than is shown?"""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.checking.case import Case
from missiontree.checking.enumeration import every_alternative
from missiontree.checking.fault import Fault
from missiontree.checking.ranking import MILLION, utility_of


def ranking_status_unfounded(case: Case) -> Iterator[Fault]:
    """The status of the ranking contradicts its list or its certificates."""
    ranking = case.plan.ranking
    if ranking is None:
        return
    count, claim = len(ranking.alternatives), ranking.certificate.claim
    if (ranking.status in {"infeasible", "unknown"}) != (count == 0):
        yield Fault(
            f"the ranking is {ranking.status} and lists {count} alternatives.",
            found=f"{ranking.status}, {count} alternatives",
            needed="none if infeasible or unknown, at least 1 otherwise",
        )
    proof_needed, proof_denied = ranking.status in {"exact", "infeasible"}, ranking.status == "unknown"
    if (proof_needed and claim != "proven") or (proof_denied and claim == "proven"):
        yield Fault(
            f"the ranking is {ranking.status} and its certificate {claim}.",
            found=f"{ranking.status}, {claim}",
            needed="proven" if proof_needed else "bounded or unproven",
        )


def rank_unproven(case: Case) -> Iterator[Fault]:
    """The ranking is exact and the rank of an alternative is not proven; or a rank is proven below one that is not."""
    ranking = case.plan.ranking
    if ranking is None:
        return
    proven = ranking.status == "exact"
    above = True
    for alternative in ranking.alternatives:
        own = alternative.certificate.claim == "proven"
        if (proven and not own) or (own and not above):
            yield Fault(
                f"alternative {alternative.rank} is {alternative.certificate.claim}, "
                f"{'and the ranking is exact' if proven else 'below one that is not proven'}.",
                found=alternative.certificate.claim,
                needed="proven" if proven else "proven above it",
            )
        above = above and own


def bound_below_utility(case: Case) -> Iterator[Fault]:
    """The certificate of an alternative says that no utility is above a number that its own is above."""
    for staffing in case.staffings:
        bound, utility = staffing.alternative.certificate.bound, staffing.alternative.utility
        if bound is not None and bound < utility - 1e-6:
            yield Fault(
                f"alternative {staffing.alternative.rank} has utility {utility:g} and claims that none is above {bound:g}.",
                found=f"bound {bound:g}",
                needed=f"at least {utility:g}",
            )


def claim_refuted(case: Case) -> Iterator[Fault]:
    """In a small tree, all alternatives written out show that a proven rank, a bound or an impossibility is false."""
    ranking = case.plan.ranking
    everything = every_alternative(case) if ranking is not None and _claims(case) else None
    if ranking is None or everything is None:
        return
    if ranking.status == "infeasible" and everything:
        best = utility_of(everything[0], case.plan.brief.weights) / MILLION
        yield Fault(
            f"the mission is called infeasible, and there is an alternative of utility {best:g}.",
            found="infeasible",
            needed="exact",
        )
    listed = [frozenset(staffing.taken.items()) for staffing in case.staffings]
    for place, (staffing, choices) in enumerate(zip(case.staffings, listed, strict=True)):
        proven = staffing.alternative.certificate.claim == "proven"
        needed = everything[place] if place < len(everything) else None
        if proven and (needed is None or frozenset(needed.taken.items()) != choices):
            better = "none such" if needed is None else f"{utility_of(needed, case.plan.brief.weights) / MILLION:g}"
            yield Fault(
                f"alternative {staffing.alternative.rank} is called proven, and rank {place + 1} belongs to another (utility {better}).",
                found=f"utility {staffing.alternative.utility:g}",
                needed=f"utility {better}",
            )
            return
    bound = ranking.certificate.bound
    unlisted = [staffing for staffing in everything if frozenset(staffing.taken.items()) not in set(listed)]
    if bound is not None and unlisted:
        best = utility_of(unlisted[0], case.plan.brief.weights) / MILLION
        if best > bound + 1e-6:
            yield Fault(
                f"the ranking claims that nothing unlisted is above {bound:g}, and there is an alternative of {best:g}.",
                found=f"bound {bound:g}",
                needed=f"at least {best:g}",
            )


def _claims(case: Case) -> bool:
    ranking = case.plan.ranking
    return ranking is not None and (
        ranking.status == "infeasible"
        or ranking.certificate.bound is not None
        or any(alternative.certificate.claim == "proven" for alternative in ranking.alternatives)
    )
