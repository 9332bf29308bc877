"""
The robots of one type as the model sees them: which of them count, and whether it matters which one fills a role.

Of robots that are equal in every respect no more are taken up than there are groups of roles. Where it does not matter who fills a
role, the model only counts heads, and robots are handed out afterwards.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

from missiontree.mission.fleet import Robot, RobotType
from missiontree.mission.ticks import ticks, ticks_within
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.trips import Spot


@dataclass(frozen=True, slots=True)
class Member:
    """
    A robot: where it starts, what it has of each budget, whether it must take part, when it comes and leaves (ticks).

    What it can refill is no budget: the model takes it to last for ever.
    """

    name: str
    start: Spot
    budget: Mapping[str, float]
    required: bool
    since: int = 0
    until: int | None = None


@dataclass(frozen=True, slots=True)
class Crew:
    """
    The robots and the roles of one type.

    Parameters
    ----------
    kind
        The type.
    roles, groups
        Roles that its robots fill, and their groups.
    members
        Robots that count, equal ones side by side.
    classes
        For each member a number that equal ones share.
    class_of
        The same for every robot of the type, by name, those that are not taken up included.
    apart
        Pairs of groups that must be filled by different robots, though nothing else keeps them from one robot.
    tours
        Whether it matters where robots are: their roles are done at more than one spot.
    """

    kind: RobotType
    roles: tuple[int, ...]
    groups: tuple[int, ...]
    members: tuple[Member, ...]
    classes: tuple[int, ...]
    class_of: Mapping[str, int]
    apart: tuple[tuple[int, int], ...]
    tours: bool

    @property
    def usable(self) -> int:
        """How many of the members may take part."""
        return min(self.kind.usable, len(self.members))


def crews(problem: Problem) -> list[Crew]:
    """All types with a role."""
    roles: dict[str, list[int]] = {}
    for role, type_id in problem.staffing.type_of.items():
        roles.setdefault(type_id, []).append(role)
    return [_crew(problem, problem.fleet.by_id[type_id], own) for type_id, own in roles.items()]


def _crew(problem: Problem, kind: RobotType, roles: Sequence[int]) -> Crew:
    groups = tuple(dict.fromkeys(problem.staffing.group_of[role] for role in roles))
    used, refilled = {*kind.uses_per_m}, problem.chargers.of(kind)
    for role in roles:
        for leaf in problem.graph.roles[role]:
            used |= problem.graph.tree.action(leaf).uses.keys()
    classes: dict[object, list[Member]] = {}
    class_of: dict[str, int] = {}
    for robot, start in zip(kind.members, problem.trips.starts(kind.id), strict=True):
        budgets = (dict(kind.limits) | dict(robot.remaining)).items()
        budget = {name: amount for name, amount in budgets if name in used and name not in refilled}
        member = Member(robot.id, start, budget, robot.id in problem.required, *presence(kind, robot))
        key = (start, tuple(sorted(budget.items())), robot.id if member.required else "", member.since, member.until)
        alike = classes.setdefault(key, [])
        class_of[robot.id] = list(classes).index(key)
        if len(alike) < len(groups):
            alike.append(member)
    spots: set[Spot] = set()
    for role in roles:
        for leaf in problem.graph.roles[role]:
            if problem.graph.tree.action(leaf).is_somewhere:
                spots |= problem.places.of[leaf]
    return Crew(
        kind,
        tuple(roles),
        groups,
        tuple(member for alike in classes.values() for member in alike),
        tuple(number for number, alike in enumerate(classes.values()) for _ in alike),
        class_of,
        tuple(_apart(problem, groups)),
        bool(spots) and len(spots | set(problem.trips.starts(kind.id))) > 1,
    )


def _apart(problem: Problem, groups: Sequence[int]) -> list[tuple[int, int]]:
    staffing, found = problem.staffing, []
    marked = [group for group in groups if staffing.avoids[group] or staffing.wears[group]]
    for first, second in combinations(marked, 2):
        if staffing.avoids[first] & staffing.wears[second] or staffing.wears[first] & staffing.avoids[second]:
            found.append((first, second))
    joint: set[tuple[int, int]] = set()
    for leaves in problem.graph.activities:
        if len(leaves) > 1:
            mine = sorted({staffing.group_of[problem.graph.tree.action(leaf).role] for leaf in leaves} & set(groups))
            joint |= set(combinations(mine, 2))
    return sorted({*found, *joint})


def met_at_once(problem: Problem, first: int, second: int) -> bool:
    """Whether two groups do something jointly that takes time, so that one robot cannot fill both."""
    for activity, leaves in enumerate(problem.graph.activities):
        if len(leaves) > 1 and problem.bounds.duration[activity] > 0:
            groups = {problem.staffing.group_of[problem.graph.tree.action(leaf).role] for leaf in leaves}
            if first in groups and second in groups:
                return True
    return False


def presence(kind: RobotType, robot: Robot) -> tuple[int, int | None]:
    """When a robot comes and when it leaves, in ticks; None if it stays."""
    since_s, until_s = kind.availability(robot)
    return ticks(since_s), None if until_s is None else ticks_within(until_s)


def matters_who(problem: Problem, crew: Crew) -> bool:
    """Whether it matters which robot of a crew without travel fills a role."""
    if any(member.since or member.until is not None for member in crew.members):
        return True
    if len(crew.members) == 1:
        return bool(crew.apart)
    if any(member.required for member in crew.members) or len(crew.groups) < len(crew.roles):
        return True
    if any(not met_at_once(problem, *pair) for pair in crew.apart):
        return True
    return _some_take_no_time(problem, crew) or _some_wait(problem, crew) or bool(tight_budgets(problem, crew))


def _some_take_no_time(problem: Problem, crew: Crew) -> bool:
    """A role that takes no time does not count among heads, and yet must not stand inside another."""
    graph = problem.graph
    return any(
        all(problem.bounds.duration[graph.activity_of[leaf]] == 0 for leaf in graph.roles[role]) for role in crew.roles
    )


def _some_wait(problem: Problem, crew: Crew) -> bool:
    """Who lasts until something that takes no time is free only when it is over, and so must not be who does it."""
    own = {problem.graph.activity_of[leaf] for role in crew.roles for leaf in problem.graph.roles[role]}
    until = problem.graph.until.items()
    return any(one in own and not problem.bounds.duration[one] for waits, ends in until if waits in own for one in ends)


def uses_of(problem: Problem, role: int) -> dict[str, float]:
    """What the actions of a role use, travel apart."""
    uses: dict[str, float] = {}
    for leaf in problem.graph.roles[role]:
        for name, amount in problem.graph.tree.action(leaf).uses.items():
            uses[name] = uses.get(name, 0.0) + amount
    return uses


def tight_budgets(problem: Problem, crew: Crew) -> list[str]:
    """Budgets that some robot has too little of to fill all roles."""
    total: dict[str, float] = {}
    for role in crew.roles:
        for name, amount in uses_of(problem, role).items():
            total[name] = total.get(name, 0.0) + amount
    return [
        name
        for name, amount in sorted(total.items())
        if any(member.budget.get(name, amount) < amount for member in crew.members)
    ]
