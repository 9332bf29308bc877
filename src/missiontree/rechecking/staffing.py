"""Staffing: one robot of the right type in every role, different robots where work is joint, and the links between roles."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations

from missiontree.mission.alternative import Assignment
from missiontree.mission.reason import Reason
from missiontree.rechecking.facts import Facts, broken


def types_of_roles(facts: Facts) -> Iterator[Reason]:
    """Every reached role has one type, that of all its selected actions, and no other role has any."""
    told = facts.alternative.roles
    reached = sorted(facts.leaves_of_role)
    if [one.role for one in told] != reached:
        yield broken("core_types", f"types are given to roles {[one.role for one in told]}; reached are {reached}.")
    for one in told:
        for leaf in facts.leaves_of_role.get(one.role, []):
            needed = facts.leaves[leaf].robot_type
            if needed != one.robot_type:
                message = (
                    f"role {one.role} is filled by type {one.robot_type}; {facts.label(leaf)} is done by {needed}."
                )
                yield broken("core_types", message, node=leaf, robot=one.robot_type)


def robots_of_roles(facts: Facts) -> Iterator[Reason]:
    """The schedule fills every reached role with one robot, and no other role with any."""
    if facts.schedule is None:
        return
    told = [one.role for one in facts.schedule.assignments]
    reached = sorted(facts.leaves_of_role)
    if told != reached:
        yield broken("core_staffing", f"the schedule fills roles {told}; reached are {reached}.")
    for one in facts.schedule.actions:
        if one.leaf in facts.leaves and facts.robot_of_role.get(facts.leaves[one.leaf].role) != one.robot:
            message = f"{one.robot} does {facts.label(one.leaf)}, and is not the robot of its role."
            yield broken("core_staffing", message, node=one.leaf, robot=one.robot)


def scheduled_team(facts: Facts) -> Iterator[Reason]:
    """The robots of the schedule may do together what they do."""
    if facts.schedule is not None:
        yield from _team(facts, facts.schedule.assignments)


def witnessed_team(facts: Facts) -> Iterator[Reason]:
    """So may the robots of the witness, which fills all reached roles or none."""
    witness = facts.alternative.witness
    if not witness:
        return
    told = sorted(one.role for one in witness)
    if told != sorted(facts.leaves_of_role):
        yield broken("core_staffing", f"the witness fills roles {told}; reached are {sorted(facts.leaves_of_role)}.")
    yield from _team(facts, witness)


def _team(facts: Facts, assignments: Sequence[Assignment]) -> Iterator[Reason]:
    robot_of = {one.role: one.robot for one in assignments if one.role in facts.leaves_of_role}
    yield from _right_types(facts, robot_of)
    yield from _different_in_teams(facts, robot_of)
    yield from _linked(facts, robot_of)
    yield from _not_too_many(facts, robot_of)
    yield from _required(facts, robot_of)


def _right_types(facts: Facts, robot_of: Mapping[int, str]) -> Iterator[Reason]:
    there = facts.brief.fleet.type_of
    out = facts.brief.without
    for role, robot in robot_of.items():
        if robot not in there:
            yield broken("core_staffing", f"{robot} fills role {role} and is not in the fleet.", robot=robot)
            continue
        kind = there[robot].id
        for leaf in facts.leaves_of_role[role]:
            if facts.leaves[leaf].robot_type != kind:
                message = f"{robot} is of type {kind}; {facts.label(leaf)} is done by {facts.leaves[leaf].robot_type}."
                yield broken("core_staffing", message, node=leaf, robot=robot)
        # A name that both a type and a robot have means the type.
        if kind in out or (robot in out and robot not in facts.brief.fleet.by_id):
            yield broken("core_without", f"{robot} fills role {role}, and the mission leaves it out.", robot=robot)


def _different_in_teams(facts: Facts, robot_of: Mapping[int, str]) -> Iterator[Reason]:
    filled: dict[tuple[int, str], list[int]] = {}
    for role, robot in robot_of.items():
        if (team := facts.tree.roles[role].team) is not None:
            filled.setdefault((team, robot), []).append(role)
    for (_, robot), roles in filled.items():
        for one, other in combinations(sorted(roles), 2):
            message = f"{robot} fills roles {one} and {other}, which need different robots."
            yield broken("core_different_robots", message, node=other, robot=robot)


def _linked(facts: Facts, robot_of: Mapping[int, str]) -> Iterator[Reason]:
    def robots_below(node: int) -> set[str]:
        roles = {facts.leaves[leaf].role for leaf in facts.below(node)}
        return {robot_of[role] for role in roles if role in robot_of}

    for link in facts.links("same_robot"):
        together = robots_below(link.first) | robots_below(link.second)
        if len(together) > 1:
            message = (
                f"{facts.label(link.first)} and {facts.label(link.second)} are for one robot, "
                f"and are done by {', '.join(sorted(together))}."
            )
            yield broken("core_same_robot", message, node=link.second)
    for link in (*facts.links("different_robot"), *facts.links("hand_over")):
        for robot in sorted(robots_below(link.first) & robots_below(link.second)):
            message = (
                f"{robot} takes part in {facts.label(link.first)} and in {facts.label(link.second)}, which it may not."
            )
            yield broken("core_different_robots", message, node=link.second, robot=robot)


def _not_too_many(facts: Facts, robot_of: Mapping[int, str]) -> Iterator[Reason]:
    for kind in facts.brief.fleet.types:
        used = {robot for robot in robot_of.values() if robot in {one.id for one in kind.members}}
        if kind.max_in_use is not None and len(used) > kind.max_in_use:
            message = f"{len(used)} robots of type {kind.id} take part; at most {kind.max_in_use} may."
            yield broken("core_max_in_use", message, robot=kind.id)


def _required(facts: Facts, robot_of: Mapping[int, str]) -> Iterator[Reason]:
    fleet = facts.brief.fleet
    kinds = {fleet.type_of[robot].id for robot in robot_of.values() if robot in fleet.type_of}
    for name in facts.brief.require:
        if name not in (kinds if name in fleet.by_id else set(robot_of.values())):
            yield broken("core_require", f"{name} must take part, and does not.", robot=name)


def required_types(facts: Facts) -> Iterator[Reason]:
    """Types that the mission requires, those of required robots too, take part in the alternative."""
    fleet = facts.brief.fleet
    taking = {one.robot_type for one in facts.alternative.roles}
    for name in facts.brief.require:
        kind = name if name in fleet.by_id else fleet.type_of[name].id
        if kind not in taking:
            message = f"{name} must take part, and no role of rank {facts.alternative.rank} is filled by type {kind}."
            yield broken("core_require", message, robot=name)


def enough_for_teams(facts: Facts) -> Iterator[Reason]:
    """A type has a robot for each of its roles that need different robots."""
    needed: dict[tuple[int, str], int] = {}
    for one in facts.alternative.roles:
        team = facts.tree.roles[one.role].team if one.role < len(facts.tree.roles) else None
        if team is not None:
            needed[team, one.robot_type] = needed.get((team, one.robot_type), 0) + 1
    for (_, kind_id), count in needed.items():
        kind = facts.brief.team.by_id.get(kind_id)
        if kind is None or count > kind.usable:
            message = (
                f"{count} robots of type {kind_id} are needed at once, and there are {kind.usable if kind else 0}."
            )
            yield broken("core_different_robots", message, robot=kind_id)
