"""Abilities: may a type do this action for these entities, by capability, limits, kinds and zones?"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from missiontree.mission.entity import Entity
from missiontree.mission.fleet import RobotType
from missiontree.mission.position import Position
from missiontree.mission.reason import Reason
from missiontree.mission.routine import Branch, Need, RoleSpec, Routine
from missiontree.rechecking.facts import Facts, broken


@dataclass(frozen=True)
class Way:
    """A role of a branch that a routine may come down to, with the entity of each argument."""

    routine: Routine
    branch: Branch
    role: RoleSpec
    entities: Mapping[str, str]


def able(facts: Facts) -> Iterator[Reason]:
    """Some role of the leaf's routine has this action, and takes this type and these entities."""
    ways: dict[str, list[Way]] = {}  # by node of the mission tree, whose leaves are many
    takes: dict[tuple[str, int, str], bool] = {}  # by that, number of the way, and type
    for leaf, action in facts.offered.items():
        source = facts.tree.nodes[leaf].source
        node = facts.mission.by_id.get(source) if facts.mission is not None and source is not None else None
        kind = facts.brief.fleet.by_id.get(action.robot_type)
        if node is None or node.routine is None or kind is None:
            continue
        if node.resources is not None and kind.id not in node.resources:
            message = (
                f"{facts.label(leaf)} is done by {kind.id}, and its routine is for {', '.join(node.resources)} only."
            )
            yield broken("core_ability", message, node=leaf, robot=kind.id)
        if node.id not in ways:
            ways[node.id] = [*_ways(facts, node.routine, node.arguments)]
        for number, way in enumerate(ways[node.id]):
            named = way.role.rating == action.capability and any(step.name == action.name for step in way.role.actions)
            key = (node.id, number, kind.id)
            if named and key not in takes:
                takes[key] = _takes(facts, way, kind)
            if named and takes[key]:
                break
        else:
            message = (
                f"no role of {node.routine} with {action.name}, rated by {action.capability}, takes {kind.id} here."
            )
            yield broken("core_ability", message, node=leaf, robot=kind.id)


def _ways(facts: Facts, routine_id: str, arguments: Mapping[str, str]) -> Iterator[Way]:
    routine = facts.brief.routines.by_id.get(routine_id)
    if routine is None:
        return
    for branch in routine.branches:
        for role in branch.roles:
            yield Way(routine, branch, role, arguments)
    for part in routine.parts:
        below = facts.brief.routines.by_id[part.routine]
        named = {one.name: part.arguments.get(one.name, one.name) for one in below.arguments}
        yield from _ways(
            facts, part.routine, {inner: arguments[outer] for inner, outer in named.items() if outer in arguments}
        )


def _takes(facts: Facts, way: Way, kind: RobotType) -> bool:
    if kind.capability(way.role.rating) is None:
        return False
    if facts.brief.check_kinds:
        for argument, kinds in (*way.routine.argument_kinds.items(), *way.branch.accepts.items()):
            entity = facts.world.by_id.get(way.entities.get(argument, ""))
            if entity is not None and not set(kinds) & set(facts.world.lineage(entity.kind)):
                return False
    return all(_meets(facts, need, way, kind) for need in way.role.needs)


def _meets(facts: Facts, need: Need, way: Way, kind: RobotType) -> bool:
    """Whether a type meets a need; what is unknown does not refuse."""
    if need.capability is not None:
        ability = kind.capability(need.capability)
        least = need.at_least if isinstance(need.at_least, int | float) else 0.0
        return ability is not None and ability.quality >= least * (need.share if need.at_least is not None else 1.0)
    has = kind.limits.get(need.limit or "")
    asked = need.at_least if need.at_least is not None else need.at_most
    if isinstance(asked, str):
        argument, attribute = asked.split(".")
        entity = facts.world.by_id.get(way.entities.get(argument, ""))
        asked = entity.attribute(attribute) if entity is not None else None
    if has is None or asked is None:
        return True
    return has >= asked * need.share if need.at_least is not None else has <= asked * need.share


def in_allowed_zones(facts: Facts) -> Iterator[Reason]:
    """No action is done at an entity or place in a zone that the type may not enter."""
    for leaf, action in facts.offered.items():
        kind = facts.brief.fleet.by_id.get(action.robot_type)
        entity = facts.world.by_id.get(action.at or "")
        if kind is None or kind.zones is None or entity is None:
            continue
        zone = _zone_of(facts, entity)
        if zone is not None and zone not in kind.zones:
            message = f"{facts.label(leaf)} is done in zone {zone}, which {kind.id} may not enter."
            yield broken("core_zone", message, node=leaf, robot=kind.id)


def _zone_of(facts: Facts, entity: Entity) -> str | None:
    if entity.zone is not None:
        return entity.zone
    where = facts.world.whereabouts(entity).position
    for zone in facts.world.zones:
        if where is None or zone.area is None or zone.area.floor != where.floor:
            continue
        if _inside(zone.area.corners, where):
            return zone.id
    return None


def _inside(corners: tuple[tuple[float, float], ...], where: Position) -> bool:
    """Whether a ray from the point crosses the edge an odd number of times."""
    odd = False
    for (x1, y1), (x2, y2) in zip(corners, (*corners[1:], corners[0]), strict=True):
        if (y1 > where.y_m) != (y2 > where.y_m) and where.x_m < x1 + (where.y_m - y1) * (x2 - x1) / (y2 - y1):
            odd = not odd
    return odd
