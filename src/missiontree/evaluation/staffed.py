"""Which robot types the leaves of a tree leave a choice of: those that are allowed and able."""

from __future__ import annotations

from missiontree.mission.brief import MissionBrief
from missiontree.mission.tree import MissionNode, MissionTree
from missiontree.routines.offers import offers_for


def able_types(tree: MissionTree, brief: MissionBrief) -> tuple[frozenset[str], ...]:
    """For each routine of the tree, in its order, the types that are allowed and can take part; all that are allowed if none can."""
    return tuple(_able(node, tree, brief) for node in tree.nodes if node.routine is not None)


def _able(node: MissionNode, tree: MissionTree, brief: MissionBrief) -> frozenset[str]:
    allowed = frozenset(brief.fleet.by_id if node.resources is None else node.resources)
    routine = brief.routines.find(node.routine or "")
    world = brief.world.extended(tree.entities)
    known = {name: world.by_id[entity] for name, entity in node.arguments.items() if entity in world.by_id}
    if routine is None or set(known) != set(routine.argument_kinds):
        return allowed
    offers = offers_for(
        routine, known, brief.fleet, world, brief.routines, node.resources, brief.check_kinds, brief.terms
    )
    return frozenset(offers.able_types) or allowed
