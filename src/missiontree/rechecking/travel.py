"""Travel: a robot needs the time to come from where it was, no faster than it is, and no shorter than the world allows."""

from __future__ import annotations

import math
from collections.abc import Iterator

from missiontree.mission.position import Position
from missiontree.mission.reason import Reason
from missiontree.mission.schedule import TravelLeg
from missiontree.rechecking.facts import TICK_MS, Facts, fault, milliseconds
from missiontree.rechecking.places import NEAR_M, place_at, same_place, start_of
from missiontree.rechecking.shortest import least_m, least_s, only_straight

RULE = "core_travel"


def legs_belong(facts: Facts) -> Iterator[Reason]:
    """A leg is travelled for a selected action, by the robot that does it, and once."""
    seen = set()
    for leg in facts.schedule.legs if facts.schedule is not None else ():
        doer = facts.robot_of_role.get(facts.leaves[leg.leaf].role) if leg.leaf in facts.leaves else None
        if doer != leg.robot or leg.leaf in seen:
            message = f"{leg.robot} travels for action {leg.leaf}, which is not its own, or was travelled for before."
            yield fault(RULE, message, node=leg.leaf, robot=leg.robot)
        seen.add(leg.leaf)


def robots_come_from_where_they_were(facts: Facts) -> Iterator[Reason]:
    """Step by step along each robot's actions: where it is, where the action is, and how it comes there."""
    legs = {leg.leaf: leg for leg in facts.schedule.legs} if facts.schedule is not None else {}
    for robot, roles in facts.roles_of_robot.items():
        here = start_of(facts, robot)
        free_ms = 0
        for leaf in [leaf for role in roles for leaf in facts.leaves_of_role[role]]:
            action = facts.leaves[leaf]
            there = place_at(facts, action.at, facts.start_ms[leaf])
            leg = legs.get(leaf)
            if leg is not None:
                yield from _leg_joins(facts, leg, here, there, free_ms)
            elif here is not None and there is not None and not same_place(here, there) and _speed(facts, leaf):
                message = f"{robot} is at {_shown(here)}; {facts.label(leaf)} is at {_shown(there)}, and no travel is planned."
                yield fault(RULE, message, node=leaf, robot=robot)
            if action.at is not None:
                here = there
            free_ms = facts.end_ms[leaf]


def _leg_joins(
    facts: Facts, leg: TravelLeg, here: Position | None, there: Position | None, free_ms: int
) -> Iterator[Reason]:
    """A leg starts where the robot is and ends at the action, between what the robot did before and the action."""

    def wrong(message: str) -> Reason:
        return fault(RULE, message, node=leg.leaf, robot=leg.robot)

    start, end = milliseconds(leg.start_s), milliseconds(leg.end_s)
    if here is None or not same_place(leg.origin, here):
        yield wrong(
            f"{leg.robot} sets out from {_shown(leg.origin)} and is {'at ' + _shown(here) if here else 'nowhere known'}."
        )
    if there is None or not same_place(leg.destination, there):
        yield wrong(f"{leg.robot} travels to {_shown(leg.destination)}, and {facts.label(leg.leaf)} is elsewhere.")
    if facts.leaves[leg.leaf].moves:
        if abs(start - facts.start_ms[leg.leaf]) > TICK_MS or abs(end - facts.end_ms[leg.leaf]) > TICK_MS:
            yield wrong(f"{facts.label(leg.leaf)} is a move, and has not the time of its own travel.")
    elif start + TICK_MS < free_ms or end > facts.start_ms[leg.leaf] + TICK_MS:
        yield wrong(f"the travel to {facts.label(leg.leaf)} overlaps it, or what {leg.robot} does before.")


def no_faster_than_it_is(facts: Facts) -> Iterator[Reason]:
    """A leg is as long as the world makes it, and takes the robot at least as long as its speed says."""
    for leg in facts.schedule.legs if facts.schedule is not None else ():
        if leg.leaf not in facts.leaves:
            continue
        straight = least_m(facts.world, leg.origin, leg.destination)
        exact = only_straight(facts.world)
        if leg.distance_m < straight - NEAR_M or (exact and leg.distance_m > straight + NEAR_M):
            message = f"the way to {facts.label(leg.leaf)} is {leg.distance_m} m long; it is {'' if exact else 'at least '}{straight} m."
            yield fault(RULE, message, node=leg.leaf, robot=leg.robot)
        if leg.origin.floor != leg.destination.floor and not (facts.world.roads and facts.world.roads.lifts):
            message = (
                f"{leg.robot} travels from floor {leg.origin.floor} to {leg.destination.floor}, and there is no lift."
            )
            yield fault(RULE, message, node=leg.leaf, robot=leg.robot)
        speed = _speed(facts, leg.leaf)
        lasts = milliseconds(leg.end_s) - milliseconds(leg.start_s)
        needed = _needed_ms(facts, leg, speed) if speed else 0
        if lasts + TICK_MS < needed:
            message = f"{leg.robot} travels {leg.distance_m} m in {lasts / 1000} s; at {speed} m/s it takes {needed / 1000} s."
            yield fault(RULE, message, node=leg.leaf, robot=leg.robot)


def _needed_ms(facts: Facts, leg: TravelLeg, speed: float) -> int:
    ride_s = least_s(facts.world, leg.origin, leg.destination)
    return math.ceil(round((leg.distance_m / speed + ride_s) * 1000, 6))


def moves_are_their_travel(facts: Facts) -> Iterator[Reason]:
    """A move lasts as long as its travel; where no way is known, as long as its routine says. Joint moves: as the longest."""
    legs = {leg.leaf: leg for leg in facts.schedule.legs} if facts.schedule is not None else {}
    lifts = facts.world.roads is not None and facts.world.roads.lifts
    for leaf, action in facts.leaves.items():
        if not action.moves:
            continue
        needed = 0
        for one in facts.together(leaf):
            speed = _speed(facts, one)
            if facts.leaves[one].moves and one in legs and speed:
                needed = max(needed, _needed_ms(facts, legs[one], speed))
            else:
                needed = max(needed, math.ceil(round(facts.leaves[one].duration_s * 1000, 6)))
        lasts = facts.end_ms[leaf] - facts.start_ms[leaf]
        if lasts + TICK_MS < needed or (lasts > needed + TICK_MS and not lifts):
            message = f"{facts.label(leaf)} lasts {lasts / 1000} s, and its way takes {needed / 1000} s."
            yield fault(RULE, message, node=leaf, robot=facts.robot_of_role.get(action.role, ""))


def _speed(facts: Facts, leaf: int) -> float | None:
    """Speed at which a robot travels for an action: its own, that of what it brings, the slowest where they move together."""
    known: list[float | None] = []
    for one in facts.together(leaf) if facts.leaves[leaf].moves else [leaf]:
        action = facts.leaves[one]
        if not action.moves and one != leaf:
            continue
        kind = facts.brief.fleet.by_id.get(action.robot_type)
        known.append(kind.limits.get("max_speed_mps") if kind is not None else None)
        for entity in action.brings:
            brought = facts.world.by_id.get(entity)
            known.append(brought.max_speed_mps if brought is not None else None)
    return min((speed for speed in known if speed is not None), default=None)


def _shown(where: Position) -> str:
    return f"({where.x_m:g}, {where.y_m:g}) on {where.floor}"


TRAVEL_RULES = (legs_belong, robots_come_from_where_they_were, no_faster_than_it_is, moves_are_their_travel)
