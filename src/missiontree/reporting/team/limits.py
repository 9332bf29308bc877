"""What an alternative uses of limits, against what is allowed."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from missiontree.mission.alternative import Alternative
from missiontree.mission.fleet import RobotType
from missiontree.mission.limit_use import LimitUse as Promised
from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule
from missiontree.reporting.escape import one_line

MISSION, STOCK = "the whole mission", "stock of the scene"
Use = Mapping[tuple[str, str], float]
"""Amounts by robot, or robot type, and name of the limit."""


@dataclass(frozen=True, slots=True)
class LimitUse:
    """
    A limit beside what is used of it.

    Parameters
    ----------
    who
        Robot, all robots of a type together, or the whole mission.
    name
        The limit, its unit in the name.
    used, allowed
        Both in that unit, at least 0.
    refilled
        How much of ``allowed`` is refilled on the way. Default 0.
    at_least
        True if ``used`` is only a lower bound: without a schedule, the travel between roles is not known.
    """

    who: str
    name: str
    used: float
    allowed: float
    at_least: bool
    refilled: float = 0.0

    @property
    def share(self) -> float:
        """Used of allowed; 1 for something of nothing."""
        return self.used / self.allowed if self.allowed > 0 else float(self.used > 0)


def limits_of(plan: Plan, alternative: Alternative, schedule: Schedule | None) -> tuple[LimitUse, ...]:
    """
    Limits that an alternative uses, in the order of the fleet, and at last those of the whole mission.

    By its schedule, if it has one: what its robots do and every metre they travel. Else what allocation knows, which is a lower bound.
    Limits that nothing uses are left out.

    Parameters
    ----------
    plan, alternative
        What is told of.
    schedule
        Its schedule; None if it has none.
    """
    if schedule is not None:
        used = _scheduled(plan, schedule)
        return (*_by_robot(plan, schedule, used), *_of_mission(plan, used))
    return tuple(
        LimitUse(_holder(plan, use), use.name, use.used, use.limit, at_least=True)
        for use in alternative.uses
        if use.used > 0
    )


def _holder(plan: Plan, use: Promised) -> str:
    kind = plan.brief.fleet.by_id.get(use.who)
    if use.whose in {"robots", "type"}:
        return _all(kind) if kind is not None else one_line(use.who)
    return {"mission": MISSION, "stock": STOCK}.get(use.whose, one_line(use.who))


def _scheduled(plan: Plan, schedule: Schedule) -> Use:
    assert plan.grounding is not None
    used: dict[tuple[str, str], float] = defaultdict(float)
    for one in schedule.actions:
        for name, amount in plan.grounding.tree.action(one.leaf).uses.items():
            used[one.robot, name] += amount
    for leg in schedule.ways:
        kind = plan.brief.fleet.type_of.get(leg.robot)
        for name, per_m in kind.uses_per_m.items() if kind is not None else ():
            used[leg.robot, name] += per_m * leg.distance_m
    return used


def _refilled(plan: Plan, schedule: Schedule) -> Use:
    stocks = {charger.id: charger.stock for charger in plan.brief.world.chargers}
    found: dict[tuple[str, str], float] = defaultdict(float)
    for visit in schedule.recharges:
        found[visit.robot, stocks.get(visit.charger, "")] += visit.amount
    return found


def _by_robot(plan: Plan, schedule: Schedule, used: Use) -> Iterator[LimitUse]:
    busy, refilled = {robot for robot, _ in used}, _refilled(plan, schedule)
    for kind in plan.brief.fleet.types:
        members = [robot for robot in kind.members if robot.id in busy]
        for robot in members:
            for name in dict.fromkeys((*kind.limits, *robot.remaining)):
                allowed = kind.budget(robot, name)
                if allowed is not None and (amount := used.get((robot.id, name), 0.0)) > 0:
                    more = refilled.get((robot.id, name), 0.0)
                    yield LimitUse(one_line(robot.id), name, amount, allowed + more, at_least=False, refilled=more)
        yield from _totals(
            kind, {name: _sum(used, [robot.id for robot in members], name) for name in kind.total_limits}
        )


def _totals(kind: RobotType, used: Mapping[str, float]) -> Iterator[LimitUse]:
    for name, allowed in kind.total_limits.items():
        if used[name] > 0:
            yield LimitUse(_all(kind), name, used[name], allowed, at_least=False)


def _of_mission(plan: Plan, used: Use) -> Iterator[LimitUse]:
    for who, limits in (
        (MISSION, plan.brief.fleet.total_limits),
        (STOCK, plan.brief.world.stock),
    ):
        for name, allowed in limits.items():
            amount = sum(taken for (_, what), taken in used.items() if what == name)
            if amount > 0:
                yield LimitUse(who, name, amount, allowed, at_least=False)


def _sum(used: Use, robots: Sequence[str], name: str) -> float:
    return sum(used.get((robot, name), 0.0) for robot in robots)


def _all(kind: RobotType) -> str:
    return f"all of {one_line(kind.label)}"
