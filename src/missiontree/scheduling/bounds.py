"""
Lower bounds on the makespan: no schedule of the alternative can be shorter, whichever robots are taken.

Five of them. *Critical path*: the longest chain of actions that must follow each other, travel included where both ends are certain.
*Load*: what the robots of a type must do, shared evenly among them, after the earliest that any of it can begin and before the
least that must still follow (the subset bound of parallel machines with heads and tails). *Resource load*: the same of what a shared
resource must be held for, and the robots that it has room for. *Refill load*: what robots must take in at chargers, see
:mod:`missiontree.scheduling.refilling`. *Spanning tree*: the load with the least ways that connect it, see
:mod:`missiontree.scheduling.spanning`.
"""

from __future__ import annotations

import heapq
import itertools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from missiontree.estimation.travel import Blocked
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import Action
from missiontree.mission.position import Position
from missiontree.mission.ticks import ticks
from missiontree.scheduling.chargers import NO_CHARGERS, Chargers
from missiontree.scheduling.entries import least_entries
from missiontree.scheduling.load import holding_bound, load_bound, pieces_of
from missiontree.scheduling.places import MANY_SPOTS, Places, Spots
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.refilling import refill_bound
from missiontree.scheduling.role_spots import first_spots
from missiontree.scheduling.sharing import NOTHING_SHARED, Sharing
from missiontree.scheduling.spanning import spanning_bound
from missiontree.scheduling.staffing import Staffing
from missiontree.scheduling.trips import Spot, Trips

NEVER = 1 << 62
"""A tick that never comes."""


@dataclass(slots=True)
class Bounds:
    """
    What is known before any schedule is made, in ticks.

    Parameters
    ----------
    makespan
        No schedule is shorter.
    method
        ``critical_path``, ``load``, ``resource_load``, ``refill_load`` or ``spanning_tree``: which bound is the largest.
    duration
        Least duration of each activity.
    lag
        Least travel inside a role from the end of the action before to the start of an action, by leaf.
    heads, tails
        For each event, the least time before it, and the least time from it to the end of the mission.
    entries
        Least travel into a role, by role; see :mod:`missiontree.scheduling.entries`.
    latest
        For each event, the last tick at which it may be if all deadlines are to be kept; ``NEVER`` where none depends on it. Empty if there
        is no deadline.
    homes
        Where robots return: least ticks home from the last place of a role, by its last leaf; leaves with 0 are left out.
    due
        For each event, how urgent it is: ``latest``, or the last tick at which everything can still end by ``makespan``, or by the last
        deadline of all if that is later.
    """

    makespan: int
    method: str
    duration: list[int]
    lag: dict[int, int] = field(default_factory=dict)
    heads: list[int] = field(default_factory=list)
    tails: list[int] = field(default_factory=list)
    entries: Mapping[int, int] = field(default_factory=dict)
    latest: list[int] = field(default_factory=list)
    due: list[int] = field(default_factory=list)
    homes: Mapping[int, int] = field(default_factory=dict)


def lower_bounds(
    graph: TaskGraph,
    order: Sequence[int],
    staffing: Staffing,
    places: Places,
    fleet: Fleet,
    trips: Trips,
    sharing: Sharing = NOTHING_SHARED,
    returning: bool = False,
    chargers: Chargers = NO_CHARGERS,
) -> Bounds:
    """
    Bounds of one alternative.

    Parameters
    ----------
    graph, order
        A task graph without a cycle, and its events in order.
    staffing
        Types and groups of the roles.
    places
        Where actions can possibly happen.
    fleet, trips
        Robots and ways.
    sharing
        Shared resources and who holds them. Default: none.
    returning
        Whether the mission lasts until every robot that takes part is home. Default false.
    chargers
        Where robots refill, and may be beside. Default: nowhere.
    """
    travel = _Travel(graph, staffing, places, trips, chargers)
    duration = [_least_duration(graph, activity, travel) for activity in range(len(graph.activities))]
    lag = {
        leaf: travel.before(leaf)
        for leaves in graph.roles.values()
        for leaf in leaves[1:]
        if not graph.tree.action(leaf).moves
    }
    release = _releases(graph, travel, duration, fleet)
    homes = travel.homes(staffing) if returning else {}
    heads, tails = _longest_paths(graph, order, duration, lag, release, homes)
    path = max((head + tail for head, tail in zip(heads, tails, strict=True)), default=0)
    entries = least_entries(graph, staffing, places, trips, chargers)
    plain = pieces_of(graph, staffing, duration, lag, heads, tails)
    ways = entries.ticks
    forms = [plain, pieces_of(graph, staffing, duration, lag, heads, tails, ways)] if ways else [plain]
    found = {
        "critical_path": path,
        "load": max(load_bound(pieces, fleet) for pieces in forms),
        "resource_load": holding_bound(sharing, duration, heads, tails),
        "refill_load": max(refill_bound(graph, staffing, own, entries, fleet, trips, chargers) for own in forms),
        "spanning_tree": spanning_bound(graph, staffing, duration, lag, tails, places, fleet, trips, chargers),
    }
    makespan = max(found.values())
    method = next(name for name, bound in found.items() if bound == makespan)  # the plainest of the largest
    latest = _latest(graph, order, duration, lag) if graph.deadline else []
    end = max(makespan, *graph.deadline.values()) if graph.deadline else makespan
    due = [min(end - tail, last) for tail, last in zip(tails, latest or [NEVER] * len(tails), strict=True)]
    return Bounds(makespan, method, duration, lag, heads, tails, ways, latest, due, homes)


class _Travel:
    """Least travel to each action."""

    def __init__(self, graph: TaskGraph, staffing: Staffing, places: Places, trips: Trips, chargers: Chargers) -> None:
        self._graph, self._places, self._trips = graph, places, trips
        begins = first_spots(graph, staffing, places, trips, chargers)
        self.previous: dict[int, Spots | None] = {}  # where the robot is before a leaf; None: anywhere
        visited: dict[str, set[Spot]] = {}
        for role, leaves in graph.roles.items():
            spots = visited.setdefault(staffing.type_of[role], set())
            here: Spots | None = begins.get(role)
            for leaf in leaves:
                action, there = graph.tree.action(leaf), places.of[leaf]
                self.previous[leaf] = here
                if action.is_somewhere:
                    here = there
                    spots |= there
        self._starts = {kind: set(trips.starts(kind)) for kind in visited}
        self._visited = visited
        self._arrivals = {kind: self._least_arrivals(kind) for kind in visited}

    def before(self, leaf: int) -> int:
        """Least travel inside a role before an action, or as the move that it is."""
        action, there = self._graph.tree.action(leaf), self._places.of[leaf]
        if action.moves:
            return self._least_move(action, self.previous.get(leaf), there)
        here = self.previous.get(leaf)
        if action.at is None or here is None or None in there or None in here:
            return 0
        return self._least(action, here, there)

    def arrival(self, leaf: int) -> int:
        """Ticks before which no robot of the type can be where the action is, or where the move goes."""
        action, there = self._graph.tree.action(leaf), self._places.of[leaf]
        if None in there:
            return 0
        arrivals = self._arrivals[action.robot_type]
        return min((arrivals.get(spot, 0) for spot in there), default=0)

    def _least_move(self, action: Action, here: Spots | None, there: Spots) -> int:
        nominal = ticks(action.duration_s)
        if there == {None} or not self._trips.speed_known(action.robot_type):
            return nominal
        if here is None:
            return 0 if self._visited[action.robot_type] - {None} else nominal
        known = self._least(action, here - {None}, there - {None})
        return min(known, nominal) if None in here or None in there else known

    def _least(self, action: Action, here: Spots, there: Spots) -> int:
        if len(here) * len(there) > MANY_SPOTS * MANY_SPOTS:
            return 0
        trips = (self._trips.trip(action, origin, destination) for origin in here for destination in there)
        return min((trip.ticks for trip in trips if not isinstance(trip, Blocked)), default=0)

    def homes(self, staffing: Staffing) -> dict[int, int]:
        """Least ticks home after each role, by its last leaf."""
        found: dict[int, int] = {}
        back = {kind: self._least_arrivals(kind, home=True) for kind in self._visited}
        for role, leaves in self._graph.roles.items():
            actions = ((leaf, self._graph.tree.action(leaf)) for leaf in reversed(leaves))
            last = next((leaf for leaf, action in actions if action.is_somewhere), None)
            if last is None:
                continue
            ways = back[staffing.type_of[role]]
            least = min((ways.get(spot, 0) for spot in self._places.of[last]), default=0)
            if least:
                found[leaves[-1]] = least
        return found

    def _least_arrivals(self, kind: str, home: bool = False) -> dict[Spot, int]:
        """
        Least time to each spot of the type over any chain of legs (Dijkstra); empty if a spot on the way may be unknown.

        With ``home``, from each spot to the nearest start, the legs backwards.
        """
        starts, spots = self._starts[kind], self._visited[kind]
        if None in starts or None in spots or len(starts | spots) > MANY_SPOTS:
            return {}
        best: dict[Spot, int] = dict.fromkeys(starts, 0)
        queue = [(0, number, spot) for number, spot in enumerate(sorted(starts, key=repr))]
        counter = len(queue)
        while queue:
            time, _, spot = heapq.heappop(queue)
            if time > best[spot]:
                continue
            for after in sorted(spots, key=repr):
                assert isinstance(spot, Position)
                assert isinstance(after, Position)
                trip = self._trips.approach(kind, after, spot) if home else self._trips.approach(kind, spot, after)
                if isinstance(trip, Blocked) or time + trip.ticks >= best.get(after, time + trip.ticks + 1):
                    continue
                best[after] = time + trip.ticks
                counter += 1
                heapq.heappush(queue, (best[after], counter, after))
        return best


def _least_duration(graph: TaskGraph, activity: int, travel: _Travel) -> int:
    if activity in graph.until:
        return 0
    actions = ((leaf, graph.tree.action(leaf)) for leaf in graph.activities[activity])
    return max(travel.before(leaf) if action.moves else ticks(action.duration_s) for leaf, action in actions)


def _releases(graph: TaskGraph, travel: _Travel, duration: Sequence[int], fleet: Fleet) -> dict[int, int]:
    """
    Ticks before which an action with a place cannot start, or a move cannot end, and those before which nothing may start.

    What a role does before its first place is done by a robot that stands still, so it comes on top of every way there.
    """
    still = _stood_still(graph, duration)
    there = {kind.id: ticks(min(kind.availability(robot)[0] for robot in kind.members)) for kind in fleet.types}
    release: dict[int, int] = {}
    for activity, leaves in enumerate(graph.activities):
        for leaf in leaves:
            action = graph.tree.action(leaf)
            if since := there[action.robot_type]:
                release[2 * activity] = max(release.get(2 * activity, 0), since)
            if action.at is not None:
                event = 2 * activity + action.moves
                begin = since + travel.arrival(leaf) + still.get(leaf, 0)
                release[event] = max(release.get(event, 0), begin)
    for activity, earliest in graph.release.items():
        release[2 * activity] = max(release.get(2 * activity, 0), earliest)
    return release


def _stood_still(graph: TaskGraph, duration: Sequence[int]) -> dict[int, int]:
    """Least time that a role takes before its first action with a place, by that action."""
    still: dict[int, int] = {}
    for leaves in graph.roles.values():
        ticks_before = 0
        for leaf in leaves:
            action = graph.tree.action(leaf)
            if action.is_somewhere:
                still[leaf] = ticks_before
                break
            ticks_before += duration[graph.activity_of[leaf]]
    return still


def _longest_paths(
    graph: TaskGraph,
    order: Sequence[int],
    duration: Sequence[int],
    lag: dict[int, int],
    release: dict[int, int],
    homes: Mapping[int, int],
) -> tuple[list[int], list[int]]:
    heads = [release.get(event, 0) for event in range(len(graph.successors))]
    tails = [0] * len(heads)
    for leaf, home in homes.items():
        tails[graph.end(leaf)] = max(tails[graph.end(leaf)], home)
    weight = weights(graph, duration, lag)
    for event in order:
        for after in graph.successors[event]:
            heads[after] = max(heads[after], heads[event] + weight(event, after))
    for event in reversed(order):
        for after in graph.successors[event]:
            tails[event] = max(tails[event], tails[after] + weight(event, after))
    return heads, tails


def weights(graph: TaskGraph, duration: Sequence[int], lag: Mapping[int, int]) -> Callable[[int, int], int]:
    """The least time between two events of which one is a successor of the other."""
    between = {
        (graph.end(before), graph.start(after)): lag.get(after, 0)
        for leaves in graph.roles.values()
        for before, after in itertools.pairwise(leaves)
    }

    def weight(event: int, after: int) -> int:
        if event % 2 == 0 and after == event + 1 and event // 2 < len(duration):
            return duration[event // 2]
        return between.get((event, after), 0)

    return weight


def _latest(graph: TaskGraph, order: Sequence[int], duration: Sequence[int], lag: Mapping[int, int]) -> list[int]:
    """See :class:`Bounds`."""
    latest, weight = [NEVER] * len(graph.successors), weights(graph, duration, lag)
    for activity, deadline in graph.deadline.items():
        latest[2 * activity + 1] = deadline
    for event in reversed(order):
        for after in graph.successors[event]:
            if latest[after] != NEVER:
                latest[event] = min(latest[event], latest[after] - weight(event, after))
    return latest
