"""Does every robot do one thing at a time, and stay in a role until the role is done?"""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.checking.case import Case
from missiontree.checking.clock import TOLERANCE, shown
from missiontree.checking.fault import Fault, named, role_named
from missiontree.checking.timetable import Timetable


def robot_overlap(case: Case) -> Iterator[Fault]:
    """A robot does two actions of different roles at one time."""
    for timetable in case.timetables:
        for robot, deeds in timetable.by_robot.items():
            latest = None
            for deed in deeds:
                if (
                    latest is not None
                    and latest.action.role != deed.action.role
                    and deed.start < latest.end - TOLERANCE
                ):
                    yield Fault(
                        f"schedule {timetable.schedule.rank}: {robot} starts {named(timetable.tree, deed.leaf)} at "
                        f"{shown(deed.start)} while it does {named(timetable.tree, latest.leaf)} until {shown(latest.end)}.",
                        node=named(timetable.tree, deed.leaf),
                        robot=robot,
                        found=shown(deed.start),
                        needed=f"at least {shown(latest.end)}",
                    )
                if latest is None or deed.end >= latest.end:
                    latest = deed


def holding_broken(case: Case) -> Iterator[Fault]:
    """A robot does something of another role between the first and the last action of a role."""
    for timetable in case.timetables:
        for robot, spans in _spans(timetable).items():
            held = spans[0]
            for start, end, role in spans[1:]:
                if start < held[1] - TOLERANCE:
                    yield Fault(
                        f"schedule {timetable.schedule.rank}: {robot} is held by {role_named(timetable.tree, held[2])} until "
                        f"{shown(held[1])} and takes up {role_named(timetable.tree, role)} at {shown(start)}.",
                        node=role_named(timetable.tree, role),
                        robot=robot,
                        found=shown(start),
                        needed=f"at least {shown(held[1])}",
                    )
                if end >= held[1]:
                    held = (start, end, role)


def _spans(timetable: Timetable) -> dict[str, list[tuple[int, int, int]]]:
    """First start, last end and index of every role, by the robot that does it, in order of time."""
    spans: dict[str, list[tuple[int, int, int]]] = {}
    for role, deeds in timetable.by_role.items():
        for robot in dict.fromkeys(deed.robot for deed in deeds):
            own = [deed for deed in deeds if deed.robot == robot]
            span = (min(deed.start for deed in own), max(deed.end for deed in own), role)
            spans.setdefault(robot, []).append(span)
    return {robot: sorted(own) for robot, own in sorted(spans.items())}
