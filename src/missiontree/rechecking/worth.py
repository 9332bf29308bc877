"""Worth: what an alternative is worth, how good every action is, and the order of the list."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from missiontree.mission.alternative import Alternative
from missiontree.mission.grounded import Action
from missiontree.mission.reason import Reason
from missiontree.rechecking.facts import Facts, broken

MILLION = 1_000_000


def utility_is_the_sum(facts: Facts) -> Iterator[Reason]:
    """The utility is the sum of alpha * q - beta * d - gamma * c over the selected leaves, in millionths."""
    weights = facts.brief.weights
    total = 0
    for action in facts.leaves.values():
        one = action.estimate
        worth = weights.alpha * one.quality - weights.beta * one.duration_s - weights.gamma * one.cost
        total += round(worth * MILLION)
    told = round(facts.alternative.utility * MILLION)
    if told != total:
        message = f"the utility of rank {facts.alternative.rank} is {told / MILLION}, its actions add up to {total / MILLION}."
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


def ranks_in_order(alternatives: Sequence[Alternative]) -> Iterator[Reason]:
    """Ranks count from 1; the better stands first, and of two that are equal the one with the earlier choices."""
    for place, one in enumerate(alternatives, start=1):
        if one.rank != place:
            yield broken("core_ranks", f"the alternative in place {place} has rank {one.rank}.")
    keys = [(-round(one.utility * MILLION), [choice.child for choice in one.choices]) for one in alternatives]
    for place in range(1, len(keys)):
        if not keys[place - 1] < keys[place]:
            message = f"the alternatives in places {place} and {place + 1} are alike or stand in the wrong order."
            yield broken("core_ranks", message)
