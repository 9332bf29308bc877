"""Which robots could fill the roles of an alternative: tried plainly, one role after the other."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping

from missiontree.checking.budgets import beyond
from missiontree.checking.case import Case
from missiontree.checking.levels import allowance
from missiontree.checking.staffing import Staffing
from missiontree.mission.tree import APART

MOST_WORK = 200_000
"""Roles looked at in all tries together before the search is given up."""


def conflict(staffing: Staffing, case: Case, robots: Mapping[int, str]) -> tuple[str, int, str] | None:
    """
    Why robots cannot fill these roles by what allocation knows: a sentence, the role and the robot; None if they can.

    Tested are the type, teams, same-robot and different-robot links, the budgets with ``uses_at_least``, and the terms of the
    mission. Roles without a robot are taken to be open still.
    """
    for role, robot in robots.items():
        if case.fleet.type_of[robot].id != staffing.type_of_role[role]:
            return f"{robot} is not a {staffing.type_of_role[role]}", role, robot
    return (
        _team_conflict(staffing, robots)
        or _link_conflict(staffing, robots)
        or _budget_conflict(staffing, case, robots)
        or _shared_conflict(staffing, case, robots)
        or _terms_conflict(staffing, case, robots)
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
        elif bond.kind in APART:
            busy = {robots[role] for role in first}
            for role in sorted(second):
                if robots[role] in busy:
                    return f"{robots[role]} serves both sides of a different-robot link", role, robots[role]
    return None


def _budget_conflict(staffing: Staffing, case: Case, robots: Mapping[int, str]) -> tuple[str, int, str] | None:
    used: dict[tuple[str, str], float] = defaultdict(float)
    totals: dict[tuple[str, str], float] = defaultdict(float)
    for role, robot in robots.items():
        kind = case.fleet.type_of[robot]
        for leaf in staffing.leaves_of_role[role]:
            for name, amount in staffing.actions[leaf].uses_at_least.items():
                used[robot, name] += amount
                totals[kind.id, name] += amount
                left, whole = allowance(case, robot, name), kind.total_limits.get(name)
                if left is not None and beyond(used[robot, name], left):
                    return f"{robot} would use more {name} than its {left:g}", role, robot
                if whole is not None and beyond(totals[kind.id, name], whole):
                    return f"the robots of type {kind.id} would use more {name} than their {whole:g}", role, robot
    return None


def _shared_conflict(staffing: Staffing, case: Case, robots: Mapping[int, str]) -> tuple[str, int, str] | None:
    limits = ((case.fleet.total_limits, "the fleet's total"), (case.scene.stock, "the scene's stock"))
    for allowed, whose in limits:
        used: dict[str, float] = defaultdict(float)
        for role, robot in robots.items() if allowed else ():
            for leaf in staffing.leaves_of_role[role]:
                for name, amount in staffing.actions[leaf].uses_at_least.items():
                    used[name] += amount
                    if name in allowed and beyond(used[name], allowed[name]):
                        return (
                            f"all robots together would use more {name} than {whose} of {allowed[name]:g}",
                            role,
                            robot,
                        )
    return None


def _terms_conflict(staffing: Staffing, case: Case, robots: Mapping[int, str]) -> tuple[str, int, str] | None:
    in_use: dict[str, set[str]] = defaultdict(set)
    for role, robot in robots.items():
        if robot in case.left_out:
            return f"{robot} is left out of the mission", role, robot
        kind = case.fleet.type_of[robot]
        in_use[kind.id].add(robot)
        if kind.max_in_use is not None and len(in_use[kind.id]) > kind.max_in_use:
            return f"more than {kind.max_in_use} robots of type {kind.id} are in use", role, robot
    if len(robots) == len(staffing.leaves_of_role):
        for name in case.plan.brief.require:
            if name not in (in_use if name in case.fleet.by_id else robots.values()):
                return f"{name} is required and fills no role", next(iter(robots), 0), name
    return None


def can_be_staffed(staffing: Staffing, case: Case) -> bool | None:
    """Whether some robots fit by what allocation knows; None if it took too many tries to tell."""
    roles = list(staffing.leaves_of_role)
    if not roles:
        return not case.plan.brief.require
    if not _coupled(staffing, case):
        return True
    members = [[robot.id for robot in case.at_hand(staffing.type_of_role[role])] for role in roles]
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
        if conflict(staffing, case, robots) is None:
            if len(chosen) == len(roles):
                return True
            chosen.append(-1)
    return False


def _coupled(staffing: Staffing, case: Case) -> bool:
    """Whether anything makes it matter which robot fills which role, or that a role is filled at all."""
    if case.plan.brief.require:
        return True
    if any(len(roles) > 1 for roles in staffing.teams.values()):
        return True
    if any(bond.kind in {"same_robot", "different_robot", "hand_over"} for bond in staffing.bonds):
        return True
    kinds = [case.fleet.by_id[type_id] for type_id in dict.fromkeys(staffing.type_of_role.values())]
    limited = {name for kind in kinds for name in (*kind.limits, *kind.total_limits)}
    limited |= {name for kind in kinds for robot in kind.robots for name in robot.remaining}
    limited |= {*case.fleet.total_limits, *case.scene.stock}
    return any(name in limited for action in staffing.actions.values() for name in action.uses_at_least)
