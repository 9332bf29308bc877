"""Which robots could fill the roles of an alternative: tried plainly, one role after the other."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping

from missiontree.checking.budgets import beyond
from missiontree.checking.staffing import Staffing
from missiontree.mission.fleet import Fleet

MOST_WORK = 200_000
"""Roles looked at in all tries together before the search is given up."""


def conflict(staffing: Staffing, fleet: Fleet, robots: Mapping[int, str]) -> tuple[str, int, str] | None:
    """
    Why robots cannot fill these roles by what allocation knows: a sentence, the role and the robot; None if they can.

    Tested are the type, teams, same-robot and different-robot links, and the budgets with ``uses_at_least``. Roles without a
    robot are taken to be open still.
    """
    for role, robot in robots.items():
        if fleet.type_of[robot].id != staffing.type_of_role[role]:
            return f"{robot} is not a {staffing.type_of_role[role]}", role, robot
    return (
        _team_conflict(staffing, robots)
        or _link_conflict(staffing, robots)
        or _budget_conflict(staffing, fleet, robots)
    )


def _team_conflict(staffing: Staffing, robots: Mapping[int, str]) -> tuple[str, int, str] | None:
    for roles in staffing.teams.values():
        busy: set[str] = set()
        for role in roles:
            robot = robots.get(role)
            if robot in busy and robot is not None:
                return f"{robot} fills two roles of one team", role, robot
            busy |= {robot} if robot is not None else set()
    return None


def _link_conflict(staffing: Staffing, robots: Mapping[int, str]) -> tuple[str, int, str] | None:
    for bond in staffing.bonds:
        first, second = (
            {role for role in staffing.roles_below(leaves) if role in robots}
            for leaves in (bond.first_leaves, bond.second_leaves)
        )
        if bond.kind == "same_robot":
            together = sorted(first | second)
            for role in together[1:]:
                if robots[role] != robots[together[0]]:
                    return "roles linked to one robot have several", role, robots[role]
        elif bond.kind == "different_robot":
            busy = {robots[role] for role in first}
            for role in sorted(second):
                if robots[role] in busy:
                    return f"{robots[role]} serves both sides of a different-robot link", role, robots[role]
    return None


def _budget_conflict(staffing: Staffing, fleet: Fleet, robots: Mapping[int, str]) -> tuple[str, int, str] | None:
    used: dict[tuple[str, str], float] = defaultdict(float)
    totals: dict[tuple[str, str], float] = defaultdict(float)
    for role, robot in robots.items():
        kind = fleet.type_of[robot]
        for leaf in staffing.leaves_of_role[role]:
            for name, amount in staffing.actions[leaf].uses_at_least.items():
                used[robot, name] += amount
                totals[kind.id, name] += amount
                left, whole = kind.budget(fleet.robots[robot], name), kind.total_limits.get(name)
                if left is not None and beyond(used[robot, name], left):
                    return f"{robot} would use more {name} than its {left:g}", role, robot
                if whole is not None and beyond(totals[kind.id, name], whole):
                    return f"the robots of type {kind.id} would use more {name} than their {whole:g}", role, robot
    return None


def can_be_staffed(staffing: Staffing, fleet: Fleet) -> bool | None:
    """Whether some robots fit by what allocation knows; None if it took too many tries to tell."""
    roles = list(staffing.leaves_of_role)
    if not roles or not _coupled(staffing, fleet):
        return True
    members = [[robot.id for robot in fleet.by_id[staffing.type_of_role[role]].members] for role in roles]
    chosen, work = [-1], 0
    while chosen:
        chosen[-1] += 1
        depth = len(chosen) - 1
        if chosen[-1] >= len(members[depth]):
            chosen.pop()
            continue
        work += len(chosen)
        if work > MOST_WORK:
            return None
        robots = {role: members[place][index] for place, (role, index) in enumerate(zip(roles, chosen, strict=False))}
        if conflict(staffing, fleet, robots) is None:
            if len(chosen) == len(roles):
                return True
            chosen.append(-1)
    return False


def _coupled(staffing: Staffing, fleet: Fleet) -> bool:
    """Whether anything makes it matter which robot fills which role."""
    if any(len(roles) > 1 for roles in staffing.teams.values()):
        return True
    if any(bond.kind in {"same_robot", "different_robot"} for bond in staffing.bonds):
        return True
    kinds = [fleet.by_id[type_id] for type_id in dict.fromkeys(staffing.type_of_role.values())]
    limited = {name for kind in kinds for name in (*kind.limits, *kind.total_limits)}
    limited |= {name for kind in kinds for robot in kind.robots for name in robot.remaining}
    return any(name in limited for action in staffing.actions.values() for name in action.uses_at_least)
