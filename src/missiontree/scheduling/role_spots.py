"""Where robots can be when a role begins, and where it leaves them, whatever the schedule."""

from __future__ import annotations

from collections import Counter

from missiontree.scheduling.chargers import NO_CHARGERS, Chargers
from missiontree.scheduling.places import MANY_SPOTS, Places, Spots
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.staffing import Staffing
from missiontree.scheduling.trips import Trips


def first_spots(
    graph: TaskGraph, staffing: Staffing, places: Places, trips: Trips, chargers: Chargers = NO_CHARGERS
) -> dict[int, Spots]:
    """
    Where a role's robot can be when it begins, by role; roles whose robot may be at too many spots are left out.

    That is where robots of its type start, at a charger, or where another role of the type ends. Robots set out for the first action
    of a role before it begins only if that is at a place, so it matters for roles that begin otherwise.
    """
    by_type: dict[str, dict[int, Spots]] = {}
    for role in graph.roles:
        by_type.setdefault(staffing.type_of[role], {})[role] = last_spots(graph, role, places)
    found: dict[int, Spots] = {}
    for type_id, lasts in by_type.items():
        idle = {*trips.starts(type_id), *(station.spot for station in chargers.stations.get(type_id, ()))}
        everywhere = frozenset(idle.union(*lasts.values()))
        if len(everywhere) > MANY_SPOTS:
            continue
        ends = Counter(spot for spots in lasts.values() for spot in spots)
        for role, spots in lasts.items():
            found[role] = everywhere - {spot for spot in spots if ends[spot] == 1 and spot not in idle}
    return found


def last_spots(graph: TaskGraph, role: int, places: Places) -> Spots:
    """Where a role leaves its robot; nowhere if it takes it nowhere."""
    for leaf in reversed(graph.roles[role]):
        action = graph.tree.action(leaf)
        if action.is_somewhere:
            return places.of[leaf]
    return frozenset()
