"""A way that a robot travels for its own sake: from where it is to where it must be, in time, and no faster than it is."""

from __future__ import annotations

import math
from collections.abc import Iterator

from missiontree.mission.position import Position
from missiontree.mission.reason import Reason
from missiontree.mission.schedule import OwnLeg
from missiontree.rechecking.facts import TICK_MS, Facts, Places, broken, milliseconds
from missiontree.rechecking.places import NEAR_M, may_be_at


def leads(facts: Facts, leg: OwnLeg, rule: str, ends: tuple[Places, Position | None], free_ms: int) -> Iterator[Reason]:
    """What is wrong with a way from where a robot may be to where it must be, set out on when the robot is free."""
    here, there = ends
    start, end = milliseconds(leg.start_s), milliseconds(leg.end_s)
    if not may_be_at(here, leg.origin) or not may_be_at((there,), leg.destination):
        yield broken(rule, f"{leg.robot} sets out from, or gets to, another place than it is to.", robot=leg.robot)
    if start + TICK_MS < free_ms or end < start:
        yield broken(
            rule, f"{leg.robot} sets out at {start / 1000} s, and is free at {free_ms / 1000} s.", robot=leg.robot
        )
    if leg.robot in facts.brief.fleet.type_of:
        yield from _fast(facts, leg, rule, end - start)


def _fast(facts: Facts, leg: OwnLeg, rule: str, lasts: int) -> Iterator[Reason]:
    kind = facts.brief.fleet.type_of[leg.robot]
    metres = max(facts.ways.least(kind, leg.origin, leg.destination), facts.ways.named(kind, leg))
    speed = kind.limits.get("max_speed_mps")
    if leg.distance_m < metres - NEAR_M:
        message = f"the way of {leg.robot} is {metres:g} m long at least, and is said to be {leg.distance_m:g} m."
        yield broken(rule, message, robot=leg.robot)
    elif speed is not None:
        ways = facts.ways.least(kind, leg.origin, leg.destination, speed), facts.ways.named(kind, leg, speed)
        needed = math.ceil(round(max(leg.distance_m / speed, *ways) * 1000, 6))
        if lasts + TICK_MS < needed:
            message = (
                f"{leg.robot} travels {leg.distance_m:g} m in {lasts / 1000} s; it takes {needed / 1000} s at least."
            )
            yield broken(rule, message, robot=leg.robot)
