"""
Which robot may fill which role.

Roles that must be filled by one robot form a *group*. Roles that must be filled by different robots leave *marks*: a robot that
fills a role wears the role's marks, and a role refuses robots that wear a mark it avoids. A link between two nodes with a
thousand roles each thus costs two marks, not a million pairs.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass

from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.reason import Reason
from missiontree.scheduling.precedence import TaskGraph

Mark = tuple[str, int, int]


@dataclass(frozen=True, slots=True)
class Staffing:
    """
    Who may be what in one alternative.

    Parameters
    ----------
    type_of
        Robot type of every reached role.
    group_of
        Group of every reached role, named by its smallest role.
    members
        Roles of each group, in order of index.
    wears, avoids
        Marks of each group: of all its roles together.
    """

    type_of: dict[int, str]
    group_of: dict[int, int]
    members: dict[int, tuple[int, ...]]
    wears: dict[int, frozenset[Mark]]
    avoids: dict[int, frozenset[Mark]]

    def one_robot(self, fleet: Fleet, role: int) -> object:
        """A key that two roles share if they are certainly filled by one robot."""
        kind = fleet.by_id[self.type_of[role]]
        return kind.id if kind.usable == 1 else (self.group_of[role],)


def staffing_of(graph: TaskGraph) -> Staffing:
    """Groups and marks of the reached roles."""
    roles = graph.roles
    group_of = _groups(graph)
    members: dict[int, list[int]] = {}
    for role in roles:
        members.setdefault(group_of[role], []).append(role)
    wears: dict[int, set[Mark]] = {group: set() for group in members}
    avoids: dict[int, set[Mark]] = {group: set() for group in members}
    for role in roles:
        team = graph.tree.roles[role].team
        if team is not None:
            wears[group_of[role]].add(("team", team, 0))
            avoids[group_of[role]].add(("team", team, 0))
    for number, link in enumerate([*graph.links("different_robot"), *graph.links("hand_over")]):
        for side, node in enumerate(link):
            for role in graph.roles_below(node):
                wears[group_of[role]].add(("link", number, side))
                avoids[group_of[role]].add(("link", number, 1 - side))
    return Staffing(
        type_of={role: graph.tree.action(leaves[0]).robot_type for role, leaves in roles.items()},
        group_of=group_of,
        members={group: tuple(group_roles) for group, group_roles in members.items()},
        wears={group: frozenset(marks) for group, marks in wears.items()},
        avoids={group: frozenset(marks) for group, marks in avoids.items()},
    )


def staffing_conflicts(graph: TaskGraph, staffing: Staffing, fleet: Fleet) -> list[Reason]:
    """What no choice of robots can mend: each reason alone proves that the alternative cannot be scheduled."""
    reasons: list[Reason] = []
    for group in staffing.members:
        reasons += _types_differ(graph, staffing, group)
        reasons += _at_once(graph, staffing, group)
    return reasons + _teams_too_large(graph, staffing, fleet)


def _types_differ(graph: TaskGraph, staffing: Staffing, group: int) -> list[Reason]:
    label, type_of = graph.tree.roles, staffing.type_of
    return [
        Reason(
            rule="same_robot",
            message=f"{label[group].label!r} and {label[role].label!r} must be filled by one robot, but are chosen for two types.",
            node=label[role].label,
            robot=type_of[role],
            found=type_of[role],
            needed=type_of[group],
        )
        for role in staffing.members[group]
        if type_of[role] != type_of[group]
    ]


def _at_once(graph: TaskGraph, staffing: Staffing, group: int) -> list[Reason]:
    """Roles of one robot that must be filled by different robots: by a team, by a link, or by working jointly."""
    members = staffing.members[group]
    teams = [graph.tree.roles[role].team for role in members if graph.tree.roles[role].team is not None]
    joint = [graph.activity_of[leaf] for role in members for leaf in graph.roles[role]]
    clash = len(set(teams)) < len(teams) or len(set(joint)) < len(joint)
    if not clash and not any(mark in staffing.wears[group] for mark in staffing.avoids[group] if mark[0] == "link"):
        return []
    names = " and ".join(repr(graph.tree.roles[role].label) for role in members)
    return [
        Reason(
            rule="same_robot",
            message=f"{names} must be filled by one robot, and at the same time by different ones.",
            node=graph.tree.roles[group].label,
            robot=staffing.type_of[group],
        )
    ]


def _teams_too_large(graph: TaskGraph, staffing: Staffing, fleet: Fleet) -> list[Reason]:
    sizes = Counter(
        (graph.tree.roles[role].team, staffing.type_of[role])
        for role in graph.roles
        if graph.tree.roles[role].team is not None
    )
    for activity in graph.activities:
        at_once = Counter(graph.tree.action(leaf).robot_type for leaf in activity)
        for type_id, count in at_once.items():
            sizes[-1, type_id] = max(sizes[-1, type_id], count)  # joint actions outside a team need as many robots
    return [
        Reason(
            rule="too_few_robots",
            message=f"{count} robots of type {fleet.by_id[type_id].label!r} are needed together, there are "
            f"{fleet.by_id[type_id].usable}{_kept_down(fleet.by_id[type_id])}.",
            robot=type_id,
            found=str(fleet.by_id[type_id].usable),
            needed=str(count),
        )
        for (_, type_id), count in sorted(sizes.items(), key=str)
        if count > fleet.by_id[type_id].usable
    ]


def _kept_down(kind: RobotType) -> str:
    return " that may be in use" if kind.usable < len(kind.members) else ""


def _groups(graph: TaskGraph) -> dict[int, int]:
    leader = {role: role for role in graph.roles}

    def find(role: int) -> int:
        while leader[role] != role:
            leader[role] = leader[leader[role]]
            role = leader[role]
        return role

    for first, second in graph.links("same_robot"):
        joined = sorted({*graph.roles_below(first), *graph.roles_below(second)})
        # "every role under a and every role under b that is reached": with nothing under one of them nothing binds
        if graph.roles_below(first) and graph.roles_below(second):
            for role in joined[1:]:
                low, high = sorted((find(joined[0]), find(role)))
                leader[high] = low
    return {role: find(role) for role in leader}
