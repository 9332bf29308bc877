"""Travel: a robot needs the time to come from where it was, no faster than it is, and no shorter than the world allows."""

from __future__ import annotations

import math
from collections.abc import Iterator

from missiontree.mission.position import Position
from missiontree.mission.reason import Reason
from missiontree.mission.schedule import TravelLeg
from missiontree.rechecking.facts import TICK_MS, Facts, Places, broken, milliseconds
from missiontree.rechecking.places import NEAR_M, apart, may_be_at, places_of
from missiontree.rechecking.walks import walk

RULE = "core_travel"


def legs_belong(facts: Facts) -> Iterator[Reason]:
    """A leg is travelled for a selected action, by the robot that does it, and once."""
    seen = set()
    for leg in facts.schedule.legs if facts.schedule is not None else ():
        doer = facts.robot_of_role.get(facts.leaves[leg.leaf].role) if leg.leaf in facts.leaves else None
        if doer != leg.robot or leg.leaf in seen:
            message = f"{leg.robot} travels for action {leg.leaf}, which is not its own, or was travelled for before."
            yield broken(RULE, message, node=leg.leaf, robot=leg.robot)
        seen.add(leg.leaf)


def robots_come_from_where_they_were(facts: Facts) -> Iterator[Reason]:
    """Step by step along each robot's actions: where it is, where the action is, and how it comes there."""
    legs = {leg.leaf: leg for leg in facts.schedule.legs} if facts.schedule is not None else {}
    for robot in facts.roles_of_robot:
        for step, here, free_ms in walk(facts, robot):
            if not isinstance(step, int):
                continue
            there, leg = places_of(facts, step), legs.get(step)
            if leg is not None:
                yield from _leg_joins(facts, leg, here, there, free_ms)
            elif apart(here, there):
                message = (
                    f"{robot} is at {_any(here)}; {facts.label(step)} is at {_any(there)}, and no travel is planned."
                )
                yield broken(RULE, message, node=step, robot=robot)


def _leg_joins(facts: Facts, leg: TravelLeg, here: Places, there: Places, free_ms: int) -> Iterator[Reason]:
    """A leg starts where the robot is and ends at the action, between what the robot did before and the action."""

    def wrong(message: str) -> Reason:
        return broken(RULE, message, node=leg.leaf, robot=leg.robot)

    start, end = milliseconds(leg.start_s), milliseconds(leg.end_s)
    if not may_be_at(here, leg.origin):
        yield wrong(f"{leg.robot} sets out from {_shown(leg.origin)} and is at {_any(here)}.")
    if not may_be_at(there, leg.destination):
        yield wrong(f"{leg.robot} travels to {_shown(leg.destination)}, and {facts.label(leg.leaf)} is elsewhere.")
    if end < start:
        yield wrong(f"the travel to {facts.label(leg.leaf)} ends before it starts.")
    if facts.leaves[leg.leaf].moves:
        if abs(start - facts.start_ms[leg.leaf]) > TICK_MS or abs(end - facts.end_ms[leg.leaf]) > TICK_MS:
            yield wrong(f"{facts.label(leg.leaf)} is a move, and has not the time of its own travel.")
    elif start + TICK_MS < free_ms or end > facts.start_ms[leg.leaf] + TICK_MS:
        yield wrong(f"the travel to {facts.label(leg.leaf)} overlaps it, or what {leg.robot} does before.")


def no_faster_than_it_is(facts: Facts) -> Iterator[Reason]:
    """A leg leads where a way leads, is no shorter than the world allows, and takes the robot as long as its speed says at least."""
    for leg in facts.schedule.legs if facts.schedule is not None else ():
        kind = facts.brief.fleet.type_of.get(leg.robot)
        if leg.leaf not in facts.leaves or kind is None:
            continue
        speed = _speed(facts, leg.leaf)
        metres = max(facts.ways.least(kind, leg.origin, leg.destination), facts.ways.named(kind, leg))
        if leg.distance_m < metres - NEAR_M:
            message = f"the way to {facts.label(leg.leaf)} is {metres:g} m long at least, and is said to be {leg.distance_m:g} m."
            yield broken(RULE, message, node=leg.leaf, robot=leg.robot)
        elif speed is not None:
            ways = facts.ways.least(kind, leg.origin, leg.destination, speed), facts.ways.named(kind, leg, speed)
            seconds = max(leg.distance_m / speed, *ways)
            lasts, needed = milliseconds(leg.end_s) - milliseconds(leg.start_s), math.ceil(round(seconds * 1000, 6))
            if lasts + TICK_MS < needed:
                message = f"{leg.robot} travels {leg.distance_m:g} m in {lasts / 1000} s; it takes {needed / 1000} s at least."
                yield broken(RULE, message, node=leg.leaf, robot=leg.robot)


def blind_moves_take_their_time(facts: Facts) -> Iterator[Reason]:
    """A move with no way that is known, or no speed, takes what its routine says. Joint work with such a move: no less."""
    legs = {leg.leaf for leg in facts.schedule.legs} if facts.schedule is not None else set()
    for leaf, action in facts.leaves.items():
        if not action.moves or (leaf in legs and _speed(facts, leaf) is not None):
            continue
        needed = math.ceil(round(action.duration_s * 1000, 6))
        lasts = facts.end_ms[leaf] - facts.start_ms[leaf]
        if lasts + TICK_MS < needed:
            message = (
                f"{facts.label(leaf)} lasts {lasts / 1000} s; its way is not known, so it takes {needed / 1000} s."
            )
            yield broken(RULE, message, node=leaf, robot=facts.robot_of_role.get(action.role, ""))


def _speed(facts: Facts, leaf: int) -> float | None:
    """Speed at which a robot travels for an action: its own, or that of what it brings if that is slower; None if its own is unknown."""
    action = facts.leaves[leaf]
    kind = facts.brief.fleet.by_id.get(action.robot_type)
    own = kind.limits.get("max_speed_mps") if kind is not None else None
    if own is None:
        return None
    brought = [facts.world.by_id[entity].max_speed_mps for entity in action.brings if entity in facts.world.by_id]
    return min([own, *(speed for speed in brought if speed is not None)])


def _any(places: Places) -> str:
    return " or ".join("no known place" if place is None else _shown(place) for place in places)


def _shown(where: Position) -> str:
    return f"({where.x_m:g}, {where.y_m:g}) on {where.floor}"


TRAVEL_RULES = (legs_belong, robots_come_from_where_they_were, no_faster_than_it_is, blind_moves_take_their_time)
