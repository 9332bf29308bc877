"""The least travel into each role: no robot gets to a place that it is not at already in less time than its shortest leg there."""

from __future__ import annotations

from collections import Counter

from missiontree.estimation.travel import Blocked
from missiontree.scheduling.chargers import NO_CHARGERS, Chargers
from missiontree.scheduling.places import Places
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.staffing import Staffing
from missiontree.scheduling.trips import Spot, Trips

_MANY = 48  # spots of a type beyond which travel is bounded by nothing; keeps bounds cheaper than schedules


def least_entries(
    graph: TaskGraph, staffing: Staffing, places: Places, trips: Trips, chargers: Chargers = NO_CHARGERS
) -> dict[int, int]:
    """
    Ticks of travel that each role costs its robot at least, from wherever the robot is before; roles with 0 are left out.

    A robot is where it starts, at a charger, or where some role of its type took it. So a place that is no start and no charger, and
    that only one role visits, is entered by a leg from another spot. Where a start or a spot may be unknown, nothing is counted.
    """
    by_type: dict[str, list[int]] = {}
    for role in graph.roles:
        by_type.setdefault(staffing.type_of[role], []).append(role)
    found: dict[int, int] = {}
    for type_id, roles in by_type.items():
        spots = {role: _visited(graph, role, places) for role in roles}
        starts = {*trips.starts(type_id), *(station.spot for station in chargers.stations.get(type_id, ()))}
        everywhere = starts.union(*spots.values())
        if None in everywhere or len(everywhere) > _MANY:
            continue
        visits = Counter(spot for visited in spots.values() for spot in visited)
        legs = {spot: _least_leg(type_id, spot, everywhere, trips) for spot in everywhere - starts if visits[spot] == 1}
        for role in roles:
            first = graph.roles[role][0]
            if graph.tree.action(first).at is None or graph.activity_of[first] in graph.until:
                continue
            entry = min(legs.get(spot, 0) for spot in places.of[first])
            if entry:
                found[role] = entry
    return found


def _visited(graph: TaskGraph, role: int, places: Places) -> set[Spot]:
    actions = ((leaf, graph.tree.action(leaf)) for leaf in graph.roles[role])
    return {spot for leaf, action in actions if action.at is not None or action.moves for spot in places.of[leaf]}


def _least_leg(type_id: str, goal: Spot, origins: set[Spot], trips: Trips) -> int:
    assert goal is not None
    ways = (trips.approach(type_id, origin, goal) for origin in origins if origin is not None and origin != goal)
    return min((way.ticks for way in ways if not isinstance(way, Blocked)), default=0)
