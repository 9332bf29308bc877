"""Is what is chosen the best of all that the plan knows, by the objective of the mission, and is no more claimed of it than is shown?"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from missiontree.checking.case import Case
from missiontree.checking.clock import TOLERANCE, tick
from missiontree.checking.fault import Fault
from missiontree.checking.merits import (
    NO_END,
    Merit,
    known,
    listed,
    may_beat,
    merit_of,
    of_a_tick,
    timeless_worth,
    weighted_worth,
)
from missiontree.checking.methods import CHOICE_PROOFS
from missiontree.checking.ranking import MILLION
from missiontree.mission.front import Chosen
from missiontree.mission.objective import WEIGHTED
from missiontree.mission.plan import Plan

CLAIMS = frozenset({"proven", "bounded", "unproven"})


def chosen_missing(case: Case) -> Iterator[Fault]:
    """The objective of the mission chooses, and nothing is chosen; or it does not, and something is; or what is has no schedule."""
    plan, chosen = case.plan, case.plan.chosen
    needed = plan.outcome in {"delivered", "partial"} and plan.brief.objective != "utility"
    if needed != (chosen is not None):
        found = "nothing is chosen" if chosen is None else "something is chosen"
        yield Fault(
            f"the objective is {plan.brief.objective}, the mission {plan.outcome}, and {found}.",
            found=found,
            needed="a choice" if needed else "none",
        )
    if chosen is not None and chosen.option.schedule.status not in {"optimal", "feasible"}:
        yield Fault("what is chosen has no schedule.", found=chosen.option.schedule.status, needed="a schedule")


def chosen_worth_wrong(case: Case) -> Iterator[Fault]:
    """What is chosen does not come to what is said."""
    chosen = case.plan.chosen
    if chosen is None:
        return
    worth = _worth(case.plan, _merit(chosen))
    if worth is not None and abs(chosen.worth - worth) > 2e-6 + 1e-9 * abs(worth):
        yield Fault(
            f"what is chosen is said to come to {chosen.worth:g} by {case.plan.brief.objective}, and comes to {worth:g}.",
            found=f"{chosen.worth:g}",
            needed=f"{worth:g}",
        )


def chosen_beaten(case: Case) -> Iterator[Fault]:
    """An alternative that the plan lists with a schedule is better by the objective than what is chosen."""
    plan = case.plan
    if plan.chosen is None or plan.chosen.option.schedule.status not in {"optimal", "feasible"}:
        return
    own = _key(plan, _merit(plan.chosen))
    for other in known(plan):
        key = _key(plan, other)
        if own is not None and key is not None and key < own:
            yield Fault(
                f"by {plan.brief.objective}, an alternative of utility {other.alternative.utility:g} that takes "
                f"{other.schedule.makespan_s:g} s is better than what is chosen.",
                found=f"utility {plan.chosen.option.alternative.utility:g}, {plan.chosen.option.schedule.makespan_s:g} s",
                needed="the best that is known",
            )
            return


def chosen_claim_unfounded(case: Case) -> Iterator[Fault]:
    """More is claimed of the choice than the plan shows: its bound contradicts what it comes to, or a rival may be better."""
    chosen = case.plan.chosen
    if chosen is None:
        return
    certificate = chosen.option.certificate
    if certificate.claim not in CLAIMS or certificate.method not in CHOICE_PROOFS:
        yield Fault(
            f"the choice is {certificate.claim} by {certificate.method}.",
            found=f"{certificate.claim}, {certificate.method}",
            needed=f"proven, bounded or unproven, by {' or '.join(sorted(CHOICE_PROOFS))}",
        )
    bound, sign = certificate.bound, -1 if case.plan.brief.objective in WEIGHTED else 1
    if (bound is None) != (certificate.claim == "unproven"):
        yield Fault(f"the choice is {certificate.claim}, and its bound {bound}.", found=str(bound), needed="a bound")
    slack = TOLERANCE / 1000 if sign > 0 else 2e-6
    if bound is not None and sign * (bound - chosen.worth) > slack:
        yield Fault(
            f"the choice comes to {chosen.worth:g}, and is said to be bounded by {bound:g}.",
            found=f"{bound:g}",
            needed=f"{chosen.worth:g} or {'less' if sign > 0 else 'more'}",
        )
    if certificate.claim == "proven":
        yield from _unproven(case.plan, chosen, slack)


def _unproven(plan: Plan, chosen: Chosen, slack: float) -> Iterator[Fault]:
    certificate, merit = chosen.option.certificate, _merit(chosen)
    if certificate.limit is not None:
        yield Fault("the choice is proven, and its search was ended early.", found=certificate.limit.in_words)
    if certificate.bound is not None and abs(certificate.bound - chosen.worth) > slack:
        yield Fault(
            f"the choice is proven to be the best, comes to {chosen.worth:g}, and is bounded by {certificate.bound:g}.",
            found=f"{certificate.bound:g}",
            needed=f"{chosen.worth:g}",
        )
    if plan.brief.objective != "weighted-sum" and chosen.option.schedule.status != "optimal":
        yield Fault(
            f"the choice is proven, and its schedule is {chosen.option.schedule.status}.",
            found=chosen.option.schedule.status,
            needed="optimal",
        )
    for other in listed(plan):
        if _may_beat(plan, other, merit):
            yield Fault(
                f"the choice is proven, and alternative {other.alternative.rank} may be better by {plan.brief.objective}.",
                found="proven",
                needed="bounded or unproven",
            )
            return


def _merit(chosen: Chosen) -> Merit:
    return merit_of(chosen.option.alternative, chosen.option.schedule)


def _worth(plan: Plan, merit: Merit) -> float | None:
    if plan.brief.objective not in WEIGHTED:
        return merit.schedule.makespan_s
    worth = weighted_worth(plan, merit)
    return None if worth is None else float(worth / MILLION)


def _key(plan: Plan, merit: Merit) -> tuple[int | Fraction, ...] | None:
    """What is better comes first."""
    makespan = merit.makespan or 0
    if plan.brief.objective == "makespan":
        return makespan, -merit.utility
    if plan.brief.objective == "utility-makespan":
        return -merit.utility, makespan, *merit.tidiness
    worth = weighted_worth(plan, merit)
    return None if worth is None else (-worth,)


def _may_beat(plan: Plan, other: Merit, merit: Merit) -> bool:
    """Whether what is known of another alternative leaves room for its being better."""
    if other.least >= NO_END:
        return False
    if plan.brief.objective == "makespan":
        return other.least < tick(merit.schedule.makespan_s) or may_beat(other, merit)
    if plan.brief.objective == "utility-makespan":
        return other.utility > merit.utility or may_beat(other, merit)
    if plan.brief.objective == "weighted-team":
        timeless, worth = timeless_worth(plan, other.alternative), weighted_worth(plan, merit)
        return timeless is not None and worth is not None and timeless - of_a_tick(plan) * other.least > worth
    return False
