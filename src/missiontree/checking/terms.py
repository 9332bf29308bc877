"""Does everybody stay out who is left out, and take part who is required, and are no more robots in use than may be?"""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.checking.case import Case
from missiontree.checking.fault import Fault, named


def left_out(case: Case) -> Iterator[Fault]:
    """The tree over the fleet has an action for a robot type that the mission leaves out."""
    out = set(case.plan.brief.without)
    for leaf, node in enumerate(case.tree.nodes if case.tree is not None and out else ()):
        if node.action is not None and node.action.robot_type in out:
            assert case.tree is not None
            yield Fault(
                f"{named(case.tree, leaf)} is for {node.action.robot_type}, which the mission leaves out.",
                node=named(case.tree, leaf),
                robot=node.action.robot_type,
                found=node.action.robot_type,
                needed="another robot type",
            )


def robot_left_out(case: Case) -> Iterator[Fault]:
    """A schedule uses a robot that the mission leaves out."""
    for timetable in case.timetables:
        for robot in sorted(set(timetable.robot_of_role.values())):
            if robot in case.left_out:
                yield Fault(
                    f"schedule {timetable.schedule.rank} uses {robot}, which the mission leaves out.",
                    robot=robot,
                    found=robot,
                    needed="another robot",
                )


def required_idle(case: Case) -> Iterator[Fault]:
    """A robot or a robot type that the mission requires fills no role."""
    for timetable in case.timetables if case.plan.brief.require else ():
        robots = set(timetable.robot_of_role.values())
        types = {case.fleet.type_of[robot].id for robot in robots if robot in case.fleet.type_of}
        for name in case.plan.brief.require:
            if name not in (types if name in case.fleet.by_id else robots):
                yield Fault(
                    f"schedule {timetable.schedule.rank} does without {name}, which the mission requires.",
                    robot=name,
                    found="no role",
                    needed="at least one role",
                )


def max_in_use_exceeded(case: Case) -> Iterator[Fault]:
    """More different robots of a type take part than may be in use."""
    for timetable in case.timetables:
        used: dict[str, set[str]] = {}
        for robot in timetable.robot_of_role.values():
            if robot in case.fleet.type_of:
                used.setdefault(case.fleet.type_of[robot].id, set()).add(robot)
        for type_id, robots in sorted(used.items()):
            most = case.fleet.by_id[type_id].max_in_use
            if most is not None and len(robots) > most:
                yield Fault(
                    f"schedule {timetable.schedule.rank} uses {len(robots)} robots of type {type_id}; at most {most} may be in use.",
                    robot=type_id,
                    found=f"{len(robots)}: {', '.join(sorted(robots))}",
                    needed=f"at most {most}",
                )
