"""
Proof that no robot of a type can pay for getting to a role and doing it.

Whatever a robot does before, it gets from its start to the role's first place in legs, and on every map without lifts a way in
several legs is no shorter than the way in one: roads and grids lead to one node or cell per point, and what closes an area closes it
to every leg. Two cases are left out. With lifts, the quickest way need not be the shortest. And a robot that some move may take to an
unknown place comes back from there at no known cost.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass

from missiontree.estimation.travel import Blocked
from missiontree.mission.fleet import RobotType
from missiontree.mission.reason import Reason
from missiontree.scheduling.chargers import NO_CHARGERS, Chargers
from missiontree.scheduling.impossible import TOLERANCE, least_use
from missiontree.scheduling.places import Places, Spots
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.trips import Spot, Trips


@dataclass(frozen=True, slots=True)
class _Lack:
    """A budget that does not last: what a robot has and what it would need."""

    name: str
    there: float
    needed: float


def approaches_too_dear(
    graph: TaskGraph, places: Places, trips: Trips, returning: bool = False, chargers: Chargers = NO_CHARGERS
) -> list[Reason]:
    """
    Roles whose first place is so far from every robot of the type that what it has does not last for the way and the role.

    Where robots return, so does the way home count, from the role's last place. What robots can refill is left out.
    """
    if trips.scene.roads is not None and trips.scene.roads.lifts:
        return []
    lost = may_get_lost(graph, places)
    stands: dict[str, Stands] = {}
    asked: dict[object, _Lack | None] = {}  # roles that are alike are asked once
    reasons: list[Reason] = []
    for leaves in graph.roles.values():
        first = next((leaf for leaf in leaves if graph.tree.action(leaf).at is not None), None)
        kind = trips.fleet.by_id[graph.tree.action(leaves[0]).robot_type]
        if first is None or kind.id in lost or not kind.uses_per_m:
            continue
        refilled = chargers.of(kind)
        if kind.id not in stands:
            stands[kind.id] = _stands(kind, trips, refilled)
        need = {name: amount for name, amount in _need(graph, leaves).items() if name not in refilled}
        last = next(leaf for leaf in reversed(leaves) if graph.tree.action(leaf).at is not None)
        ends = places.of[last] if returning else _NOWHERE
        key = kind.id, places.of[first], ends, tuple(sorted(need.items()))
        if key not in asked:
            asked[key] = _lack(kind, stands[kind.id], need, (places.of[first], ends), trips)
        lack = asked[key]
        if lack is not None:
            reasons.append(_reason(kind, graph, first, lack, returning))
    return reasons


_NOWHERE: Spots = frozenset({None})
Stands = Collection[tuple[Spot, Mapping[str, float]]]


def may_get_lost(graph: TaskGraph, places: Places) -> set[str]:
    """Types with an action whose place may be unknown; their robots may be anywhere afterwards."""
    actions = ((leaf, graph.tree.action(leaf)) for leaves in graph.roles.values() for leaf in leaves)
    return {action.robot_type for leaf, action in actions if action.is_somewhere and None in places.of[leaf]}


def _stands(kind: RobotType, trips: Trips, refilled: Collection[str]) -> Stands:
    """Where the robots of a type start and what they have of what ways use; robots that are alike once."""
    found: dict[object, tuple[Spot, Mapping[str, float]]] = {}
    for robot, start in zip(kind.members, trips.starts(kind.id), strict=True):
        key = start, robot.remaining
        if key not in found:
            budgets = {**kind.limits, **robot.remaining}
            found[key] = start, {name: amount for name, amount in budgets.items() if name not in refilled}
    return found.values()


def _need(graph: TaskGraph, leaves: tuple[int, ...]) -> dict[str, float]:
    """What a role uses whatever happens, an approach not counted."""
    need: dict[str, float] = {}
    for leaf in leaves:
        for name, amount in least_use(graph.tree.action(leaf)).items():
            need[name] = need.get(name, 0.0) + amount
    return need


def _lack(
    kind: RobotType, stands: Stands, need: Mapping[str, float], ends: tuple[Spots, Spots], trips: Trips
) -> _Lack | None:
    """What the robot that comes nearest to having enough lacks; None if some robot has enough. ``ends``: first and last places."""
    nearest: _Lack | None = None
    for start, budgets in stands:
        metres = _metres(kind, (start,), ends[0], trips) + _metres(kind, ends[1], (start,), trips)
        lack = next(_lacking(kind, budgets, need, metres), None)
        if lack is None:
            return None
        if nearest is None or lack.needed - lack.there < nearest.needed - nearest.there:
            nearest = lack
    return nearest


def _lacking(
    kind: RobotType, budgets: Mapping[str, float], need: Mapping[str, float], metres: float
) -> Iterator[_Lack]:
    for name in dict.fromkeys((*kind.uses_per_m, *need)):
        there = budgets.get(name)
        needed = need.get(name, 0.0) + metres * kind.uses_per_m.get(name, 0.0)
        if there is not None and needed > there + TOLERANCE * max(1.0, there):
            yield _Lack(name, there, needed)


def _metres(kind: RobotType, origins: Collection[Spot], goals: Collection[Spot], trips: Trips) -> float:
    """The fewest metres from one of some spots to one of others; 0 where one of them is unknown."""
    if None in origins or None in goals:
        return 0.0
    ways = (trips.approach(kind.id, origin, goal) for origin in origins for goal in goals)
    return min((way.metres for way in ways if not isinstance(way, Blocked)), default=0.0)


def _reason(kind: RobotType, graph: TaskGraph, first: int, lack: _Lack, returning: bool) -> Reason:
    action, back = (
        graph.tree.action(first),
        ", do its part there and come home" if returning else " and do its part there",
    )
    return Reason(
        rule="budget_exceeded",
        message=f"No robot of type {kind.label!r} can get to {action.at}{back}: that takes at least "
        f"{lack.needed:g} of {lack.name}, and the nearest to it has {lack.there:g}.",
        node=action.text,
        robot=kind.id,
        found=f"{lack.name} {lack.there:g}",
        needed=f"{lack.name} {lack.needed:g}",
    )
