"""What a role is to the tour of its robot: where it takes it, how long, and what depends on where the robot comes from."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.estimation.travel import Blocked
from missiontree.mission.ticks import ticks
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.trips import Spot


@dataclass(frozen=True, slots=True)
class Stop:
    """
    A role as a stop of a tour.

    Parameters
    ----------
    first, last, entry_activity
        Activities that it begins and ends with, and that of the entry.
    entry
        Leaf that the robot must get to from wherever it is; None if the role is done anywhere, and leaves it there.
    moves
        Whether that leaf is itself the way there.
    before
        The activity of the role right before the entry; None if the entry is the first.
    origin, exit
        Where the entry is, and where the robot is afterwards.
    length
        Ticks from its first start to its last end, the way to the entry left out.
    """

    first: int
    last: int
    entry_activity: int
    entry: int | None
    moves: bool
    before: int | None
    origin: Spot
    exit: Spot
    length: int

    def left_at(self, spot: Spot) -> Spot:
        """Where a robot is after the role, if it came from a spot."""
        return spot if self.entry is None else self.exit


@dataclass(frozen=True, slots=True)
class Stops:
    """
    All roles of a problem.

    Parameters
    ----------
    of
        Stop of each role.
    lasts
        Ticks of each activity, without what depends on the robot's whereabouts.
    lags
        Ticks of the way before an activity inside a role, and the activity that it begins after.
    """

    of: dict[int, Stop]
    lasts: list[int]
    lags: list[tuple[int, int, int]]


def stops_of(problem: Problem) -> Stops | None:
    """The roles as stops; None if something may be in several places, or lasts until something else ends."""
    graph = problem.graph
    if graph.until:
        return None
    lasts = [0] * len(graph.activities)
    lags: list[tuple[int, int, int]] = []
    found: dict[int, Stop] = {}
    for role, leaves in graph.roles.items():
        stop = _stop(problem, leaves, lasts, lags)
        if stop is None:
            return None
        found[role] = stop
    return Stops(found, lasts, lags)


def _stop(problem: Problem, leaves: tuple[int, ...], lasts: list[int], lags: list[tuple[int, int, int]]) -> Stop | None:
    graph = problem.graph
    entry, spot, origin, before, length = -1, None, None, None, 0
    for place, leaf in enumerate(leaves):
        action, activity = graph.tree.action(leaf), graph.activity_of[leaf]
        takes = 0 if action.moves else ticks(action.duration_s)
        if action.is_somewhere:
            spots = problem.places.of[leaf]
            if len(spots) > 1:
                return None
            there = next(iter(spots))
            if entry < 0:
                entry, origin = leaf, there
                before = graph.activity_of[leaves[place - 1]] if place else None
            else:
                trip = problem.trips.trip(action, spot, there)
                if isinstance(trip, Blocked):
                    return None
                if action.moves:
                    takes = trip.ticks
                else:
                    lags.append((graph.activity_of[leaves[place - 1]], activity, trip.ticks))
                    length += trip.ticks
            spot = there
        lasts[activity] = max(lasts[activity], takes)
        length += takes
    first, last = graph.activity_of[leaves[0]], graph.activity_of[leaves[-1]]
    if entry < 0:
        return Stop(first, last, first, None, False, None, None, None, length)
    moves = graph.tree.action(entry).moves
    return Stop(first, last, graph.activity_of[entry], entry, moves, before, origin, spot, length)
