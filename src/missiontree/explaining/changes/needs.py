"""What the routines of a mission need of robots: capabilities, limits that are compared, budgets that are used."""

from __future__ import annotations

from dataclasses import dataclass, field

from missiontree.explaining.case import Case
from missiontree.mission.entity import Entity
from missiontree.mission.routine import Need
from missiontree.routines.arguments import find_entities, find_routine
from missiontree.routines.compose import flatten


@dataclass(slots=True)
class Needs:
    """
    What any way of any routine of a mission needs.

    Parameters
    ----------
    capabilities
        Names, each with the highest quality that a need compares it with.
    at_least, at_most
        Limits that are compared, each with the numbers that they are compared with.
    budgets
        Names of what actions use.
    """

    capabilities: dict[str, float] = field(default_factory=dict)
    at_least: dict[str, set[float]] = field(default_factory=dict)
    at_most: dict[str, set[float]] = field(default_factory=dict)
    budgets: set[str] = field(default_factory=set)


def needs_of(case: Case) -> Needs:
    """The needs of all routines of a case."""
    found = Needs()
    world = case.brief.world.extended(case.tree.entities)
    for node in case.tree.nodes:
        if node.routine is None:
            continue
        routine = find_routine(node.routine, case.brief.routines, node.id)
        entities = find_entities(routine, node.arguments, world, node.id)
        for role in (role for branch in flatten(routine, case.brief.routines) for role in branch.roles):
            for need in role.needs:
                _add(found, need, entities)
            for action in role.actions:
                found.capabilities.setdefault(action.rating, 0.0)
                found.budgets |= action.step.uses.keys()
    found.budgets |= {name for kind in case.brief.fleet.types for name in kind.uses_per_m}
    return found


def _add(found: Needs, need: Need, entities: dict[str, Entity]) -> None:
    if need.capability is not None:
        least = need.at_least if isinstance(need.at_least, int | float) else 0.0
        found.capabilities[need.capability] = max(found.capabilities.get(need.capability, 0.0), least)
        return
    assert need.limit is not None, "a need names a capability or a limit"
    wanted = _wanted(need, entities)
    if wanted is not None:
        limits = found.at_least if need.at_least is not None else found.at_most
        limits.setdefault(need.limit, set()).add(wanted)


def _wanted(need: Need, entities: dict[str, Entity]) -> float | None:
    """The number that a limit is compared with; None if it is unknown, which refuses nobody."""
    if need.reference is None:
        bound = need.at_least if need.at_least is not None else need.at_most
        return bound * need.share if isinstance(bound, int | float) else None
    argument, attribute = need.reference
    value = entities[argument].attribute(attribute)
    return None if value is None else value * need.share
