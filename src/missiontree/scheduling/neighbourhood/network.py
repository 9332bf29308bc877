"""Longest paths through a mission whose robots make given tours: when everything is at the earliest, and how much comes after."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from operator import add

from missiontree.estimation.travel import Blocked
from missiontree.mission.ticks import ticks
from missiontree.scheduling.neighbourhood.stops import Stop, Stops
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.trips import Spot

FAR = 1 << 60
"""Of a way that is blocked."""

_Arcs = Mapping[int, Sequence[tuple[int, int]]]
"""By event, the events after it and the ticks between."""


@dataclass(frozen=True, slots=True)
class Paths:
    """
    Longest paths.

    Parameters
    ----------
    head
        Earliest time of each event.
    tail
        Ticks from each event to the end, along the longest path.
    makespan
        The end.
    more
        Arcs that tours add: by event, the events after it and the ticks between.
    """

    head: list[int]
    tail: list[int]
    makespan: int
    more: _Arcs


class Network:
    """
    Events and the arcs between them that no tour changes.

    Parameters
    ----------
    problem, stops
        The mission and its roles.
    """

    def __init__(self, problem: Problem, stops: Stops) -> None:
        self._problem, self._graph, self._stops = problem, problem.graph, stops
        self.start: dict[str, Spot] = {}
        self.since: dict[str, int] = {}
        for kind in problem.fleet.types:
            for robot, start in zip(kind.members, problem.trips.starts(kind.id), strict=True):
                self.start[robot.id] = start
                self.since[robot.id] = ticks(kind.availability(robot)[0])
        self._ways: dict[tuple[int, Spot], int] = {}
        self._homes: dict[tuple[str, Spot], int] = {}
        self._fixed: list[list[tuple[int, int]]] = [[(after, 0) for after in later] for later in self._graph.successors]
        activities = range(len(self._graph.activities))
        for activity in activities:
            lasts = stops.lasts[activity]
            own = self._fixed[2 * activity]
            self._fixed[2 * activity] = [one for one in own if one[0] != 2 * activity + 1] + [(2 * activity + 1, lasts)]
        for first, second, lag in stops.lags:
            self._fixed[2 * first + 1].append((2 * second, lag))
        self._missing = [0] * len(self._fixed)
        for later in self._fixed:
            for after, _ in later:
                self._missing[after] += 1
        self._release = {2 * activity: release for activity, release in self._graph.release.items()}
        self._leading: dict[int, bool] = {}

    def way(self, role: int, spot: Spot) -> int:
        """Ticks of the way to a role's entry."""
        key = (role, spot)
        found = self._ways.get(key)
        if found is None:
            stop = self._stops.of[role]
            if stop.entry is None:
                return 0
            trip = self._problem.trips.trip(self._graph.tree.action(stop.entry), spot, stop.origin)
            found = self._ways[key] = FAR if isinstance(trip, Blocked) else trip.ticks
        return found

    def home(self, robot: str, spot: Spot) -> int:
        """Ticks of a robot's way home from a spot, where robots return."""
        if not self._problem.returning:
            return 0
        found = self._homes.get((robot, spot))
        if found is None:
            trip = self._problem.trips.approach(self._problem.fleet.type_of[robot].id, spot, self.start[robot])
            found = self._homes[robot, spot] = FAR if isinstance(trip, Blocked) else trip.ticks
        return found

    def waiting(self, role: int, paths: Paths) -> set[int]:
        """Events that come after the start of a role that is in no tour, because of orders and then of other tours."""
        leads = self._leading.get(role)
        if leads is None:
            leads = self._leading[role] = self._leads(role)
        return self._after(role, paths.more) if leads else set()

    def _leads(self, role: int) -> bool:
        """Whether something of another role must come after something of a role, or is done jointly with it."""
        own = {self._graph.activity_of[leaf] for leaf in self._graph.roles[role]}
        after = {event // 2 for event in self._after(role, {}) if event < 2 * len(self._graph.activities)}
        return bool(after - own) or any(len(self._graph.activities[activity]) > 1 for activity in own)

    def _after(self, role: int, more: _Arcs) -> set[int]:
        seen, left = set[int](), [2 * self._stops.of[role].first]
        while left:
            event = left.pop()
            for after, _ in (*self._fixed[event], *more.get(event, ())):
                if after not in seen:
                    seen.add(after)
                    left.append(after)
        return seen

    def measured(self, tours: Mapping[str, Sequence[int]]) -> Paths | None:
        """The longest paths, with tours; None if something would wait for itself."""
        more, missing = dict[int, list[tuple[int, int]]](), list(self._missing)
        head, tail = [0] * len(missing), [0] * len(missing)
        for event, release in self._release.items():
            head[event] = release
        for robot, roles in tours.items():
            spot, end, free = self.start[robot], -1, self.since[robot]
            for role in roles:
                stop = self._stops.of[role]
                self._add(more, missing, head, stop, self.way(role, spot), end, free)
                spot, end, free = stop.left_at(spot), 2 * stop.last + 1, 0
            if roles:
                tail[end] = self.home(robot, spot)
        order = self._heads(head, more, missing)
        if len(order) < len(missing):
            return None
        self._tails(tail, more, order)
        return Paths(head, tail, max(map(add, head, tail), default=0), more)

    def _heads(self, head: list[int], more: _Arcs, missing: list[int]) -> list[int]:
        """Earliest times, into ``head``, and the order of events in which they came about; without those that wait for themselves."""
        fixed = self._fixed
        ready = [event for event, count in enumerate(missing) if not count]
        for event in ready:  # grows as it is walked
            at = head[event]
            for later in (fixed[event], more[event]) if event in more else (fixed[event],):
                for after, lag in later:
                    if at + lag > head[after]:  # noqa: PLR1730 - a call for each arc would take half as long again
                        head[after] = at + lag
                    missing[after] -= 1
                    if not missing[after]:
                        ready.append(after)
        return ready

    def _tails(self, tail: list[int], more: _Arcs, order: Sequence[int]) -> None:
        """Longest paths to the end, into ``tail``, which holds what comes after the last arc."""
        fixed = self._fixed
        for event in reversed(order):
            longest = tail[event]
            for later in (fixed[event], more[event]) if event in more else (fixed[event],):
                for after, lag in later:
                    if tail[after] + lag > longest:  # noqa: PLR1730 - as above
                        longest = tail[after] + lag
            tail[event] = longest

    @staticmethod
    def _add(
        more: dict[int, list[tuple[int, int]]],
        missing: list[int],
        head: list[int],
        stop: Stop,
        way: int,
        end: int,
        free: int,
    ) -> None:
        """What follows from a stop's place in a tour."""
        first, entry = 2 * stop.first, 2 * stop.entry_activity
        direct = stop.before is None and not stop.moves
        if end >= 0:
            more.setdefault(end, []).append((first, way if direct else 0))
            missing[first] += 1
        else:
            head[first] = max(head[first], free + (way if direct else 0))
        if direct:
            return
        if stop.moves:
            more.setdefault(entry, []).append((entry + 1, way))
            missing[entry + 1] += 1
        else:
            assert stop.before is not None
            more.setdefault(2 * stop.before + 1, []).append((entry, way))
            missing[entry] += 1
