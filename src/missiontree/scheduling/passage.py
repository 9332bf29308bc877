"""
Ways that lead along a road or by a lift that robots share: what an activity holds on them, and when its robots may set out.

A robot holds such a resource on the whole way, from when it sets out until it arrives; a move is its own way. Models and trials leave
this out of account, so that they ask for less than the mission does; what they find is played through with it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from missiontree.estimation.travel import Blocked
from missiontree.scheduling.board import Board
from missiontree.scheduling.problem import Refill
from missiontree.scheduling.room import Hold, room_for
from missiontree.scheduling.trips import Trip

Trips = Mapping[int, Trip | Blocked | None]


@dataclass(frozen=True, slots=True)
class Passage:
    """
    How an activity gets through.

    Parameters
    ----------
    start
        Its earliest start, in ticks.
    departs
        When robots set out for it, by leaf, where they cannot do so at once.
    """

    start: int
    departs: Mapping[int, int] = field(default_factory=dict)


def wanted_by(board: Board, activity: int, trips: Trips) -> dict[str, int]:
    """What an activity holds while it is done, its moves included: robots by resource, each robot once."""
    wanted: dict[str, int] = {}
    for leaf, action in board.actions(activity):
        trip = trips[leaf]
        along = trip.holds if action.moves and isinstance(trip, Trip) else ()
        for name in dict.fromkeys((*action.holds, *along)):
            if name in board.held:
                wanted[name] = wanted.get(name, 0) + 1
    return wanted


def ways_held(refills: Iterable[Refill]) -> dict[str, list[Hold]]:
    """What is held on ways to chargers that robots are about to go, by resource."""
    found: dict[str, list[Hold]] = {}
    for refill in refills:
        for name in refill.trip.holds:
            found.setdefault(name, []).append(refill.way_hold)
    return found


def find_passage(
    board: Board,
    activity: int,
    free: Mapping[int, int],
    trips: Trips,
    start: int,
    lasts: int | None,
    refills: Sequence[Refill] = (),
) -> Passage | None:
    """
    When an activity can start with all the room that it and the ways to it need; None if some of it is held nobody knows how long.

    Parameters
    ----------
    board, activity
        The run, and what is to be placed.
    free, trips
        When the robots of it can set out, refilled if they must be, and their ways, by leaf.
    start
        Not before.
    lasts
        How long it takes; None if nobody knows yet.
    refills
        Visits to chargers that they are about to make before. Default: none.
    """
    givers = board.problem.hand_overs.givers(activity)  # they let go when it starts
    own = ways_held(refills)
    departs: dict[int, int] = {}

    def held(name: str) -> list[Hold]:
        return [hold for one, hold in board.held[name].items() if one not in givers] + own.get(name, [])

    for leaf, action in board.actions(activity):
        trip = trips[leaf]
        if action.moves or not isinstance(trip, Trip) or not trip.holds:
            continue
        departs_at = room_for(board.problem.sharing, dict.fromkeys(trip.holds, 1), held, free[leaf], trip.ticks)
        if departs_at is None:
            return None
        departs[leaf] = departs_at
        start = max(start, departs_at + trip.ticks + _room_to_come(board, givers, trip))
        for name in trip.holds:
            own.setdefault(name, []).append(Hold(departs_at, departs_at + trip.ticks, 1))
    found = room_for(board.problem.sharing, wanted_by(board, activity, trips), held, start, lasts)
    return None if found is None else Passage(found, departs)


def _room_to_come(board: Board, givers: Sequence[int], trip: Trip) -> int:
    """Ticks that must lie between the arrival of who takes over and its start: a giver that holds the same comes after it."""
    lengths = [
        done.end - done.start
        for giver in givers
        if set(trip.holds) & board.wanted.get(giver, {}).keys()
        for done in (board.done[leaf] for leaf, _ in board.placed[giver])
    ]
    return max(lengths, default=0)


def hold_ways(board: Board, trips: Trips, departs: Mapping[int, int]) -> None:
    """The ways to an activity are taken."""
    for leaf, departs_at in departs.items():
        trip = trips[leaf]
        assert isinstance(trip, Trip)
        for name in trip.holds:
            board.held[name][-1 - leaf] = Hold(departs_at, departs_at + trip.ticks, 1)
