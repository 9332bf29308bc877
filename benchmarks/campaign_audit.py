"""
What no plan may do, whoever authored it: read off the inputs, without a line of the product's checker.

Robots are of the fleet, routines of the library, entities of the scene or introduced; kinds, capabilities, limits, zones and
resources hold; robots do one thing at a time; links are kept.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from typing import Any

from benchmarks.campaign_history import Asked
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import RobotType
from missiontree.mission.grounded import Action, GroundedTree
from missiontree.mission.plan import Plan
from missiontree.mission.routine import RoleSpec, Routine
from missiontree.mission.schedule import Schedule, ScheduledAction
from missiontree.mission.tree import MissionNode, MissionTree

TICK_S = 0.0011


def tree_breaches(tree: MissionTree, brief: MissionBrief, asked: Sequence[Asked]) -> Iterator[str]:
    """What is in a tree that nobody put on offer."""
    here = {entity.id: entity for entity in _of_the_world(brief)}
    for entity in tree.entities:
        if entity.id in here:
            yield f"{entity.id} is introduced, and was there before"
        if not _was_introduced(entity, brief, asked):
            yield f"{entity.label!r} is in the tree, and nobody introduced it"
    here |= {entity.id: entity for entity in tree.entities}
    library = {routine.id: routine for routine in brief.routines.routines}
    fleet = {kind.id for kind in brief.fleet.types}
    for node in tree.nodes:
        if node.routine is None:
            if not node.children:
                yield f"{node.id} ends in nothing"
            continue
        routine = library.get(node.routine)
        if routine is None:
            yield f"{node.id} names routine {node.routine}"
            continue
        if list(node.arguments) != [argument.name for argument in routine.arguments]:
            yield f"{node.id} has arguments {list(node.arguments)}"
        yield from _strangers(node, routine, here, brief)
        if not set(node.resources or ()) <= fleet:
            yield f"{node.id} allows {node.resources}"


def _strangers(node: MissionNode, routine: Routine, here: dict[str, Entity], brief: MissionBrief) -> Iterator[str]:
    for argument in routine.arguments:
        entity = here.get(node.arguments.get(argument.name, ""))
        if entity is None:
            yield f"{node.id} speaks of {node.arguments.get(argument.name)!r}"
        elif brief.check_kinds and not _kinds(entity, brief) & set(argument.kinds):
            yield f"{node.id} takes {entity.id}, a {entity.kind}, as {argument.name}"


def _of_the_world(brief: MissionBrief) -> tuple[Entity, ...]:
    scene = () if brief.scene is None else (*brief.scene.places, *brief.scene.entities)
    return (*scene, *brief.entities)


def _kinds(entity: Entity, brief: MissionBrief) -> set[str]:
    """The kind and all above it."""
    declared = brief.scene.kinds if brief.scene is not None else {}
    kinds = [entity.kind]
    while kinds[-1] in declared and len(kinds) < 20:
        kinds.append(declared[kinds[-1]])
    return set(kinds)


def _was_introduced(entity: Entity, brief: MissionBrief, asked: Sequence[Asked]) -> bool:
    """By a call that was accepted and names it, and, without a scene, by the mission's words."""
    named = [call.arguments for call in asked if call.ok and call.name == "introduceEntity"]
    if any(entity.label in _texts(arguments) for arguments in named):
        return True
    words = re.findall(r"\w+", entity.label.lower())
    said = re.findall(r"\w+", brief.text.lower())
    used = any(entity.label in _texts(call.arguments) for call in asked if call.ok)
    within = any(said[at : at + len(words)] == words for at in range(len(said)))
    return brief.scene is None and used and within


def _texts(arguments: str) -> set[str]:
    found: set[str] = set()
    waiting: list[Any] = [json.loads(arguments or "{}")]
    while waiting:
        value = waiting.pop()
        if isinstance(value, str):
            found.add(value)
        elif isinstance(value, list | dict):
            waiting += value.values() if isinstance(value, dict) else value
    return found


def plan_breaches(plan: Plan) -> Iterator[str]:
    """What a plan has a robot do that it may not do."""
    brief, tree = plan.brief, plan.tree
    if plan.grounding is None or plan.ranking is None or tree is None:
        yield "a delivered plan lacks its trees"
        return
    for schedule in plan.schedules:
        if schedule.status in {"optimal", "feasible"}:
            yield from _deeds(schedule, plan.grounding.tree, tree, brief)
            yield from _overlaps(schedule, plan.grounding.tree)
            yield from _links(schedule, plan.grounding.tree, tree)


def _deeds(schedule: Schedule, grounded: GroundedTree, tree: MissionTree, brief: MissionBrief) -> Iterator[str]:
    robots = {robot.id: kind for kind in brief.fleet.types for robot in kind.members}
    nodes = {node.id: node for node in tree.nodes}
    people = {entity.id: entity for entity in (*_of_the_world(brief), *tree.entities)}
    for done in schedule.actions:
        action, source = grounded.nodes[done.leaf].action, _source(grounded, done.leaf)
        kind, node = robots.get(done.robot), nodes.get(source or "")
        if kind is None or action is None or node is None or node.routine is None:
            yield f"{done.robot} does {done.leaf}, of {source}"
            continue
        if kind.id != action.robot_type or action.capability not in kind.capabilities:
            yield f"{done.robot}, a {kind.id}, does {action.name} of {action.robot_type} by {action.capability}"
        if node.resources is not None and kind.id not in node.resources:
            yield f"{done.robot}, a {kind.id}, does {node.id}, which is for {node.resources}"
        roles = [role for role in _roles(node.routine, brief) if _is_of(action, role)]
        given = _renamed(node, people)
        if not any(_fits(kind, role, given) for role in roles):
            yield f"{done.robot}, a {kind.id}, does {action.name} of {node.id}, and its limits do not allow it"
        yield from _out_of_zone(kind, [people[name] for name in node.arguments.values()], done.robot)


def _source(grounded: GroundedTree, leaf: int) -> str | None:
    while leaf >= 0:
        if grounded.nodes[leaf].source is not None:
            return grounded.nodes[leaf].source
        leaf = grounded.nodes[leaf].parent
    return None


def _roles(routine: str, brief: MissionBrief) -> Iterator[RoleSpec]:
    """Roles of a routine, and of those that it is composed of."""
    found = next(known for known in brief.routines.routines if known.id == routine)
    for branch in found.branches:
        yield from branch.roles
    for part in found.parts:
        yield from _roles(part.routine, brief)


def _is_of(action: Action, role: RoleSpec) -> bool:
    return role.rating == action.capability and any(step.name == action.name for step in role.actions)


def _renamed(node: MissionNode, people: dict[str, Entity]) -> dict[str, Entity]:
    """Entities by argument; composed routines of these campaigns hand arguments on under their own names."""
    return {argument: people[name] for argument, name in node.arguments.items()}


def _fits(kind: RobotType, role: RoleSpec, given: dict[str, Entity]) -> bool:
    """Whether what the role needs is there, as far as it is known."""
    for need in role.needs:
        if need.capability is not None:
            if need.capability not in kind.capabilities:
                return False
            continue
        bound = need.at_least
        if isinstance(bound, str):
            argument, attribute = bound.split(".")
            bound = getattr(given[argument], attribute)
        has = kind.limits.get(need.limit or "")
        if bound is not None and has is not None and has < float(bound) * need.share - 1e-9:
            return False
    return True


def _out_of_zone(kind: RobotType, entities: Sequence[Entity], robot: str) -> Iterator[str]:
    for entity in entities:
        if kind.zones is not None and entity.zone is not None and entity.zone not in kind.zones:
            yield f"{robot}, a {kind.id}, has to do with {entity.id} in zone {entity.zone}"


def _overlaps(schedule: Schedule, grounded: GroundedTree) -> Iterator[str]:
    """A robot is held by one role at a time."""
    spans: dict[tuple[str, int], tuple[float, float]] = {}
    for done in schedule.actions:
        action = grounded.nodes[done.leaf].action
        if action is not None:
            start, end = spans.get((done.robot, action.role), (done.start_s, done.end_s))
            spans[done.robot, action.role] = (min(start, done.start_s), max(end, done.end_s))
    for (robot, role), (start, end) in spans.items():
        for (other, further), (begin, stop) in spans.items():
            if robot == other and role < further and start < stop - TICK_S and begin < end - TICK_S:
                yield f"{robot} has roles {role} and {further} at once"


def _links(schedule: Schedule, grounded: GroundedTree, tree: MissionTree) -> Iterator[str]:
    """Precedence and who may be whom, between nodes of the mission tree."""
    below: dict[str, list[ScheduledAction]] = {}
    above = {child: node.id for node in tree.nodes for child in node.children}
    for done in schedule.actions:
        node = _source(grounded, done.leaf)
        while node is not None:
            below.setdefault(node, []).append(done)
            node = above.get(node)
    for link in tree.links:
        first, second = below.get(link.first, []), below.get(link.second, [])
        if not first or not second:
            continue
        robots, others = {done.robot for done in first}, {done.robot for done in second}
        said = f"{link.kind} of {link.first} and {link.second} is broken"
        if link.kind == "precedence" and max(d.end_s for d in first) > min(d.start_s for d in second) + TICK_S:
            yield said
        if link.kind == "same_robot" and len(robots | others) > 1:
            yield said
        if link.kind == "different_robot" and robots & others:
            yield said
