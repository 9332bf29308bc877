"""May the robot types in the tree do what they are put down for? Read off routines, fleet and scene, without asking grounding."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

from missiontree.checking.case import Case
from missiontree.checking.closed import inside
from missiontree.checking.estimates import alone_s
from missiontree.checking.fault import Fault, named
from missiontree.checking.parts import Stretch, chains, readings
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import RobotType
from missiontree.mission.grounded import Action
from missiontree.mission.routine import ActionStep, Need
from missiontree.mission.tree import MissionNode


class Part(NamedTuple):
    """What one robot type does in one role below one node: its leaves, and every reading of them."""

    node: MissionNode
    leaves: tuple[int, ...]
    actions: tuple[Action, ...]
    readings: tuple[tuple[Stretch, ...], ...]


def type_unknown(case: Case) -> Iterator[Fault]:
    """An action names a robot type that the fleet does not have."""
    for leaf, action in _actions(case):
        if action.robot_type not in case.fleet.by_id:
            yield _about(
                case,
                leaf,
                f"is for robot type {action.robot_type!r}, which the fleet does not have",
                action.robot_type,
                "a type",
            )


def capability_missing(case: Case) -> Iterator[Fault]:
    """A robot type lacks the capability that rates its action."""
    for leaf, action in _actions(case):
        kind = case.fleet.by_id.get(action.robot_type)
        if kind is not None and kind.capability(action.capability) is None:
            found = ", ".join(kind.capabilities) or "no capability"
            yield _about(case, leaf, f"needs {action.capability}, which {kind.id} lacks", found, action.capability)


def quality_differs(case: Case) -> Iterator[Fault]:
    """The quality of an action is not the one that the fleet states for the type, and no estimator of the user's own said it."""
    for leaf, action in _actions(case) if case.plan.brief.estimator is None else ():
        kind = case.fleet.by_id.get(action.robot_type)
        capability = kind.capability(action.capability) if kind is not None else None
        if capability is not None and action.estimate.quality != capability.quality:
            found, needed = f"{action.estimate.quality:g}", f"{capability.quality:g}"
            yield _about(case, leaf, f"claims quality {found}; the fleet states {needed}", found, needed)


def routine_not_followed(case: Case) -> Iterator[Fault]:
    """The actions of a role are those of no branch of its routine."""
    for part in case.once(_parts, None):
        if not part.readings:
            names = ", ".join(action.name for action in part.actions)
            yield _about(
                case,
                part.leaves[0],
                f"begins the actions {names}, which no branch of {part.node.routine} has",
                names,
                "a branch",
            )


def resource_excluded(case: Case) -> Iterator[Fault]:
    """A robot type is not among the resources that the mission allows for the node."""
    for part in case.once(_parts, None):
        allowed = part.node.resources
        if allowed is not None and part.actions[0].robot_type not in allowed:
            found, needed = part.actions[0].robot_type, ", ".join(allowed) or "none"
            yield _about(case, part.leaves[0], f"is for {found}; allowed are {needed}", found, needed)


def kind_refused(case: Case) -> Iterator[Fault]:
    """An argument is of a kind that the routine, or the branch taken, does not accept."""
    if case.plan.brief.check_kinds:
        yield from _unmet(case, _kind_problem)


def need_unmet(case: Case) -> Iterator[Fault]:
    """A robot type fails a condition of its role: a capability, its quality, or a limit compared with the entity."""
    yield from _unmet(case, _need_problem)


def quality_below_minimum(case: Case) -> Iterator[Fault]:
    """An action has less quality than the mission asks of every action, of its capability, or of its routine."""
    least = case.plan.brief.min_quality
    if isinstance(least, float | int):
        for leaf, action in _actions(case):
            if action.estimate.quality < least:
                yield _too_poor(case, leaf, action, least)
    else:
        yield from _below_named(case, least)


def _below_named(case: Case, least: Mapping[str, float]) -> Iterator[Fault]:
    by_capability = {leaf: least.get(action.capability, 0.0) for leaf, action in _actions(case)}
    for part in case.once(_parts, None):
        # Of several ways to read a part, that which asks least: the others are not said to be taken.
        for place, leaf in enumerate(part.leaves):
            asked = [_asked(least, part, reading, place) for reading in part.readings]
            by_capability[leaf] = max(by_capability[leaf], min(asked, default=0.0))
    for leaf, action in _actions(case):
        if action.estimate.quality < by_capability[leaf]:
            yield _too_poor(case, leaf, action, by_capability[leaf])


def _asked(least: Mapping[str, float], part: Part, reading: tuple[Stretch, ...], place: int) -> float:
    """Quality asked of the action at a place of a part, by the routines that it stands in."""
    within = [stretch.within for stretch in reading for _ in stretch.role.actions][place]
    return max((least.get(name, 0.0) for name in within), default=0.0)


def _too_poor(case: Case, leaf: int, action: Action, least: float) -> Fault:
    found = f"{action.estimate.quality:g}"
    return _about(
        case, leaf, f"is of quality {found}; the mission asks for at least {least:g}", found, f"at least {least:g}"
    )


def zone_forbidden(case: Case) -> Iterator[Fault]:
    """A robot type is sent to an entity in a zone that it may not enter."""
    yield from _unmet(case, _zone_problem)


def action_differs(case: Case) -> Iterator[Fault]:
    """An action is not what its routine and the fleet make of it: place, duration, use of budgets, or what it brings, finds or holds."""
    for part in case.once(_parts, None):
        kind = case.fleet.by_id.get(part.actions[0].robot_type)
        problems = [_difference(case, reading, part, kind) for reading in part.readings]
        if problems and all(problem is not None for problem in problems) and (problem := problems[0]) is not None:
            leaf, what, found, needed = problem
            yield _about(case, leaf, f"has {what} {found}; its routine gives {needed}", found, needed)


Problem = Callable[[Case, RobotType, Stretch], tuple[str, str, str] | None]


def _unmet(case: Case, problem_of: Problem) -> Iterator[Fault]:
    """Parts none of whose readings is free of a problem; the problem of the first is told."""
    for part in case.once(_parts, None):
        kind = case.fleet.by_id.get(part.actions[0].robot_type)
        if kind is None or not part.readings:
            continue
        problems = [
            next((found for stretch in reading if (found := problem_of(case, kind, stretch)) is not None), None)
            for reading in part.readings
        ]
        if all(problem is not None for problem in problems) and (problem := problems[0]) is not None:
            yield _about(case, part.leaves[0], *problem)


def _kind_problem(case: Case, kind: RobotType, stretch: Stretch) -> tuple[str, str, str] | None:
    demands = [*stretch.branch.accepts.items(), *stretch.routine.argument_kinds.items()]
    for argument, accepted in demands:
        entity = case.scene.by_id.get(stretch.entities.get(argument, ""))
        if entity is not None and not set(case.scene.lineage(entity.kind)) & set(accepted):
            needed = " or ".join(accepted)
            return f"takes as {argument} only {needed}; {entity.label} is of kind {entity.kind}", entity.kind, needed
    return None


def _need_problem(case: Case, kind: RobotType, stretch: Stretch) -> tuple[str, str, str] | None:
    for need in (Need(capability=stretch.role.rating), *stretch.role.needs):
        if need.capability is not None:
            has = kind.capability(need.capability)
            if has is None:
                return f"needs {need.capability}, which {kind.id} lacks", "no " + need.capability, need.capability
            if isinstance(need.at_least, int | float) and has.quality < need.at_least:
                return f"needs {need.capability} of quality {need.at_least:g}", f"{has.quality:g}", f"{need.at_least:g}"
        elif need.limit is not None and (limit := kind.limits.get(need.limit)) is not None:
            wanted = _wanted(case, need, stretch)
            if wanted is None:
                continue
            if need.at_least is not None and limit < wanted:
                return (
                    f"needs {need.limit} {wanted:.12g}; {kind.id} has {limit:.12g}",
                    f"{limit:.12g}",
                    f"at least {wanted:.12g}",
                )
            if need.at_most is not None and limit > wanted:
                return (
                    f"needs {need.limit} at most {wanted:.12g}; {kind.id} has {limit:.12g}",
                    f"{limit:.12g}",
                    f"at most {wanted:.12g}",
                )
    return None


def _wanted(case: Case, need: Need, stretch: Stretch) -> float | None:
    bound = need.at_least if need.at_least is not None else need.at_most
    if isinstance(bound, str):
        argument, attribute = bound.split(".")
        entity = case.scene.by_id.get(stretch.entities.get(argument, ""))
        bound = entity.attribute(attribute) if entity is not None else None
    return None if bound is None else bound * need.share


def _zone_problem(case: Case, kind: RobotType, stretch: Stretch) -> tuple[str, str, str] | None:
    if kind.zones is None:
        return None
    for step in stretch.role.actions:
        entity = case.scene.by_id.get(stretch.place(step.at or step.goes_to) or "")
        for zone in _zones(case, entity) if entity is not None else ():
            if zone not in kind.zones:
                allowed = ", ".join(kind.zones) or "no zone"
                return f"goes to {entity.label if entity else ''} in zone {zone}, closed to {kind.id}", zone, allowed
    return None


def _zones(case: Case, entity: Entity) -> tuple[str, ...]:
    """Zone that the entity or its place names, else all whose area holds where it is."""
    if entity.zone is not None:
        return (entity.zone,)
    if entity.place is not None and (zone := case.scene.by_id[entity.place].zone) is not None:
        return (zone,)
    spot = case.scene.spots[entity.id]
    if spot is None:
        return ()
    areas = (
        (zone.id, zone.area) for zone in case.scene.zones if zone.area is not None and zone.area.floor == spot.floor
    )
    return tuple(name for name, area in areas if inside((spot.x_m, spot.y_m), area))


def _difference(
    case: Case, reading: tuple[Stretch, ...], part: Part, kind: RobotType | None
) -> tuple[int, str, str, str] | None:
    """First leaf that differs from its step, in what, and both values; None if none does."""
    steps = [(stretch, step) for stretch in reading for step in stretch.role.actions]
    for leaf, action, (stretch, step) in zip(part.leaves, part.actions, steps, strict=True):
        for what, needed in _expected(case, stretch, step, kind, action).items():
            found = getattr(action, what)
            if found != needed and not _close(found, needed):
                return leaf, what, str(found), str(needed)
    return None


def _close(found: object, needed: object) -> bool:
    return isinstance(found, float | int) and isinstance(needed, float | int) and math.isclose(found, needed)


def _expected(
    case: Case, stretch: Stretch, step: ActionStep, kind: RobotType | None, action: Action
) -> dict[str, object]:
    expected: dict[str, object] = {
        "at": stretch.place(step.goes_to or step.at),
        "moves": step.goes_to is not None,
        "brings": tuple(dict.fromkeys(stretch.place(name) for name in step.brings)),
        "finds": stretch.place(step.finds),
        "open_ended": step.open_ended,
        "uses": step.uses,
        "holds": _held(case, stretch, step),
    }
    capability = kind.capability(stretch.role.rating) if kind is not None else None
    if case.plan.brief.estimator is not None:
        expected["duration_s"] = alone_s(case, action, step)
    elif capability is not None:
        expected["duration_s"] = capability.duration.plus_s + capability.duration.scale * step.duration_s
    return expected


def _held(case: Case, stretch: Stretch, step: ActionStep) -> tuple[str, ...]:
    """Shared resources of the scene that a step holds: those it names, and those that its arguments stand for."""
    there = {resource.id for resource in case.scene.resources}
    named_ones = (stretch.place(name.strip("{}")) if name.startswith("{") else name for name in step.holds)
    return tuple(dict.fromkeys(name for name in named_ones if name in there))


def _actions(case: Case) -> Iterator[tuple[int, Action]]:
    for leaf, node in enumerate(case.tree.nodes if case.tree is not None else ()):
        if node.action is not None:
            yield leaf, node.action


def _parts(case: Case, _whole: None) -> list[Part]:
    """Leaves by parent and role, where their node is a routine call that makes sense."""
    parts: list[Part] = []
    if case.tree is None or case.mission_tree is None:
        return parts
    groups: dict[tuple[str, int, int], list[int]] = {}
    for leaf, action in _actions(case):
        node = case.tree.nodes[leaf]
        groups.setdefault((node.source or "", node.parent, action.role), []).append(leaf)
    library = case.plan.brief.routines
    for (source, _, _), leaves in groups.items():
        call = case.mission_tree.by_id.get(source)
        routine = library.find(call.routine) if call is not None and call.routine is not None else None
        if call is None or routine is None or not set(call.arguments.values()) <= case.scene.by_id.keys():
            continue
        actions = tuple(case.tree.action(leaf) for leaf in leaves)
        found = [reading for chain in chains(routine, call.arguments, library) for reading in readings(chain, actions)]
        parts.append(Part(call, tuple(leaves), actions, tuple(map(tuple, found))))
    return parts


def _about(case: Case, leaf: int, what: str, found: str, needed: str) -> Fault:
    assert case.tree is not None
    return Fault(
        f"{named(case.tree, leaf)} {what}.",
        node=named(case.tree, leaf),
        robot=case.tree.action(leaf).robot_type,
        found=found,
        needed=needed,
    )
