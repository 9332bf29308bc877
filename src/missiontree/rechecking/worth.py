"""Worth: what an alternative is worth, how good every action is, and the order of the list."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise

from missiontree.mission.aim import Accumulate
from missiontree.mission.alternative import Alternative
from missiontree.mission.grounded import Action
from missiontree.mission.reason import Reason
from missiontree.rechecking.facts import Facts, broken

MILLION = 1_000_000


def utility_is_the_sum(facts: Facts) -> Iterator[Reason]:
    """
    The utility is the sum of alpha * q - beta * d - gamma * c over the selected leaves, in millionths.

    Where the mission asks for it, it is their mean, rounded, or the least of them.
    """
    weights = facts.brief.weights
    counted = []
    for action in facts.leaves.values():
        one = action.estimate
        worth = weights.alpha * one.quality - weights.beta * one.duration_s - weights.gamma * one.cost
        counted.append(round(worth * MILLION))
    told, right = round(facts.alternative.utility * MILLION), sum(counted)
    if facts.brief.accumulate == "min":
        right = min(counted, default=0)
    elif facts.brief.accumulate == "mean" and counted:
        if 2 * abs(told * len(counted) - right) <= len(counted):
            return
        right = round(Fraction(right, len(counted)))
    if told != right:
        message = (
            f"the utility of rank {facts.alternative.rank} is {told / MILLION}, its actions give {right / MILLION}."
        )
        yield broken("core_utility", message)


def quality_is_the_types(facts: Facts) -> Iterator[Reason]:
    """Every action has the quality that its type has in the capability that rates it, or what a user's own estimator says of it."""
    for leaf, action in facts.offered.items():
        kind = facts.brief.fleet.by_id.get(action.robot_type)
        ability = kind.capability(action.capability) if kind is not None else None
        if ability is None:
            message = f"{facts.label(leaf)} is rated by {action.capability}, which {action.robot_type} does not have."
            yield broken("core_quality", message, node=leaf, robot=action.robot_type)
        elif facts.brief.estimator is None and ability.quality != action.estimate.quality:
            message = (
                f"{facts.label(leaf)} has quality {action.estimate.quality}; {action.robot_type} does "
                f"{action.capability} with {ability.quality}."
            )
            yield broken("core_quality", message, node=leaf, robot=action.robot_type)


def good_enough(facts: Facts) -> Iterator[Reason]:
    """Every action is as good as the mission asks."""
    for leaf, action in facts.offered.items():
        least = _least(facts, leaf, action)
        if action.estimate.quality < least:
            message = f"{facts.label(leaf)} has quality {action.estimate.quality}, and the mission asks for {least}."
            yield broken("core_min_quality", message, node=leaf, robot=action.robot_type)


def _least(facts: Facts, leaf: int, action: Action) -> float:
    asked = facts.brief.min_quality
    if not isinstance(asked, Mapping):
        return asked
    names = [action.capability]
    source = facts.tree.nodes[leaf].source
    node = facts.mission.by_id.get(source) if facts.mission is not None and source is not None else None
    if node is not None and node.routine is not None:
        names.append(node.routine)
    return max(asked.get(name, 0.0) for name in names)


def ranks_in_order(alternatives: Sequence[Alternative], accumulate: Accumulate) -> Iterator[Reason]:
    """
    Ranks count from 1; the better stands first, and of two that are equal the one with the earlier choices.

    Means are told rounded, so of two that read alike either may be the better one.
    """
    for place, one in enumerate(alternatives, start=1):
        if one.rank != place:
            yield broken("core_ranks", f"the alternative in place {place} has rank {one.rank}.")
    told = [(-round(one.utility * MILLION), [choice.child for choice in one.choices]) for one in alternatives]
    for place, (above, below) in enumerate(pairwise(told), start=1):
        in_order = above[0] <= below[0] and above != below if accumulate == "mean" else above < below
        if not in_order:
            message = f"the alternatives in places {place} and {place + 1} are alike or stand in the wrong order."
            yield broken("core_ranks", message)


def teams_differ(alternatives: Sequence[Alternative]) -> Iterator[Reason]:
    """No two alternatives let the same robot types take part."""
    teams: dict[frozenset[str], int] = {}
    for one in alternatives:
        team = frozenset(filled.robot_type for filled in one.roles)
        if team in teams:
            yield broken(
                "core_ranks", f"ranks {teams[team]} and {one.rank} have the same team, and teams are to differ."
            )
        teams.setdefault(team, one.rank)
