"""Are utilities what the actions give, and ranks in order?"""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction

from missiontree.checking.case import Case
from missiontree.checking.fault import Fault
from missiontree.checking.staffing import Staffing
from missiontree.mission.brief import MissionBrief
from missiontree.mission.estimate import Estimate, Weights

MILLION = 1_000_000


def millionths(weights: Weights, estimate: Estimate) -> float:
    """Utility of one action in whole millionths: alpha * q - beta * d - gamma * c, rounded half to even."""
    value = weights.alpha * estimate.quality - weights.beta * estimate.duration_s - weights.gamma * estimate.cost
    return float(round(value * MILLION)) if math.isfinite(value * MILLION) else value


def utility_of(staffing: Staffing, brief: MissionBrief) -> Fraction | float:
    """Utility of an alternative in millionths: what its selected actions add up to, their mean, or the least of them; 0 of none."""
    counted = [millionths(brief.weights, action.estimate) for action in staffing.actions.values()] or [0.0]
    if not all(map(math.isfinite, counted)):
        return sum(counted)
    if brief.accumulate == "min":
        return Fraction(min(counted))
    total = Fraction(sum(map(int, counted)))  # each is a whole number
    return total / len(counted) if brief.accumulate == "mean" else total


def team_of(staffing: Staffing) -> frozenset[str]:
    """Robot types that take part."""
    return frozenset(staffing.type_of_role.values())


def choice_key(staffing: Staffing) -> tuple[int, ...]:
    """Positions of the children taken among their siblings, in preorder."""
    children = staffing.tree.children
    return tuple(
        children[node].index(staffing.taken[node])
        for node in staffing.reached
        if staffing.tree.nodes[node].kind == "xor" and node in staffing.taken
    )


def utility_wrong(case: Case) -> Iterator[Fault]:
    """The utility is not the sum over the selected actions; or not their mean, or the least of them, where the mission asks for that."""
    for staffing in case.staffings:
        needed = float(utility_of(staffing, case.plan.brief) / MILLION)
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
        elif abs(first - second) <= 5e-7 and _stands_before(below, above, case.plan.brief):
            yield Fault(
                f"alternatives {above.alternative.rank} and {below.alternative.rank} are equal in utility and not in order "
                "of their choices.",
                found=str(choice_key(above)),
                needed=str(choice_key(below)),
            )


def _stands_before(one: Staffing, other: Staffing, brief: MissionBrief) -> bool:
    """Whether one is truly better, be it by less than a utility shows; or as good, and first in the order of choices."""
    first, second = utility_of(one, brief), utility_of(other, brief)
    return first > second or (first == second and choice_key(one) < choice_key(other))


def team_repeated(case: Case) -> Iterator[Fault]:
    """Teams are to differ, and the same robot types take part in two alternatives."""
    seen: dict[frozenset[str], int] = {}
    for staffing in case.staffings if case.plan.brief.diverse else ():
        team, rank = team_of(staffing), staffing.alternative.rank
        if team in seen:
            types = ", ".join(sorted(team)) or "nobody"
            yield Fault(
                f"alternatives {seen[team]} and {rank} have the same team ({types}), and the mission asks for teams that differ.",
                found=types,
                needed="a set of robot types that no alternative above has",
            )
        seen.setdefault(team, rank)


def alternative_double(case: Case) -> Iterator[Fault]:
    """One alternative is listed twice."""
    seen: dict[frozenset[tuple[int, int]], int] = {}
    for staffing in case.staffings:
        choices = frozenset(staffing.taken.items())
        if choices in seen:
            yield Fault(f"alternatives {seen[choices]} and {staffing.alternative.rank} are the same.")
        seen.setdefault(choices, staffing.alternative.rank)
