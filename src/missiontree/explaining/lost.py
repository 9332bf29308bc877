"""Who is used by a part of a mission without being found first, since the search for it is left out."""

from __future__ import annotations

from missiontree.explaining.understood import eased
from missiontree.mission.brief import MissionBrief
from missiontree.mission.tree import MissionTree
from missiontree.routines.calls import calls_of
from missiontree.routines.order import RoutineOrder, order_moved
from missiontree.routines.review import lost_entities


def lost_uses(tree: MissionTree, brief: MissionBrief) -> frozenset[tuple[str, str]]:
    """
    Routines that use somebody whose position is not known and whom nothing finds first, each with whom.

    A part of a mission must have none that the whole does not have: what is lost is not fetched before it is looked for.

    Parameters
    ----------
    tree
        A mission tree, every leaf of which is a routine.
    brief
        Fleet, scene and routines.
    """
    world = brief.world.extended(tree.entities)
    *_, able = eased(brief)  # what a search finds does not hang on whether somebody can do it
    order, calls = RoutineOrder(tree), calls_of(tree, able, world)
    order_moved(tree, calls, order)
    return frozenset((finding.node, finding.found) for finding in lost_entities(tree, calls, order, world))
