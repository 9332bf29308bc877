"""What a robot type can do, and how much: capabilities, their quality, limits."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from missiontree.explaining.case import Case
from missiontree.explaining.changes.editing import put, shown, with_type
from missiontree.explaining.changes.needs import Needs
from missiontree.mission.change import Change
from missiontree.mission.fleet import Capability, RobotType


def candidates(case: Case, needs: Needs) -> Iterator[Change]:
    """Capabilities that a type lacks, qualities below what is asked for, and limits that are compared or used up."""
    for kind in case.brief.fleet.types:
        for name, least in needs.capabilities.items():
            has = kind.capability(name)
            wanted = max(least, _least_asked(case, name))
            if has is None:
                yield Change(kind="add_capability", target=kind.id, name=name, to=max(wanted, _usual(case, name)))
            elif has.quality < wanted:
                yield Change(kind="raise_quality", target=kind.id, name=name, was=has.quality, to=wanted)
        for name in sorted({*needs.at_least, *needs.budgets} & {*kind.limits, *_remaining(kind)}):
            if name not in needs.at_most:
                yield Change(kind="raise_limit", target=kind.id, name=name, was=_least_held(kind, name))
        for name in sorted(needs.at_most.keys() & kind.limits.keys()):
            if name not in needs.at_least and name not in needs.budgets:
                yield Change(kind="lower_limit", target=kind.id, name=name, was=kind.limits[name])


def _least_asked(case: Case, capability: str) -> float:
    """Quality that the mission asks of a capability, whatever the routine."""
    asked = case.brief.min_quality
    if isinstance(asked, float | int):
        return float(asked)
    routines = {node.routine for node in case.tree.nodes if node.routine is not None}
    inner = {part.routine for routine in case.brief.routines.routines for part in routine.parts}
    return max((asked.get(name, 0.0) for name in {capability, *routines, *inner}), default=0.0)


def _usual(case: Case, capability: str) -> float:
    """Quality that a new capability is taken to have: the least that another type has, else 1."""
    known = [has.quality for kind in case.brief.fleet.types if (has := kind.capability(capability)) is not None]
    return min(known, default=1.0)


def _remaining(kind: RobotType) -> set[str]:
    return {name for robot in kind.robots for name in robot.remaining}


def _least_held(kind: RobotType, name: str) -> float:
    held = [budget for robot in kind.members if (budget := kind.budget(robot, name)) is not None]
    return min([*held, *([kind.limits[name]] if name in kind.limits else [])])


def add_capability(case: Case, change: Change) -> Case:
    """A type can do something more, or better."""
    assert change.to is not None, "a capability has a quality"
    quality = change.to

    def able(kind: RobotType) -> RobotType:
        has = kind.capability(change.name)
        better = Capability(quality) if has is None else replace(has, quality=max(has.quality, quality))
        return replace(kind, capabilities={**kind.capabilities, change.name: better})

    return with_type(case, change.target, able)


def add_capability_words(case: Case, change: Change) -> str:
    """As an order."""
    label = case.brief.fleet.by_id[change.target].label
    return f"give {label} the capability {change.name} (taken at quality {shown(change.to)})"


def raise_quality_words(case: Case, change: Change) -> str:
    """As an order."""
    label = case.brief.fleet.by_id[change.target].label
    return f"raise the quality of {change.name} of {label} from {shown(change.was)} to {shown(change.to)}"


def raise_limit(case: Case, change: Change) -> Case:
    """A limit of a type is higher; robots with less of their own are filled up."""
    name, to = change.name, change.to

    def raised(kind: RobotType) -> RobotType:
        limits = dict(kind.limits)
        if name in limits:
            limits = put(limits, name, None if to is None else max(to, limits[name]))
        robots = tuple(
            replace(robot, remaining=put(robot.remaining, name, None if to is None else max(to, robot.remaining[name])))
            if name in robot.remaining
            else robot
            for robot in kind.robots
        )
        return replace(kind, limits=limits, robots=robots)

    return with_type(case, change.target, raised)


def raise_limit_words(case: Case, change: Change) -> str:
    """As an order."""
    label = case.brief.fleet.by_id[change.target].label
    return f"raise {change.name} of {label} from {shown(change.was)} to {shown(change.to)}"


def lower_limit(case: Case, change: Change) -> Case:
    """A limit of a type that is held to be at most something is lower."""
    return with_type(case, change.target, lambda kind: replace(kind, limits=put(kind.limits, change.name, change.to)))


def lower_limit_words(case: Case, change: Change) -> str:
    """As an order."""
    label = case.brief.fleet.by_id[change.target].label
    return f"lower {change.name} of {label} from {shown(change.was)} to {shown(change.to)}"
