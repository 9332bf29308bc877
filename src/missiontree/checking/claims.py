"""Is no more claimed of the ranking than is shown?"""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.checking.case import Case
from missiontree.checking.enumeration import best_first
from missiontree.checking.fault import Fault
from missiontree.checking.ranking import MILLION, utility_of
from missiontree.checking.staffing import Staffing
from missiontree.mission.alternative import Ranking
from missiontree.mission.brief import MissionBrief

END = "nobody: there are no more alternatives"


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


def search_limit_unfounded(case: Case) -> Iterator[Fault]:
    """A search that was ended early does not say by what; a proof names something that ended it; or the seed is not the plan's."""
    ranking = case.plan.ranking
    certificate = ranking.certificate if ranking is not None else None
    if certificate is None:
        return
    if certificate.claim == "bounded" and certificate.limit is None:
        yield Fault(
            "the ranking is bounded, and nothing is said to have ended the search.", found="none", needed="a limit"
        )
    if certificate.claim == "proven" and certificate.limit is not None:
        limit = certificate.limit.in_words
        yield Fault(f"the ranking is proven, and {limit} is said to have ended the search.", found=limit, needed="none")
    seed = case.plan.provenance.seed
    if certificate.seed is not None and certificate.seed != seed:
        yield Fault(
            f"the ranking was ended early with seed {certificate.seed}, and the plan was made with seed {seed}.",
            found=str(certificate.seed),
            needed=str(seed),
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
    verdict = judge(case)
    if isinstance(verdict, Fault):
        yield verdict


def judge(case: Case) -> Fault | bool:
    """What all alternatives written out say of the claims: refuted, borne out (true), or more than can be told (false)."""
    ranking = case.plan.ranking
    if ranking is None or not _claims(ranking):
        return True
    truth = best_first(case)
    brief = case.plan.brief
    listed = [frozenset(staffing.taken.items()) for staffing in case.staffings]
    for staffing, choices in zip(case.staffings, listed, strict=True):
        needed = next(truth, END)
        if needed is None or staffing.alternative.certificate.claim != "proven":
            return needed is not None  # nothing is claimed of this rank and of those below it, or nothing can be told
        if isinstance(needed, str) or frozenset(needed.taken.items()) != choices:
            found = f"utility {staffing.alternative.utility:g}"
            better = needed if isinstance(needed, str) else f"an alternative of utility {_utility(needed, brief):g}"
            return Fault(
                f"alternative {staffing.alternative.rank} of {found} is called proven, and its rank belongs to {better}.",
                found=found,
                needed=better,
            )
    unlisted = next(truth, END)
    if unlisted is None or isinstance(unlisted, str):
        return unlisted is not None
    best, bound = _utility(unlisted, brief), ranking.certificate.bound
    if ranking.status == "infeasible" or (bound is not None and best > bound + 1e-6):
        found = "infeasible" if ranking.status == "infeasible" else f"bound {bound:g}"
        return Fault(
            f"the ranking claims {found}, and there is an unlisted alternative of utility {best:g}.",
            found=found,
            needed=f"at least {best:g}",
        )
    if bound is None and ranking.status == "exact" and ranking.certificate.claim == "proven":
        return Fault(
            f"the ranking claims that there are no more alternatives, and there is an unlisted one of utility {best:g}.",
            found="no bound on what is not listed",
            needed=f"a bound of at least {best:g}",
        )
    return True


def _utility(staffing: Staffing, brief: MissionBrief) -> float:
    return float(utility_of(staffing, brief) / MILLION)


def _claims(ranking: Ranking) -> bool:
    """Whether there is anything to hold against the truth."""
    first_proven = any(alternative.certificate.claim == "proven" for alternative in ranking.alternatives[:1])
    return ranking.status == "infeasible" or first_proven
