"""What an alternative uses of limits, against what is allowed."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from missiontree.mission.alternative import Alternative, selected_leaves
from missiontree.mission.fleet import RobotType
from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule
from missiontree.reporting.escape import one_line

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
    at_least
        True if ``used`` is only a lower bound: without a schedule, the travel between roles is not known.
    """

    who: str
    name: str
    used: float
    allowed: float
    at_least: bool

    @property
    def share(self) -> float:
        """Used of allowed; 1 for something of nothing."""
        return self.used / self.allowed if self.allowed > 0 else float(self.used > 0)


def limits_of(plan: Plan, alternative: Alternative, schedule: Schedule | None) -> tuple[LimitUse, ...]:
    """
    Limits that an alternative uses, in the order of the fleet, and at last those of the whole mission.

    By its schedule, if it has one: what its robots do and every metre they travel. Else by the witness of allocation, robot by robot. Else
    all robots of a type together, against the sum of what they have. Limits that nothing uses are left out.

    Parameters
    ----------
    plan, alternative
        What is told of.
    schedule
        Its schedule; None if it has none.
    """
    if schedule is not None:
        used = _scheduled(plan, schedule)
        return (*_by_robot(plan, used, at_least=False), *_of_mission(plan, used, at_least=False))
    robots = {assignment.role: assignment.robot for assignment in alternative.witness}
    used = _promised(plan, alternative, robots)
    told = _by_robot(plan, used, at_least=True) if robots else _by_type(plan, used)
    return (*told, *_of_mission(plan, used, at_least=True))


def _scheduled(plan: Plan, schedule: Schedule) -> Use:
    assert plan.grounding is not None
    used: dict[tuple[str, str], float] = defaultdict(float)
    for one in schedule.actions:
        for name, amount in plan.grounding.tree.action(one.leaf).uses.items():
            used[one.robot, name] += amount
    for leg in schedule.legs:
        kind = plan.brief.fleet.type_of.get(leg.robot)
        for name, per_m in kind.uses_per_m.items() if kind is not None else ():
            used[leg.robot, name] += per_m * leg.distance_m
    return used


def _promised(plan: Plan, alternative: Alternative, robots: Mapping[int, str]) -> Use:
    """What is used whatever the schedule, by robot if roles have one, else by type."""
    assert plan.grounding is not None
    used: dict[tuple[str, str], float] = defaultdict(float)
    for leaf in selected_leaves(plan.grounding.tree, alternative.choices):
        action = plan.grounding.tree.action(leaf)
        for name, amount in (action.uses_at_least or action.uses).items():
            used[robots.get(action.role, action.robot_type), name] += amount
    return used


def _by_robot(plan: Plan, used: Use, *, at_least: bool) -> Iterator[LimitUse]:
    busy = {robot for robot, _ in used}
    for kind in plan.brief.fleet.types:
        members = [robot for robot in kind.members if robot.id in busy]
        for robot in members:
            for name in dict.fromkeys((*kind.limits, *robot.remaining)):
                allowed = kind.budget(robot, name)
                if allowed is not None and (amount := used.get((robot.id, name), 0.0)) > 0:
                    yield LimitUse(one_line(robot.id), name, amount, allowed, at_least)
        yield from _totals(
            kind, {name: _sum(used, [robot.id for robot in members], name) for name in kind.total_limits}, at_least
        )


def _by_type(plan: Plan, used: Use) -> Iterator[LimitUse]:
    for kind in plan.brief.fleet.types:
        for name in kind.limits:
            if (amount := used.get((kind.id, name), 0.0)) > 0:
                allowed = sum(kind.budget(robot, name) or 0.0 for robot in kind.members)
                yield LimitUse(_all(kind), name, amount, allowed, at_least=True)
        yield from _totals(kind, {name: used.get((kind.id, name), 0.0) for name in kind.total_limits}, at_least=True)


def _totals(kind: RobotType, used: Mapping[str, float], at_least: bool) -> Iterator[LimitUse]:
    for name, allowed in kind.total_limits.items():
        if used[name] > 0:
            yield LimitUse(_all(kind), name, used[name], allowed, at_least)


def _of_mission(plan: Plan, used: Use, *, at_least: bool) -> Iterator[LimitUse]:
    for who, limits in (
        ("the whole mission", plan.brief.fleet.total_limits),
        ("stock of the scene", plan.brief.world.stock),
    ):
        for name, allowed in limits.items():
            amount = sum(taken for (_, what), taken in used.items() if what == name)
            if amount > 0:
                yield LimitUse(who, name, amount, allowed, at_least)


def _sum(used: Use, robots: Sequence[str], name: str) -> float:
    return sum(used.get((robot, name), 0.0) for robot in robots)


def _all(kind: RobotType) -> str:
    return f"all of {one_line(kind.label)}"
