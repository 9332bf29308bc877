"""Limits that are compared: what a load weighs beside what the robot can carry."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

from missiontree.errors import InputError
from missiontree.mission.alternative import Alternative, selected_leaves
from missiontree.mission.entity import Entity
from missiontree.mission.plan import Plan
from missiontree.mission.routine import Need, RoutineLibrary
from missiontree.mission.schedule import Schedule
from missiontree.mission.tree import MissionNode
from missiontree.reporting.html.used import Used, used_of
from missiontree.routines.compose import FlatRole, flatten


def thresholds(plan: Plan, alternative: Alternative, schedule: Schedule) -> tuple[Used, ...]:
    """The most that the roles of each robot need of each limit that they compare with, where both are known; in the order of the fleet."""
    tightest: dict[tuple[str, str], Used] = {}
    for row in _compared(plan, alternative, schedule):
        known = tightest.get((row.who, row.name))
        if known is None or row.filled > known.filled:
            tightest[row.who, row.name] = row
    places = {robot: place for place, robot in enumerate(plan.brief.fleet.robots)}
    return tuple(sorted(tightest.values(), key=lambda row: places.get(row.who, len(places))))


def _compared(plan: Plan, alternative: Alternative, schedule: Schedule) -> Iterator[Used]:
    assert plan.tree is not None
    robot_of = {assignment.role: assignment.robot for assignment in schedule.assignments}
    entities = plan.brief.world.extended(plan.tree.entities).by_id
    for role, node, needs in _needs(plan, alternative):
        robot = robot_of.get(role, "")
        kind = plan.brief.fleet.type_of.get(robot)
        for need in needs:
            allowed = kind.limits.get(need.limit or "") if kind is not None else None
            wanted, why = _wanted(need, node, entities)
            if need.limit is not None and allowed is not None and wanted is not None:
                yield used_of(robot, need.limit, wanted, allowed, why)


def _needs(plan: Plan, alternative: Alternative) -> Iterator[tuple[int, MissionNode, tuple[Need, ...]]]:
    """Every reached role with its node and its needs: those of the routine's role that has just its actions."""
    assert plan.grounding is not None
    assert plan.tree is not None
    tree = plan.grounding.tree
    actions: dict[int, list[str]] = defaultdict(list)
    for leaf in selected_leaves(tree, alternative.choices):
        actions[tree.action(leaf).role].append(tree.action(leaf).name)
    flat: dict[str, tuple[FlatRole, ...]] = {}
    for role, names in actions.items():
        node = plan.tree.by_id.get(tree.roles[role].source or "")
        if node is None or node.routine is None:
            continue
        if node.routine not in flat:
            flat[node.routine] = _roles(node.routine, plan.brief.routines)
        for candidate in flat[node.routine]:
            if [action.step.name for action in candidate.actions] == names:
                yield role, node, candidate.needs
                break


def _roles(routine: str, library: RoutineLibrary) -> tuple[FlatRole, ...]:
    """Every role of every branch of a routine; none if the plan's library does not have it, or cannot compose it."""
    known = library.by_id.get(routine)
    try:
        return tuple(role for branch in flatten(known, library) for role in branch.roles) if known else ()
    except InputError:
        return ()


def _wanted(need: Need, node: MissionNode, entities: dict[str, Entity]) -> tuple[float | None, str]:
    """The least that is needed (None if there is no least, or it is not known), and what it is of."""
    if need.at_least is None:
        return None, ""
    if need.reference is None:
        return (need.at_least * need.share if isinstance(need.at_least, int | float) else None), node.label
    argument, attribute = need.reference
    entity = entities.get(node.arguments.get(argument, ""))
    value = entity.attribute(attribute) if entity is not None else None
    return (None if value is None else value * need.share), (entity.label if entity is not None else "")
