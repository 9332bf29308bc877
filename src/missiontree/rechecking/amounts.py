"""Amounts: what robots use of their budgets, of their type's, of the mission's, and of the stock of the scene."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from missiontree.mission.reason import Reason
from missiontree.rechecking.facts import Facts, broken
from missiontree.rechecking.refilling import can_refill

LITTLE = 1e-6
Used = dict[str, dict[str, list[float]]]  # robot → budget → amounts


def scheduled_amounts(facts: Facts) -> Iterator[Reason]:
    """What the schedule uses, travel included, is there."""
    if facts.schedule is None:
        return
    used: Used = {}
    for leaf, action in facts.leaves.items():
        _add(used, facts.robot_of_role.get(facts.leaves[leaf].role, ""), action.uses)
    for leg in facts.schedule.ways:
        kind = facts.brief.fleet.type_of.get(leg.robot)
        per_m = kind.uses_per_m if kind is not None else {}
        _add(used, leg.robot, {name: amount * leg.distance_m for name, amount in per_m.items()})
    yield from _within(facts, used)


def witnessed_amounts(facts: Facts) -> Iterator[Reason]:
    """What the robots of the witness use whatever happens is there."""
    if not facts.alternative.witness:
        return
    robot_of = {one.role: one.robot for one in facts.alternative.witness}
    used: Used = {}
    for action in facts.leaves.values():
        _add(used, robot_of.get(action.role, ""), action.uses_at_least)
    yield from _within(facts, used)


def least_amounts(facts: Facts) -> Iterator[Reason]:
    """What the types use whatever happens is within the budgets of types and of the mission, and within the stock."""
    by_type: dict[str, dict[str, list[float]]] = {}
    for action in facts.leaves.values():
        _add(by_type, action.robot_type, action.uses_at_least)
    for kind in facts.brief.fleet.types:
        used = by_type.get(kind.id, {})
        for name, limit in kind.total_limits.items():
            yield from _over(
                f"the robots of type {kind.id}", name, used.get(name, []), limit, "core_type_total", kind.id
            )
    yield from _mission(facts, by_type)


def _add(used: Used, who: str, amounts: Mapping[str, float]) -> None:
    for name, amount in amounts.items():
        used.setdefault(who, {}).setdefault(name, []).append(amount)


def _within(facts: Facts, used: Used) -> Iterator[Reason]:
    fleet = facts.brief.fleet
    for robot, amounts in used.items():
        if robot not in fleet.robots:
            continue
        for name, several in amounts.items():
            limit = fleet.type_of[robot].budget(fleet.robots[robot], name)
            if limit is not None and name not in can_refill(facts, fleet.type_of[robot].id):
                yield from _over(robot, name, several, limit, "core_budget", robot)
    for kind in fleet.types:
        for name, limit in kind.total_limits.items():
            several = [amount for robot in kind.members for amount in used.get(robot.id, {}).get(name, [])]
            yield from _over(f"the robots of type {kind.id}", name, several, limit, "core_type_total", kind.id)
    yield from _mission(facts, used)


def _mission(facts: Facts, used: Used) -> Iterator[Reason]:
    for rule, limits in (
        ("core_mission_total", facts.brief.fleet.total_limits),
        ("core_stock", facts.world.stock),
    ):
        for name, limit in limits.items():
            several = [amount for amounts in used.values() for amount in amounts.get(name, [])]
            yield from _over("the mission", name, several, limit, rule, "")


def _over(who: str, name: str, several: list[float], limit: float, rule: str, robot: str) -> Iterator[Reason]:
    total = math.fsum(several)
    if total > limit + LITTLE:
        yield broken(rule, f"{who} uses {total:g} of {name}, and has {limit:g}.", robot=robot)
