"""What robots can refill, and how its level goes up and down over a schedule."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from missiontree.checking.case import Case
from missiontree.checking.fault import named
from missiontree.checking.timetable import Timetable
from missiontree.mission.schedule import Recharge


class Level(NamedTuple):
    """How much of a stock a robot has right after something, and what that was."""

    robot: str
    name: str
    amount: float
    full: float
    after: str


def refillable(case: Case, type_id: str) -> frozenset[str]:
    """Limits of a type that some charger refills for it, so that they are no budgets."""
    kind = case.fleet.by_id[type_id]
    return frozenset(
        charger.stock
        for charger in case.scene.chargers
        if charger.stock in kind.limits and (charger.types is None or type_id in charger.types)
    )


def allowance(case: Case, robot: str, name: str) -> float | None:
    """What a robot may use of a budget; None if it has no such limit, or can refill it."""
    kind = case.fleet.type_of[robot]
    return None if name in refillable(case, kind.id) else kind.budget(case.fleet.robots[robot], name)


def levels(case: Case, timetable: Timetable) -> Iterator[Level]:
    """The level of everything that robots can refill, after each way, action and visit to a charger."""
    for robot in timetable.by_robot:
        kind = case.fleet.type_of.get(robot)
        for name in sorted(refillable(case, kind.id)) if kind is not None else ():
            yield from _level(case, timetable, robot, name)


def _level(case: Case, timetable: Timetable, robot: str, name: str) -> Iterator[Level]:
    kind, own = case.fleet.type_of[robot], case.fleet.robots[robot]
    full, per_m = kind.limits[name], kind.uses_per_m.get(name, 0.0)
    amount = own.remaining.get(name, full)
    stock_of = {charger.id: charger.stock for charger in case.scene.chargers}
    for turn in timetable.turns(robot):
        if isinstance(turn, Recharge):
            if turn.leg is not None:
                amount -= per_m * turn.leg.distance_m
                yield Level(robot, name, amount, full, f"its way to the charger {turn.charger}")
            if stock_of.get(turn.charger) == name:
                amount += turn.amount
                yield Level(robot, name, amount, full, f"the charger {turn.charger}")
            continue
        leg = timetable.legs.get((robot, turn.leaf))
        amount -= turn.action.uses.get(name, 0.0) + (per_m * leg.distance_m if leg is not None else 0.0)
        yield Level(robot, name, amount, full, named(timetable.tree, turn.leaf))
    for home in timetable.schedule.returns:
        if home.robot == robot:
            amount -= per_m * home.distance_m
            yield Level(robot, name, amount, full, "its way home")
