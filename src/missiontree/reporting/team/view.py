"""Alternatives side by side: who does what in each, what it comes to, and what is done otherwise than in the best."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from missiontree.mission.alternative import Alternative, selected_nodes
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule, ScheduleStatus
from missiontree.reporting.escape import one_line
from missiontree.reporting.known import by_word
from missiontree.reporting.references import refuse_damaged
from missiontree.reporting.team.limits import LimitUse, limits_of


@dataclass(frozen=True, slots=True)
class Doers:
    """
    Who does a task in an alternative.

    Parameters
    ----------
    types
        Labels of the robot types in the order of their roles; empty if the task is not done.
    robots
        Ids of the robots, in the same order; empty without a schedule.
    way
        By which of several ways, such as ``carry``; empty if there is only one.
    differs
        Whether other types do it than in the first alternative, or by another way, or only one of the two does it at all.
    """

    types: tuple[str, ...]
    robots: tuple[str, ...]
    way: str
    differs: bool


@dataclass(frozen=True, slots=True)
class Task:
    """
    A routine of the mission, with a cell for each alternative.

    Parameters
    ----------
    id
        Id of its node in the mission tree; in foreign instances, which have none, the label.
    label
        What people read.
    doers
        Who does it, in the order of the alternatives.
    """

    id: str
    label: str
    doers: tuple[Doers, ...]

    @property
    def differs(self) -> bool:
        """Whether it is not done alike in all alternatives."""
        return any(cell.differs for cell in self.doers)


@dataclass(frozen=True, slots=True)
class Column:
    """
    An alternative.

    Parameters
    ----------
    rank, utility
        As ranked.
    behind
        How much its utility is below the first one's; at least 0.
    tied
        Ranks of the other listed alternatives of exactly its utility.
    rank_proven
        Whether its rank is proven.
    known
        What is known of rank and schedule, in words.
    schedule
        Status of its schedule; None if nothing was scheduled.
    makespan_s, travel_m
        Of its schedule, in seconds and metres; None without one.
    robots
        How many robots take part; without a schedule, how many allocation names, or None if it names none.
    choices
        What was chosen where the mission leaves a choice, in words.
    limits
        What is used of limits, against what is allowed.
    """

    rank: int
    utility: float
    behind: float
    tied: tuple[int, ...]
    rank_proven: bool
    known: str
    schedule: ScheduleStatus | None
    makespan_s: float | None
    travel_m: float | None
    robots: int | None
    choices: tuple[str, ...]
    limits: tuple[LimitUse, ...]


@dataclass(frozen=True, slots=True)
class TeamView:
    """
    Alternatives side by side.

    Parameters
    ----------
    columns
        Alternatives, in the order of their ranks.
    tasks
        Tasks that any of them does, in the order of the mission.
    """

    columns: tuple[Column, ...]
    tasks: tuple[Task, ...]


def team_view(plan: Plan) -> TeamView | None:
    """
    Compare the alternatives of a plan; None if it has none. Linear in alternatives times nodes.

    Whatever comes from users is on one line and harmless in a terminal; in markup it must still be escaped.

    Raises
    ------
    InputError
        If parts of the plan do not fit each other.
    """
    refuse_damaged(plan)
    if plan.ranking is None or plan.grounding is None or not plan.ranking.alternatives:
        return None
    alternatives = plan.ranking.alternatives
    schedules = {schedule.rank: schedule for schedule in plan.schedules}
    done = [_done(plan, plan.grounding.tree, one, schedules.get(one.rank)) for one in alternatives]
    columns = tuple(_column(plan, one, schedules.get(one.rank), alternatives) for one in alternatives)
    order = _in_order([list(tasks) for tasks in done], plan)
    return TeamView(columns, tuple(_task(name, plan, done) for name in order))


_Done = tuple[tuple[str, ...], tuple[str, ...], str]
_NOT: _Done = ((), (), "")


def _task(name: str, plan: Plan, done: Sequence[Mapping[str, _Done]]) -> Task:
    node = plan.tree.by_id.get(name) if plan.tree is not None else None
    label = one_line(node.label if node is not None else name)
    types, _, way = done[0].get(name, _NOT)
    cells = (tasks.get(name, _NOT) for tasks in done)
    return Task(name, label, tuple(Doers(*cell, differs=(cell[0], cell[2]) != (types, way)) for cell in cells))


def _done(plan: Plan, tree: GroundedTree, alternative: Alternative, schedule: Schedule | None) -> dict[str, _Done]:
    """Who does each task, by its id, and by which way."""
    types, robots = plan.brief.fleet.by_id, dict[int, str]()
    for assignment in schedule.assignments if schedule is not None else ():
        robots[assignment.role] = one_line(assignment.robot)
    kinds = {entry.role: entry.robot_type for entry in alternative.roles}
    chosen = {choice.xor: choice.child for choice in alternative.choices}
    routines = {role.source for role in tree.roles if role.source is not None}
    ways: dict[str, str] = {}
    roles: dict[str, list[int]] = {}
    for node in selected_nodes(tree, alternative.choices):
        own = tree.nodes[node]
        if own.action is not None:
            role = tree.roles[own.action.role]
            listed = roles.setdefault(role.source or role.label, [])
            if own.action.role not in listed:
                listed.append(own.action.role)
        elif own.kind == "xor" and own.source in routines and _is_top(tree, node):
            offered = {_way(tree, child, plan) for child in tree.children[node]}
            ways[own.source] = _way(tree, chosen[node], plan) if len(offered) > 1 else ""
    return {
        task: (
            tuple(one_line(types[kinds[role]].label if kinds[role] in types else kinds[role]) for role in own_roles),
            tuple(robots[role] for role in own_roles if role in robots),
            ways.get(task, ""),
        )
        for task, own_roles in roles.items()
    }


def _is_top(tree: GroundedTree, node: int) -> bool:
    """Whether a node of a routine is the choice among its ways, not one of the choices below."""
    parent = tree.nodes[node].parent
    return parent < 0 or tree.nodes[parent].source != tree.nodes[node].source


def _way(tree: GroundedTree, node: int, plan: Plan) -> str:
    """Name of a way: what its label says before the type that goes it."""
    label = tree.nodes[node].label
    for kind in plan.brief.fleet.types:
        if label.endswith(f" by {kind.label}"):
            return one_line(label.removesuffix(f" by {kind.label}"))
    return one_line(label)


def _in_order(done: Sequence[Sequence[str]], plan: Plan) -> list[str]:
    """Tasks in the order of the mission tree, or else in that of the alternatives that do them."""
    found = list(dict.fromkeys(task for tasks in done for task in tasks))
    if plan.tree is None:
        return found
    place = {node.id: number for number, node in enumerate(plan.tree.nodes)}
    return sorted(found, key=lambda task: place.get(task, len(place)))


def _column(
    plan: Plan, alternative: Alternative, schedule: Schedule | None, alternatives: Sequence[Alternative]
) -> Column:
    scheduled = schedule if schedule is not None and schedule.actions else None
    named = (scheduled.assignments if scheduled is not None else ()) or alternative.witness
    proven = alternative.certificate.claim == "proven"
    return Column(
        rank=alternative.rank,
        utility=alternative.utility,
        behind=max(0.0, alternatives[0].utility - alternative.utility),
        tied=tuple(one.rank for one in alternatives if one is not alternative and one.utility == alternative.utility),
        rank_proven=proven,
        known=f"{'rank proven' if proven else 'rank not proven'}{_scheduled_words(schedule)}",
        schedule=schedule.status if schedule is not None else None,
        makespan_s=scheduled.makespan_s if scheduled is not None else None,
        travel_m=math.fsum(leg.distance_m for leg in scheduled.ways) if scheduled is not None else None,
        robots=len({assignment.robot for assignment in named}) or None,
        choices=tuple(_choices(plan, alternative)),
        limits=limits_of(plan, alternative, scheduled),
    )


def _scheduled_words(schedule: Schedule | None) -> str:
    if schedule is None:
        return ""
    return {
        "optimal": ", shortest, proven",
        "feasible": ", shortest by the solver's word" if by_word(schedule) else ", feasible, perhaps not shortest",
        "infeasible": ", cannot be scheduled",
        "unknown": ", no schedule found",
    }[schedule.status]


def _choices(plan: Plan, alternative: Alternative) -> Iterator[str]:
    """What was chosen at the gates of the mission itself, ways and robots of routines aside."""
    assert plan.grounding is not None
    tree = plan.grounding.tree
    routines = {role.source for role in tree.roles if role.source is not None}
    for choice in alternative.choices:
        if tree.nodes[choice.xor].source not in routines and len(tree.children[choice.xor]) > 1:
            yield f"{one_line(tree.nodes[choice.xor].label)}: {one_line(tree.nodes[choice.child].label)}"
