"""
The refill bound: what robots must take in at chargers takes time, at their rates, and chargers have room for so many at once.

What the roles of a type use whatever happens, less what its robots hold at the start, is taken in before one role or other. Each way to
a charger, which no robot is at otherwise, takes time and uses something itself, and nobody takes in more than a full store at once. So
the type's robots have that much more to do (a load bound), and the chargers give that much (a load bound of theirs).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from missiontree.estimation.travel import Blocked
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.scheduling.chargers import Chargers, Station
from missiontree.scheduling.entries import NO_WAY, Entries, Entry
from missiontree.scheduling.impossible import TOLERANCE, least_use
from missiontree.scheduling.load import Piece, load_bound
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.staffing import Staffing
from missiontree.scheduling.trips import Spot, Trips

NOISE = 1e-6
"""Of amounts, and of the ticks that they take: what rounding may take away."""


class Lack(NamedTuple):
    """
    What the robots of a type must take in of a stock, at least.

    Parameters
    ----------
    stock
        Of what.
    amount
        How much.
    ticks
        How long refilling and the ways to it take, at the least.
    """

    stock: str
    amount: float
    ticks: int


def refill_bound(
    graph: TaskGraph,
    staffing: Staffing,
    pieces: Sequence[Piece],
    entries: Entries,
    fleet: Fleet,
    trips: Trips,
    chargers: Chargers,
) -> int:
    """
    Ticks below which no schedule with the refills it needs can be; 0 where none are needed.

    Parameters
    ----------
    graph, staffing
        An alternative.
    pieces
        Its roles as pieces of work, the least travel into them counted.
    entries
        The least travel into roles and to chargers.
    fleet, trips, chargers
        Robots, their starts and ways, and where they refill.
    """
    lacks: dict[str, list[Lack]] = {}
    for kind in fleet.types:
        own = [role for role in graph.roles if staffing.type_of[role] == kind.id]
        if own and kind.id in chargers.stations:
            ways = entries.chargers.get(kind.id, {})
            lacks[kind.id] = _lacks(kind, _needs(graph, own, entries.roles, kind), chargers, ways)
    lacks = {type_id: own for type_id, own in lacks.items() if own}
    if not lacks:
        return 0
    follows = {
        type_id: min(piece.hold + piece.tail for piece in pieces if piece.type_id == type_id) for type_id in lacks
    }
    more = [Piece(-1, type_id, -1, 0, lack.ticks, follows[type_id]) for type_id, own in lacks.items() for lack in own]
    load = load_bound([piece for piece in pieces if piece.type_id in lacks] + more, fleet)
    return max(load, _given(lacks, follows, entries, trips, chargers))


def _needs(graph: TaskGraph, roles: Sequence[int], entries: Mapping[int, Entry], kind: RobotType) -> dict[str, float]:
    """What the roles of a type use whatever happens, the least ways into them counted."""
    needs: dict[str, float] = {}
    for role in roles:
        for leaf in graph.roles[role]:
            for name, amount in least_use(graph.tree.action(leaf)).items():
                needs[name] = needs.get(name, 0.0) + amount
        if role in entries:
            for name, per_m in kind.uses_per_m.items():
                needs[name] = needs.get(name, 0.0) + per_m * entries[role].metres
    return needs


def _lacks(
    kind: RobotType, needs: Mapping[str, float], chargers: Chargers, approaches: Mapping[Spot, Entry]
) -> list[Lack]:
    """What robots of a type must take in, by stock."""
    found: list[Lack] = []
    for stock in sorted(chargers.of(kind)):
        stations = [station for station in chargers.stations[kind.id] if station.stock == stock]
        held = sorted((kind.budget(robot, stock) or 0.0 for robot in kind.members), reverse=True)[: kind.usable]
        amount = needs.get(stock, 0.0) - sum(held)
        if amount <= NOISE * (1.0 + needs.get(stock, 0.0)) + TOLERANCE * len(held):
            continue
        nearest = [approaches.get(station.spot, NO_WAY) for station in stations]
        metres, ticks = min(way.metres for way in nearest), min(way.ticks for way in nearest)
        amount, visits = _with_ways(amount, kind.uses_per_m.get(stock, 0.0) * metres, kind.limits[stock])
        amount *= 1 - NOISE
        rate = max(station.per_tick for station in stations)
        found.append(Lack(stock, amount, math.ceil(amount / rate * (1 - NOISE)) + visits * ticks))
    return found


def _with_ways(amount: float, way: float, full: float) -> tuple[float, int]:
    """What is to be taken in if each visit costs a way, and in how many visits, each of a full store at most."""
    if way >= full:
        return amount, 1
    visits = max(1, math.ceil(amount / (full - way) - NOISE))  # visits · full ≥ amount + visits · way
    return amount + visits * way, visits


def _given(
    lacks: Mapping[str, Sequence[Lack]], follows: Mapping[str, int], entries: Entries, trips: Trips, chargers: Chargers
) -> int:
    """The largest, over types alone and all together, of what chargers must give, over all that they can give at once."""
    best = 0
    for stock in sorted({lack.stock for own in lacks.values() for lack in own}):
        wanting = [type_id for type_id, own in lacks.items() if any(lack.stock == stock for lack in own)]
        for types in [wanting] if len(wanting) == 1 else [[one] for one in wanting] + [wanting]:
            amount = sum(lack.amount for type_id in types for lack in lacks[type_id] if lack.stock == stock)
            stations = {
                station.id: station
                for type_id in types
                for station in chargers.stations[type_id]
                if station.stock == stock
            }
            together = sum(station.per_tick * station.capacity for station in stations.values())
            first = min(
                _soonest(type_id, station, trips) if type_id in entries.chargers else 0
                for type_id in types
                for station in stations.values()
            )
            rest = min(follows[type_id] for type_id in types)
            best = max(best, first + math.ceil(amount / together * (1 - NOISE)) + rest)
    return best


def _soonest(type_id: str, station: Station, trips: Trips) -> int:
    """Ticks before which no robot of a type is at a charger, whatever it does before, if its places are all known."""
    starts = trips.starts(type_id)
    if None in starts or (trips.scene.roads is not None and trips.scene.roads.lifts):
        return 0
    ways = (trips.approach(type_id, start, station.spot) for start in dict.fromkeys(starts))
    return min((way.ticks for way in ways if not isinstance(way, Blocked)), default=0)
