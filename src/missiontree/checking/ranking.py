"""Are utilities what the actions give, and ranks in order?"""

from __future__ import annotations

import math
from collections.abc import Iterator

from missiontree.checking.case import Case
from missiontree.checking.fault import Fault
from missiontree.checking.staffing import Staffing
from missiontree.mission.estimate import Estimate, Weights

MILLION = 1_000_000


def millionths(weights: Weights, estimate: Estimate) -> float:
    """Utility of one action in whole millionths: alpha * q - beta * d - gamma * c, rounded half to even."""
    value = weights.alpha * estimate.quality - weights.beta * estimate.duration_s - weights.gamma * estimate.cost
    return float(round(value * MILLION)) if math.isfinite(value * MILLION) else value


def utility_of(staffing: Staffing, weights: Weights) -> float:
    """Utility of an alternative in millionths, from its selected actions."""
    return sum(millionths(weights, action.estimate) for action in staffing.actions.values())


def choice_key(staffing: Staffing) -> tuple[int, ...]:
    """Positions of the children taken among their siblings, in preorder."""
    children = staffing.tree.children
    return tuple(
        children[node].index(staffing.taken[node])
        for node in staffing.reached
        if staffing.tree.nodes[node].kind == "xor" and node in staffing.taken
    )


def utility_wrong(case: Case) -> Iterator[Fault]:
    """The utility is not the sum over the selected actions."""
    for staffing in case.staffings:
        needed = utility_of(staffing, case.plan.brief.weights) / MILLION
        found = staffing.alternative.utility
        if not math.isfinite(needed) or abs(found - needed) > 1e-6 + 1e-9 * abs(needed):
            yield Fault(
                f"alternative {staffing.alternative.rank} claims utility {found:g}; its actions give {needed:g}.",
                found=f"{found:.6f}",
                needed=f"{needed:.6f}",
            )


def rank_wrong(case: Case) -> Iterator[Fault]:
    """Ranks do not count 1, 2, 3 in the order of the list."""
    for position, staffing in enumerate(case.staffings, start=1):
        if staffing.alternative.rank != position:
            yield Fault(
                f"the alternative listed as number {position} has rank {staffing.alternative.rank}.",
                found=str(staffing.alternative.rank),
                needed=str(position),
            )


def ranking_unsorted(case: Case) -> Iterator[Fault]:
    """A better alternative stands below a worse one, or ties are not in order of their choices."""
    for above, below in zip(case.staffings, case.staffings[1:], strict=False):
        first, second = above.alternative.utility, below.alternative.utility
        if second > first + 5e-7:
            yield Fault(
                f"alternative {below.alternative.rank} with utility {second:g} stands below one with {first:g}.",
                found=f"{second:.6f}",
                needed=f"at most {first:.6f}",
            )
        elif abs(first - second) <= 5e-7 and choice_key(below) < choice_key(above):
            yield Fault(
                f"alternatives {above.alternative.rank} and {below.alternative.rank} are equal in utility and not in order "
                "of their choices.",
                found=str(choice_key(above)),
                needed=str(choice_key(below)),
            )


def alternative_double(case: Case) -> Iterator[Fault]:
    """One alternative is listed twice."""
    seen: dict[frozenset[tuple[int, int]], int] = {}
    for staffing in case.staffings:
        choices = frozenset(staffing.taken.items())
        if choices in seen:
            yield Fault(f"alternatives {seen[choices]} and {staffing.alternative.rank} are the same.")
        seen.setdefault(choices, staffing.alternative.rank)
