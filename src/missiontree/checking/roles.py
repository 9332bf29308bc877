"""Has every reached role one robot type, and one existing robot of that type?"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from missiontree.checking.case import Case
from missiontree.checking.fault import Fault, named, role_named
from missiontree.mission.tree import APART


def role_type_missing(case: Case) -> Iterator[Fault]:
    """A reached role has no robot type in the alternative."""
    for staffing in case.staffings:
        listed = {entry.role for entry in staffing.alternative.roles}
        for role in staffing.leaves_of_role:
            if role not in listed:
                yield Fault(
                    f"alternative {staffing.alternative.rank} names no robot type for {role_named(staffing.tree, role)}.",
                    node=role_named(staffing.tree, role),
                    needed=staffing.type_of_role[role],
                )


def role_type_extra(case: Case) -> Iterator[Fault]:
    """A robot type stands for a role that is not reached, or twice for one."""
    for staffing in case.staffings:
        counts = Counter(entry.role for entry in staffing.alternative.roles)
        for role, count in sorted(counts.items()):
            if count > 1 or role not in staffing.leaves_of_role:
                yield Fault(
                    f"alternative {staffing.alternative.rank} lists {role_named(staffing.tree, role)} {count} times.",
                    node=role_named(staffing.tree, role),
                    found=f"{count} times",
                    needed="once" if role in staffing.leaves_of_role else "not at all: it is not reached",
                )


def role_type_differs(case: Case) -> Iterator[Fault]:
    """The robot type of a role is not the one that its selected actions name."""
    for staffing in case.staffings:
        for entry in staffing.alternative.roles:
            for leaf in staffing.leaves_of_role.get(entry.role, ()):
                needed = staffing.actions[leaf].robot_type
                if entry.robot_type != needed:
                    yield Fault(
                        f"alternative {staffing.alternative.rank} gives {role_named(staffing.tree, entry.role)} to "
                        f"{entry.robot_type}, but {named(staffing.tree, leaf)} is done by {needed}.",
                        node=named(staffing.tree, leaf),
                        robot=entry.robot_type,
                        found=entry.robot_type,
                        needed=needed,
                    )
                    break


def role_order(case: Case) -> Iterator[Fault]:
    """Types or robots of roles are not listed in order of role index."""
    for staffing in case.staffings:
        roles = [entry.role for entry in staffing.alternative.roles]
        if roles != sorted(roles):
            yield Fault(f"the roles of alternative {staffing.alternative.rank} are not listed in order.")
    for timetable in case.timetables:
        roles = [entry.role for entry in timetable.schedule.assignments]
        if roles != sorted(roles):
            yield Fault(f"the assignments of schedule {timetable.schedule.rank} are not listed in order of role.")


def assignment_missing(case: Case) -> Iterator[Fault]:
    """A reached role has no robot."""
    for timetable in case.timetables:
        for role in timetable.staffing.leaves_of_role:
            if role not in timetable.robot_of_role:
                yield Fault(
                    f"schedule {timetable.schedule.rank} assigns no robot to {role_named(timetable.tree, role)}.",
                    node=role_named(timetable.tree, role),
                    needed=timetable.staffing.type_of_role[role],
                )


def assignment_extra(case: Case) -> Iterator[Fault]:
    """A robot is assigned to a role that is not reached, or a role has two assignments."""
    for timetable in case.timetables:
        counts = Counter(entry.role for entry in timetable.schedule.assignments)
        for role, count in sorted(counts.items()):
            if count > 1 or role not in timetable.staffing.leaves_of_role:
                yield Fault(
                    f"schedule {timetable.schedule.rank} assigns {role_named(timetable.tree, role)} {count} times.",
                    node=role_named(timetable.tree, role),
                    found=f"{count} times",
                    needed="once" if role in timetable.staffing.leaves_of_role else "not at all: it is not reached",
                )


def robot_unknown(case: Case) -> Iterator[Fault]:
    """A robot is named that the fleet does not have."""
    for timetable in case.timetables:
        schedule = timetable.schedule
        names = {entry.robot for entry in schedule.assignments}
        names |= {done.robot for done in schedule.actions} | {leg.robot for leg in schedule.legs}
        for robot in sorted(names - case.fleet.robots.keys()):
            yield Fault(
                f"schedule {schedule.rank} uses robot {robot!r}, which the fleet does not have.",
                robot=robot,
                found=robot,
            )


def robot_type_wrong(case: Case) -> Iterator[Fault]:
    """The robot of a role is of another type than the role's."""
    for timetable in case.timetables:
        for role, robot in timetable.robot_of_role.items():
            needed = timetable.staffing.type_of_role[role]
            kind = case.fleet.type_of.get(robot)
            if kind is not None and kind.id != needed:
                yield Fault(
                    f"schedule {timetable.schedule.rank} assigns {role_named(timetable.tree, role)} to {robot}, "
                    f"a {kind.id}; it is a part for a {needed}.",
                    node=role_named(timetable.tree, role),
                    robot=robot,
                    found=kind.id,
                    needed=needed,
                )


def action_robot_differs(case: Case) -> Iterator[Fault]:
    """An action is done by another robot than the one assigned to its role."""
    for timetable in case.timetables:
        for deed in timetable.deeds.values():
            needed = timetable.robot_of_role.get(deed.action.role)
            if needed is not None and deed.robot != needed:
                yield Fault(
                    f"schedule {timetable.schedule.rank} lets {deed.robot} do {named(timetable.tree, deed.leaf)}; "
                    f"its role is filled by {needed}.",
                    node=named(timetable.tree, deed.leaf),
                    robot=deed.robot,
                    found=deed.robot,
                    needed=needed,
                )


def team_shares_robot(case: Case) -> Iterator[Fault]:
    """Two roles of one team are filled by one robot."""
    for timetable in case.timetables:
        for roles in timetable.staffing.teams.values():
            holders: dict[str, int] = {}
            for role in roles:
                robot = timetable.robot_of_role.get(role)
                if robot is not None and holders.setdefault(robot, role) != role:
                    yield Fault(
                        f"schedule {timetable.schedule.rank} lets {robot} fill both {role_named(timetable.tree, holders[robot])} "
                        f"and {role_named(timetable.tree, role)}, which need different robots.",
                        node=role_named(timetable.tree, role),
                        robot=robot,
                    )


def same_robot_broken(case: Case) -> Iterator[Fault]:
    """A same-robot link is kept by several robots."""
    for timetable in case.timetables:
        for bond in timetable.staffing.bonds:
            if bond.kind == "same_robot":
                roles = timetable.staffing.roles_below(bond.first_leaves + bond.second_leaves)
                robots = sorted({timetable.robot_of_role[role] for role in roles if role in timetable.robot_of_role})
                if len(robots) > 1:
                    yield Fault(
                        f"schedule {timetable.schedule.rank}: {named(timetable.tree, bond.first)} and "
                        f"{named(timetable.tree, bond.second)} are linked to one robot and use {', '.join(robots)}.",
                        node=named(timetable.tree, bond.second),
                        robot=robots[-1],
                        found=", ".join(robots),
                        needed="one robot",
                    )


def different_robot_broken(case: Case) -> Iterator[Fault]:
    """A different-robot link is broken: a robot serves both sides."""
    for timetable in case.timetables:
        robots = timetable.robot_of_role
        for bond in timetable.staffing.bonds:
            if bond.kind in APART:
                first, second = (
                    {robots[role] for role in timetable.staffing.roles_below(leaves) if role in robots}
                    for leaves in (bond.first_leaves, bond.second_leaves)
                )
                for robot in sorted(first & second):
                    yield Fault(
                        f"schedule {timetable.schedule.rank}: {robot} works on {named(timetable.tree, bond.first)} and on "
                        f"{named(timetable.tree, bond.second)}, which are linked to different robots.",
                        node=named(timetable.tree, bond.second),
                        robot=robot,
                    )
