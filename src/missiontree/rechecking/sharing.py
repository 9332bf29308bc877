"""Sharing: lifts, doors and the like are held by no more robots at a time than they have room for."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.mission.reason import Reason
from missiontree.mission.schedule import OwnLeg, TravelLeg
from missiontree.rechecking.facts import TICK_MS, Facts, broken, milliseconds

Span = tuple[int, int]


def shared_resources(facts: Facts) -> Iterator[Reason]:
    """At the start of each action or way that holds a resource, those under way that hold it, too, are no more than its capacity."""
    for resource in facts.world.resources:
        spans = _spans(facts, resource.id)
        for number, (moment, until) in enumerate(spans):
            instant = until == moment
            count = 1
            for other, (start, end) in enumerate(spans):
                lasts = end > moment + TICK_MS
                began = start + TICK_MS < moment if instant else start <= moment
                if other != number and began and lasts and (instant or until > moment + TICK_MS):
                    count += 1
            if count > resource.capacity:
                message = f"{resource.id} is held by {count} robots at {moment / 1000} s, and has room for {resource.capacity}."
                yield broken("core_shared", message, node=resource.id)


def _spans(facts: Facts, resource: str) -> list[Span]:
    """From when to when each robot holds a resource, in an action that names it or on a way that it lies on."""
    spans: list[Span] = []
    for leaf, action in facts.leaves.items():
        if resource in action.holds:
            spans.append((facts.start_ms[leaf], facts.end_ms[leaf]))
    if facts.schedule is None:
        return spans
    for leg in facts.schedule.legs:
        action_of = facts.leaves.get(leg.leaf)
        counted = action_of is not None and action_of.moves and resource in action_of.holds
        if not counted and _lies_on(facts, resource, leg):
            spans.append((milliseconds(leg.start_s), milliseconds(leg.end_s)))
    for own in [*facts.schedule.returns, *(visit.leg for visit in facts.schedule.recharges)]:
        if own is not None and _lies_on(facts, resource, own):
            spans.append((milliseconds(own.start_s), milliseconds(own.end_s)))
    return spans


def _lies_on(facts: Facts, resource: str, leg: TravelLeg | OwnLeg) -> bool:
    """Whether a way names, one after the other, two nodes that a road or lift with the resource joins."""
    roads = facts.world.roads
    if roads is None:
        return False
    joined = [set(road.ends) for road in roads.roads if road.resource == resource]
    stops = [set(lift.stops) for lift in roads.lifts if lift.resource == resource]
    for place in range(1, len(leg.via)):
        pair = {leg.via[place - 1], leg.via[place]}
        if pair in joined or (len(pair) == 2 and any(pair <= every for every in stops)):
            return True
    return False
