"""Refilling: what robots can refill is no budget; its level stays between nothing and full, and chargers have room."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.mission.charger import Charger
from missiontree.mission.reason import Reason
from missiontree.mission.schedule import OwnLeg, Recharge
from missiontree.rechecking.facts import TICK_MS, Facts, broken, milliseconds
from missiontree.rechecking.own_ways import leads
from missiontree.rechecking.places import apart
from missiontree.rechecking.walks import steps, walk

RULE = "core_refill"
LEVEL = "core_level"
LITTLE = 1e-6


def can_refill(facts: Facts, type_id: str) -> set[str]:
    """Limits of a type that a charger of the scene refills for it."""
    limits = facts.brief.fleet.by_id[type_id].limits
    return {one.stock for one in facts.world.chargers if one.stock in limits and _serves(one, type_id)}


def visits_are_possible(facts: Facts) -> Iterator[Reason]:
    """A visit is to a charger that serves the robot's type, gives no more than it can, and has room; the robot has a role."""
    chargers = {one.id: one for one in facts.world.chargers}
    visits = facts.schedule.recharges if facts.schedule is not None else ()
    for visit in visits:
        charger, kind = chargers.get(visit.charger), facts.brief.fleet.type_of.get(visit.robot)
        if charger is None or kind is None or visit.robot not in facts.roles_of_robot:
            yield broken(
                RULE, f"{visit.robot} is at {visit.charger}, and one of them is not to be there.", robot=visit.robot
            )
            continue
        if not _serves(charger, kind.id) or charger.stock not in kind.limits:
            yield broken(RULE, f"{charger.id} does not serve {kind.id}.", robot=visit.robot)
        start, end = milliseconds(visit.start_s), milliseconds(visit.end_s)
        if visit.amount > charger.rate_per_s * (end - start + TICK_MS) / 1000 + LITTLE:
            yield broken(
                RULE, f"{visit.robot} takes in {visit.amount:g} in {(end - start) / 1000} s.", robot=visit.robot
            )
        beside = [one for one in visits if one.charger == charger.id and _spans(one, start)]
        if len(beside) > charger.capacity:
            yield broken(RULE, f"{len(beside)} robots are at {charger.id} at {start / 1000} s.", robot=visit.robot)


def visits_are_made_between_roles(facts: Facts) -> Iterator[Reason]:
    """A robot comes to a charger from where it was, in time, and is in no role while it is there; it goes on from there."""
    for robot in facts.roles_of_robot:
        visits = [step for step in steps(facts, robot) if isinstance(step, Recharge)]
        for number, visit in enumerate(visits):
            start, end = milliseconds(visit.start_s), milliseconds(visit.end_s)
            for role in facts.roles_of_robot[robot]:
                begun, over = facts.hold_of(role)
                if start + TICK_MS < over and begun + TICK_MS < end:
                    yield broken(RULE, f"{robot} refills while role {role} holds it.", robot=robot)
            for leg in facts.schedule.ways if facts.schedule is not None else ():
                off, there = milliseconds(leg.start_s), milliseconds(leg.end_s)
                if leg.robot == robot and start + TICK_MS < there and off + TICK_MS < end:
                    yield broken(RULE, f"{robot} travels while it refills at {visit.charger}.", robot=robot)
            for place, other in enumerate(visits):
                if (
                    place != number
                    and start + TICK_MS < milliseconds(other.end_s)
                    and milliseconds(other.start_s) + TICK_MS < end
                ):
                    yield broken(RULE, f"{robot} refills twice at one time.", robot=robot)
            yield from _comes(facts, visit)


def _comes(facts: Facts, visit: Recharge) -> Iterator[Reason]:
    """The way to a charger."""
    goal = facts.world.charger_spots.get(visit.charger)
    here, free_ms = next(stand[1:] for stand in walk(facts, visit.robot) if stand.step is visit)
    if visit.leg is not None and visit.leg.robot != visit.robot:
        yield broken(
            RULE, f"{visit.robot} refills, and {visit.leg.robot} travels to {visit.charger}.", robot=visit.robot
        )
    elif visit.leg is not None:
        yield from leads(facts, visit.leg, RULE, (here, goal), free_ms)
        if milliseconds(visit.leg.end_s) > milliseconds(visit.start_s) + TICK_MS:
            yield broken(RULE, f"{visit.robot} is not at {visit.charger} when it refills.", robot=visit.robot)
    elif apart(here, (goal,)):
        yield broken(RULE, f"{visit.robot} has no way to {visit.charger}.", robot=visit.robot)


def levels(facts: Facts) -> Iterator[Reason]:
    """Whatever a robot does, it has not less than nothing, and not more than it holds, of what it can refill."""
    stock_of = {one.id: one.stock for one in facts.world.chargers}
    legs = {(leg.robot, leg.leaf): leg for leg in facts.schedule.legs} if facts.schedule is not None else {}
    for robot in facts.roles_of_robot:
        kind = facts.brief.fleet.type_of[robot]
        for name in sorted(can_refill(facts, kind.id)):
            full = kind.limits[name]
            level = facts.brief.fleet.robots[robot].remaining.get(name, full)
            home = [leg for leg in facts.schedule.returns if leg.robot == robot] if facts.schedule is not None else []
            for step in (*steps(facts, robot), *home):
                metres = 0.0
                if isinstance(step, int):
                    leg = legs.get((robot, step))
                    metres = leg.distance_m if leg is not None else 0.0
                    level -= facts.leaves[step].uses.get(name, 0.0)
                elif isinstance(step, OwnLeg):
                    metres = step.distance_m
                elif step.leg is not None:
                    metres = step.leg.distance_m
                level -= kind.uses_per_m.get(name, 0.0) * metres
                low = level
                if isinstance(step, Recharge) and stock_of.get(step.charger) == name:
                    level += step.amount
                if low < -LITTLE or level > full + LITTLE:
                    yield broken(LEVEL, f"{robot} has {min(low, level):g} to {level:g} of {name}.", robot=robot)
                    break


def _serves(charger: Charger, type_id: str) -> bool:
    return charger.types is None or type_id in charger.types


def _spans(visit: Recharge, when_ms: int) -> bool:
    return milliseconds(visit.start_s) <= when_ms and when_ms + TICK_MS < milliseconds(visit.end_s)


REFILL_RULES = (visits_are_possible, visits_are_made_between_roles, levels)
