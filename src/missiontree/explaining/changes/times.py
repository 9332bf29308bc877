"""Deadlines, release times, and when robots come and leave."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from missiontree.explaining.case import Case
from missiontree.explaining.changes.editing import shown, with_brief, with_node, with_type
from missiontree.explaining.changes.needs import Needs
from missiontree.mission.change import Change
from missiontree.mission.fleet import Robot, RobotType


def candidates(case: Case, needs: Needs) -> Iterator[Change]:
    """Every time that the mission or the fleet states."""
    if case.brief.deadline_s is not None:
        yield Change(kind="extend_deadline", was=case.brief.deadline_s)
    for node in case.tree.nodes:
        if node.deadline_s is not None:
            yield Change(kind="extend_deadline", target=node.id, was=node.deadline_s)
        if node.release_s:
            yield Change(kind="move_release", target=node.id, was=node.release_s)
    for kind in case.brief.fleet.types:
        whoever: tuple[RobotType | Robot, ...] = (kind, *kind.robots)
        for who in whoever:
            if who.available_until_s is not None:
                yield Change(kind="extend_stay", target=who.id, was=who.available_until_s)
            if who.available_from_s:
                yield Change(kind="come_earlier", target=who.id, was=who.available_from_s)


def extend_deadline(case: Case, change: Change) -> Case:
    """More time for a node, or for the mission."""
    if not change.target:
        return with_brief(case, deadline_s=change.to)
    return with_node(case, change.target, deadline_s=change.to)


def extend_deadline_words(case: Case, change: Change) -> str:
    """As an order."""
    more = "" if change.to is None or change.was is None else f", {shown(round(change.to - change.was, 3))} s later"
    what = "the mission" if not change.target else f'"{case.tree.by_id[change.target].label}"'
    return f"move the deadline of {what} from {shown(change.was)} s to {shown(change.to)} s{more}"


def move_release(case: Case, change: Change) -> Case:
    """A node may start earlier."""
    return with_node(case, change.target, release_s=change.to or 0.0)


def move_release_words(case: Case, change: Change) -> str:
    """As an order."""
    label = case.tree.by_id[change.target].label
    return f'let "{label}" start from {shown(change.to or 0.0)} s instead of {shown(change.was)} s'


def extend_stay(case: Case, change: Change) -> Case:
    """A type, or a robot, leaves later."""
    return _at(case, change.target, "available_until_s", change.to)


def extend_stay_words(case: Case, change: Change) -> str:
    """As an order."""
    return f"keep {change.target} until {shown(change.to)} s instead of {shown(change.was)} s (available_until_s)"


def come_earlier(case: Case, change: Change) -> Case:
    """A type, or a robot, comes earlier."""
    return _at(case, change.target, "available_from_s", change.to or 0.0)


def come_earlier_words(case: Case, change: Change) -> str:
    """As an order."""
    return f"have {change.target} from {shown(change.to or 0.0)} s instead of {shown(change.was)} s (available_from_s)"


def _at(case: Case, who: str, name: str, to: float | None) -> Case:
    """A time of a type, or of one of its robots."""
    time: dict[str, Any] = {name: to}

    def moved(kind: RobotType) -> RobotType:
        if kind.id == who:
            return replace(kind, **time)
        return replace(kind, robots=tuple(replace(one, **time) if one.id == who else one for one in kind.robots))

    fleet = case.brief.fleet
    return with_type(case, who if who in fleet.by_id else fleet.type_of[who].id, moved)
