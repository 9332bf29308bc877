"""
Proof that no robot of a type, however often it refills, can do a role.

It comes to the role from its start or from a charger with a full store at most, and a way in several legs is no shorter than the way in
one, but where there are lifts, or where some move may take it to an unknown place; then only what the role itself uses counts.
"""

from __future__ import annotations

from collections.abc import Collection

from missiontree.estimation.travel import Blocked
from missiontree.mission.fleet import RobotType
from missiontree.mission.reason import Reason
from missiontree.scheduling.approach_budget import may_get_lost
from missiontree.scheduling.chargers import Chargers
from missiontree.scheduling.impossible import TOLERANCE, least_use
from missiontree.scheduling.places import Places
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.trips import Spot, Trips


def may_wait_at_chargers(problem: Problem) -> bool:
    """
    Whether going to a charger can bring a robot nearer to what it does next, while it would have waited anyway.

    A robot goes to an action with a place as soon as it is free, and a way past a charger is no shorter. But where a role begins with a
    move, or with an action that may be done anywhere, its robot stays where it is until then. So schedules with visits to chargers
    may be shorter than all without.
    """
    graph = problem.graph
    firsts = (graph.tree.action(leaves[0]) for leaves in graph.roles.values())
    return any(
        action.robot_type in problem.chargers.stations and (action.moves or action.at is None) for action in firsts
    )


def never_enough(
    graph: TaskGraph, places: Places, trips: Trips, chargers: Chargers, returning: bool = False
) -> list[Reason]:
    """Roles that use more of something that robots refill than they hold when they are full."""
    if not chargers:
        return []
    lifts = trips.scene.roads is not None and bool(trips.scene.roads.lifts)
    lost = may_get_lost(graph, places)
    found: dict[tuple[str, str], Reason] = {}
    for role, leaves in graph.roles.items():
        kind = trips.fleet.by_id[graph.tree.action(leaves[0]).robot_type]
        for name in sorted(chargers.of(kind)):
            need = sum(least_use(graph.tree.action(leaf)).get(name, 0.0) for leaf in leaves)
            per_m, metres = kind.uses_per_m.get(name, 0.0), 0.0
            if per_m and not lifts and kind.id not in lost:
                metres = _ways(graph, leaves, places, trips, _Ends(kind, name, chargers, returning))
            needed, full = need + per_m * metres, kind.limits[name]
            if needed > full + TOLERANCE * max(1.0, full):
                label = graph.tree.roles[role].label
                found.setdefault((kind.id, name), _reason(kind, name, label, needed, bool(metres)))
    return list(found.values())


class _Ends:
    """Where a robot can have been full at last, and where it must be able to get afterwards; nowhere if it need not."""

    def __init__(self, kind: RobotType, name: str, chargers: Chargers, returning: bool) -> None:
        self.kind, self.returning = kind, returning
        self.stations = [station.spot for station in chargers.stations[kind.id] if station.stock == name]


def _ways(graph: TaskGraph, leaves: tuple[int, ...], places: Places, trips: Trips, ends: _Ends) -> float:
    """The fewest metres to a role's first place, and where robots return from its last place to a charger or home."""
    placed = [leaf for leaf in leaves if graph.tree.action(leaf).at is not None]
    if not placed:
        return 0.0
    starts = dict.fromkeys(trips.starts(ends.kind.id))
    sources: list[Spot] = [*starts, *ends.stations]
    metres = _fewest(ends.kind, sources, places.of[placed[0]], trips)
    if ends.returning:
        metres += _fewest(ends.kind, places.of[placed[-1]], sources, trips)
    return metres


def _fewest(kind: RobotType, origins: Collection[Spot], goals: Collection[Spot], trips: Trips) -> float:
    """The fewest metres from one of some spots to one of others; 0 where one of them is unknown."""
    if None in origins or None in goals:
        return 0.0
    ways = (trips.approach(kind.id, origin, goal) for origin in origins for goal in goals)
    return min((way.metres for way in ways if not isinstance(way, Blocked)), default=0.0)


def _reason(kind: RobotType, name: str, label: str, needed: float, travels: bool) -> Reason:
    way = " with the shortest way to it" if travels else ""
    return Reason(
        rule="budget_exceeded",
        message=f"{label!r} uses at least {needed:g} of {name}{way}, more than the {kind.limits[name]:g} that a full robot of type "
        f"{kind.label!r} holds, and nobody refills within a role.",
        node=label,
        robot=kind.id,
        found=f"{name} {kind.limits[name]:g}",
        needed=f"{name} {needed:g}",
        hint=f"Raise the limit {name} of the type, set a charger nearer, or give the task another way of being done.",
    )
