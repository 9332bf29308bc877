"""
The bound by spanning trees: what the robots of a type must do, with the least ways that connect all of it, shared evenly among them.

Whatever tours robots make, their ways connect every role that has a place with where some robot starts. No set of ways does that in less
than a minimum spanning tree takes (Held and Karp, Operations Research 18, 1970, bound tours by such trees; Prim 1957 makes one).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from missiontree.estimation.travel import Blocked
from missiontree.mission.control import never
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.ticks import ticks
from missiontree.scheduling.chargers import Chargers
from missiontree.scheduling.own_work import own_work
from missiontree.scheduling.places import MANY_SPOTS, Places, Spots
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.staffing import Staffing
from missiontree.scheduling.trips import Trips


@dataclass(frozen=True, slots=True)
class _Stay:
    """Where a role is begun, and where it leaves its robot; each perhaps at one of several spots."""

    entry: Spots
    exit: Spots


def spanning_bound(
    graph: TaskGraph,
    staffing: Staffing,
    duration: Sequence[int],
    lag: Mapping[int, int],
    tails: Sequence[int],
    places: Places,
    fleet: Fleet,
    trips: Trips,
    chargers: Chargers,
    many: int = MANY_SPOTS,
    over: Callable[[], bool] = never,
) -> int:
    """
    The largest bound over all types, in ticks; 0 if none can be told.

    A type is left out if it is not known where its robots start, where they go or how fast, if they may come by chargers on the way, or if
    one waits for others at the first place of a role.

    Parameters
    ----------
    graph, staffing, places
        What is done, by which type, and where it may be.
    duration, lag, tails
        Of activities, of ways inside roles, and after events; see :class:`missiontree.scheduling.bounds.Bounds`.
    fleet, trips, chargers
        Robots and their ways.
    many
        Places of a type beyond which it is left out. Default 48.
    over
        Asked now and then whether time is up; then what is not told yet is not told. Default: it never is.
    """
    by_type: dict[str, list[int]] = {}
    for role in graph.roles:
        by_type.setdefault(staffing.type_of[role], []).append(role)
    best = 0
    for type_id, roles in by_type.items():
        kind = fleet.by_id[type_id]
        stays = _stays(graph, places, roles)
        if stays is None or chargers.stations.get(type_id) or not trips.speed_known(type_id):
            continue
        tree = _tree(kind, [*stays.values()], trips, many, over)
        if not tree:
            continue
        work = sum(own_work(graph, duration, lag, role, _first(graph, role)) for role in roles)
        since = ticks(min(kind.availability(robot)[0] for robot in kind.members))
        rest = min(tails[graph.end(graph.roles[role][-1])] for role in roles)
        best = max(best, since - (-(work + tree) // kind.usable) + rest)
    return best


def _first(graph: TaskGraph, role: int) -> int | None:
    """The first action of a role with a place."""
    return next((leaf for leaf in graph.roles[role] if graph.tree.action(leaf).is_somewhere), None)


def _stays(graph: TaskGraph, places: Places, roles: Sequence[int]) -> dict[int, _Stay] | None:
    """Roles with a place, and where they are; None if that is not known, or if what is first there lasts until something else ends."""
    found: dict[int, _Stay] = {}
    for role in roles:
        placed = [leaf for leaf in graph.roles[role] if graph.tree.action(leaf).is_somewhere]
        if not placed:
            continue
        stay = _Stay(places.of[placed[0]], places.of[placed[-1]])
        if graph.activity_of[placed[0]] in graph.until or None in stay.entry | stay.exit:
            return None
        found[role] = stay
    return found


def _tree(kind: RobotType, stays: Sequence[_Stay], trips: Trips, many: int, over: Callable[[], bool]) -> int:
    """Ticks of a minimum spanning tree over the places of roles and, as one, all starts; 0 if there is none, or too little time for it."""
    starts = frozenset(trips.starts(kind.id))
    if None in starts or len(starts.union(*(stay.entry | stay.exit for stay in stays))) > many:
        return 0
    root = _Stay(frozenset(), starts)
    near = [_way(kind, root, stay, trips) for stay in stays]
    left, total = set(range(len(stays))), 0
    while left:
        nearest = min(left, key=lambda number: (_far(near[number]), number))
        way = near[nearest]
        if way is None or over():
            return 0
        left.discard(nearest)
        total += way
        for number in left:
            between = (
                _way(kind, stays[nearest], stays[number], trips),
                _way(kind, stays[number], stays[nearest], trips),
            )
            near[number] = min((near[number], *between), key=_far)
    return total


def _way(kind: RobotType, before: _Stay, after: _Stay, trips: Trips) -> int | None:
    """Least ticks from where one role may leave a robot to where another may begin; None if there is no way."""
    found = (trips.approach(kind.id, origin, goal) for origin in before.exit for goal in after.entry)
    return min((trip.ticks for trip in found if not isinstance(trip, Blocked)), default=None)


def _far(way: int | None) -> float:
    return float("inf") if way is None else way
