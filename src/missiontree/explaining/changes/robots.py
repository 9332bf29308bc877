"""More robots: one more of a type, or more of those there are in use."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from missiontree.explaining.case import Case
from missiontree.explaining.changes.editing import with_type
from missiontree.explaining.changes.needs import Needs
from missiontree.mission.change import Change
from missiontree.mission.fleet import Robot, RobotType

MOST_ADDED = 20
"""So many robots are added at most: as many as there are roles at once would do, and no repair is to buy more than that."""


def candidates(case: Case, needs: Needs) -> Iterator[Change]:
    """Robots of every type that can do something that the mission needs, and of every type of which not all may be in use."""
    for kind in case.brief.fleet.types:
        if not needs.capabilities.keys() & kind.capabilities.keys():
            continue
        yield Change(kind="add_robot", target=kind.id, was=len(kind.members))
        if kind.max_in_use is not None and kind.max_in_use < len(kind.members):
            yield Change(kind="raise_in_use", target=kind.id, was=kind.max_in_use)


def add_robot(case: Case, change: Change) -> Case:
    """More robots of a type, where the first of them starts, with all that the type is allowed to use."""

    def grown(kind: RobotType) -> RobotType:
        count = len(kind.members) + MOST_ADDED if change.to is None else int(change.to)
        if not kind.robots:
            return replace(kind, count=count)
        first = kind.robots[0]
        taken = case.brief.fleet.robots.keys()
        names = (f"{kind.id[:50]}-new-{number}" for number in range(1, MOST_ADDED * 2))
        free = [name for name in names if name not in taken][: count - len(kind.robots)]
        new = (Robot(id=name, position=first.position, place=first.place, zone=first.zone) for name in free)
        return replace(kind, robots=(*kind.robots, *new))

    return with_type(case, change.target, grown)


def add_robot_words(case: Case, change: Change) -> str:
    """As an order."""
    number = MOST_ADDED if change.to is None else int(change.to) - int(change.was or 0)
    label = case.brief.fleet.by_id[change.target].label
    return f"add one more {label}" if number == 1 else f"add {number} more robots of type {label}"


def raise_in_use(case: Case, change: Change) -> Case:
    """More robots of a type may take part."""
    most = None if change.to is None else int(change.to)
    return with_type(case, change.target, lambda kind: replace(kind, max_in_use=most))


def raise_in_use_words(case: Case, change: Change) -> str:
    """As an order."""
    label = case.brief.fleet.by_id[change.target].label
    to = "all of them" if change.to is None else f"{change.to:g}"
    return f"let {to} robots of type {label} take part instead of {change.was:g} (max_in_use)"
