"""The least travel into roles and to chargers: no robot gets to a place that it is not at already in less than its shortest leg there."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from missiontree.estimation.travel import Blocked
from missiontree.scheduling.chargers import NO_CHARGERS, Chargers
from missiontree.scheduling.places import MANY_SPOTS, Places
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.staffing import Staffing
from missiontree.scheduling.trips import Spot, Trips


class Entry(NamedTuple):
    """
    The least that a leg to a place costs.

    Parameters
    ----------
    ticks
        Of time.
    metres
        Of way; perhaps on another leg than the quickest one.
    """

    ticks: int
    metres: float


NO_WAY = Entry(0, 0.0)


@dataclass(frozen=True)
class Entries:
    """
    What travel costs at least, from wherever a robot is before.

    Parameters
    ----------
    roles
        Into each role; roles with no time and no way are left out.
    chargers
        By type whose places are all known, to each charger that no robot of the type is at otherwise; by its spot.
    """

    roles: Mapping[int, Entry] = field(default_factory=dict)
    chargers: Mapping[str, Mapping[Spot, Entry]] = field(default_factory=dict)

    @property
    def ticks(self) -> dict[int, int]:
        """The least time into each role that takes any."""
        return {role: entry.ticks for role, entry in self.roles.items() if entry.ticks}


def least_entries(
    graph: TaskGraph, staffing: Staffing, places: Places, trips: Trips, chargers: Chargers = NO_CHARGERS
) -> Entries:
    """
    The least legs into roles and to chargers.

    A robot is where it starts, at a charger, or where some role of its type took it. So a place that is no start and no charger, and
    that only one role visits, is entered by a leg from another spot, and so is a charger that is no start and no role's place. Where a
    start or a spot may be unknown, nothing is counted.
    """
    by_type: dict[str, list[int]] = {}
    for role in graph.roles:
        by_type.setdefault(staffing.type_of[role], []).append(role)
    roles_found: dict[int, Entry] = {}
    chargers_found: dict[str, dict[Spot, Entry]] = {}
    for type_id, roles in by_type.items():
        spots = {role: _visited(graph, role, places) for role in roles}
        plugs = {station.spot for station in chargers.stations.get(type_id, ())}
        starts = {*trips.starts(type_id), *plugs}
        everywhere = starts.union(*spots.values())
        if None in everywhere:
            continue
        if plugs:
            apart = plugs.difference(trips.starts(type_id), *spots.values()) if len(everywhere) <= MANY_SPOTS else set()
            chargers_found[type_id] = {spot: _least_leg(type_id, spot, everywhere, trips) for spot in apart}
        if len(everywhere) > MANY_SPOTS:
            continue
        visits = Counter(spot for visited in spots.values() for spot in visited)
        legs = {spot: _least_leg(type_id, spot, everywhere, trips) for spot in everywhere - starts if visits[spot] == 1}
        for role in roles:
            first = graph.roles[role][0]
            if graph.tree.action(first).at is None or graph.activity_of[first] in graph.until:
                continue
            ways = [legs.get(spot, NO_WAY) for spot in places.of[first]]
            entry = Entry(min(way.ticks for way in ways), min(way.metres for way in ways))
            if entry != NO_WAY:
                roles_found[role] = entry
    return Entries(roles_found, chargers_found)


def _visited(graph: TaskGraph, role: int, places: Places) -> set[Spot]:
    actions = ((leaf, graph.tree.action(leaf)) for leaf in graph.roles[role])
    return {spot for leaf, action in actions if action.is_somewhere for spot in places.of[leaf]}


def _least_leg(type_id: str, goal: Spot, origins: set[Spot], trips: Trips) -> Entry:
    assert goal is not None
    found = (trips.approach(type_id, origin, goal) for origin in origins if origin is not None and origin != goal)
    ways = [way for way in found if not isinstance(way, Blocked)]
    return Entry(min(way.ticks for way in ways), min(way.metres for way in ways)) if ways else NO_WAY
