"""Sharing: lifts, doors and the like are held by no more robots at a time than they have room for."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.mission.reason import Reason
from missiontree.rechecking.facts import TICK_MS, Facts, broken


def shared_resources(facts: Facts) -> Iterator[Reason]:
    """At the start of each action that holds a resource, the actions under way that hold it, too, are no more than its capacity."""
    for resource in facts.world.resources:
        holding = [leaf for leaf, action in facts.leaves.items() if resource.id in action.holds]
        for leaf in holding:
            moment = facts.start_ms[leaf]
            instant = facts.end_ms[leaf] == moment
            count = 1
            for other in holding:
                lasts = facts.end_ms[other] > moment + TICK_MS
                began = facts.start_ms[other] + TICK_MS < moment if instant else facts.start_ms[other] <= moment
                if other != leaf and began and lasts and (instant or facts.end_ms[leaf] > moment + TICK_MS):
                    count += 1
            if count > resource.capacity:
                message = f"{resource.id} is held by {count} robots at {moment / 1000} s, and has room for {resource.capacity}."
                yield broken(
                    "core_shared", message, node=leaf, robot=facts.robot_of_role.get(facts.leaves[leaf].role, "")
                )
