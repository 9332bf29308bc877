"""
Detours to chargers: where a robot refills between two roles, so that its levels last for what comes next.

A robot goes to a charger only if its levels do not last for its next role and, if more is to come for its type, for the way to a charger
afterwards. Of all ways over up to four chargers the one that lets it begin soonest is taken; at chargers on the way to the last it fills
up, and at the last takes in what is asked for, or all that it holds, as the run decides, or what lasts for the rest of its roles, where
they are known; before its last role, and on its way home, no more than is asked for.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from missiontree.estimation.travel import Blocked
from missiontree.scheduling.board import Board
from missiontree.scheduling.chargers import Station
from missiontree.scheduling.charging import spend
from missiontree.scheduling.demand import Demand, Demands
from missiontree.scheduling.impossible import TOLERANCE
from missiontree.scheduling.passage import ways_held
from missiontree.scheduling.problem import Refill
from missiontree.scheduling.room import Hold, first_room, room_for
from missiontree.scheduling.trips import Spot, Trip
from missiontree.scheduling.world_state import RobotState

MOST_STOPS = 4
"""Chargers that a robot goes to one after the other before it does something."""

_WAYS_TO_CHARGERS = -(1 << 41)
"""Below all numbers of activities, of ways to actions and of ways home."""

Levels = Mapping[str, float]


class Asked(NamedTuple):
    """What comes next asks of a robot at a spot: ticks to get to it, the levels that it needs, and those that would spare it a visit."""

    way: int
    needed: Levels
    wished: Levels


Ask = Callable[[Spot], Asked | None]
"""From a spot; None if there is no way."""


@dataclass(frozen=True, slots=True)
class Stance:
    """
    A robot where it sets out for what comes next.

    Parameters
    ----------
    spot, free_at
        Where, and from when.
    refills
        Its visits to chargers before; none if it sets out from where it is.
    stranded
        Whether it may get to no charger afterwards, though more is to come.
    """

    spot: Spot
    free_at: int
    refills: tuple[Refill, ...] = ()
    stranded: bool = False


@dataclass(frozen=True, slots=True)
class _Stop:
    """A robot on its way over chargers: from when it may go on, from where, with which levels, after which visits."""

    free_at: int
    spot: Spot
    levels: Levels
    refills: tuple[Refill, ...] = ()


class Detours:
    """
    Finds detours in one run.

    Parameters
    ----------
    board, demands
        The run, and what roles ask of robots.
    """

    def __init__(self, board: Board, demands: Demands) -> None:
        self._board, self._demands, self._chargers = board, demands, board.problem.chargers
        self._known: dict[tuple[int, str], tuple[object, Stance | None]] = {}  # with all that the answer depends on
        self._per_m = {kind.id: dict(kind.uses_per_m) for kind in board.problem.fleet.types}

    def refills(self, type_id: str) -> bool:
        """Whether robots of a type can refill anything."""
        return type_id in self._chargers.stations

    def before_role(
        self,
        role: int,
        robot: RobotState,
        taken: Sequence[Refill] = (),
        more: bool | None = None,
        later: Sequence[int] = (),
    ) -> Stance | None:
        """
        Where a robot sets out for a role; None if its levels cannot last for it.

        Parameters
        ----------
        role, robot
            What comes next, for whom.
        taken
            Visits to chargers that others are about to make.
        more
            Whether something is to come for the robot after the role. Default: if so many roles of its type have not begun that the
            other robots cannot take one each; where robots fill up, if there is any.
        later
            Roles that the robot does afterwards, one after the other, for which it had better refill at once. Default: it is not known.
        """
        if more is None:
            others = self._board.problem.fleet.by_id[robot.type_id].usable - 1
            more = self._board.open_roles[robot.type_id] - 1 > (others if self._board.rule.refill == "enough" else 0)
        if taken or later or self._board.problem.sharing.on_ways:  # then ways of others change what is soonest, too
            return self._seek(role, robot, taken, more=more, later=later)
        board, levels = self._board, tuple(robot.left[name] for name in sorted(self._chargers.refilled[robot.type_id]))
        state = robot.free_at, robot.stand, levels, len(board.refills), board.world.moves, more
        key = board.problem.alike[role], robot.id
        if key not in self._known or self._known[key][0] != state:
            self._known[key] = state, self._seek(role, robot, (), more=more)
        return self._known[key][1]

    def _seek(
        self, role: int, robot: RobotState, taken: Sequence[Refill], *, more: bool, later: Sequence[int] = ()
    ) -> Stance | None:
        full = more and self._board.rule.refill == "full"
        for careful in (True, False):
            asked = self._asked(role, robot, more=more, careful=careful, later=later)
            stance = self._find(robot, asked, taken, full=full)
            if stance is not None:
                return stance if careful else Stance(stance.spot, stance.free_at, stance.refills, stranded=True)
        return None

    def before_home(self, robot: RobotState) -> Stance | None:
        """Where a robot sets out for its home; None if its levels cannot last for it."""

        def ask(spot: Spot) -> Asked | None:
            trip = self._board.problem.trips.approach(robot.type_id, spot, robot.home)
            if isinstance(trip, Blocked):
                return None
            spent = self._spent(robot, trip.metres)
            return Asked(trip.ticks, spent, spent)

        return self._find(robot, ask, (), full=False)

    def demand(self, role: int, spot: Spot) -> Demand | None:
        """What a role asks of a robot at a spot; None if there is no way to its first action."""
        known, stand = self._demands.of(role), self._board.world.number(spot)
        if stand not in known:
            known[stand] = self._demands.ask(role, spot)
        return known[stand]

    def visit(self, robot: RobotState, refills: Sequence[Refill]) -> None:
        """Let a robot refill; it is there, with higher levels, afterwards."""
        board = self._board
        full = board.problem.fleet.by_id[robot.type_id].limits
        for one in refills:
            station = one.station
            spend(board, robot, {}, one.trip, f"its way to {station.id}")
            robot.left[station.stock] = min(full[station.stock], robot.left[station.stock] + one.amount)
            robot.spot, robot.stand, robot.free_at = station.spot, board.world.number(station.spot), one.end
            board.refills.append(one)
            board.plugged.setdefault(station.id, []).append(Hold(one.start, one.end, 1))
            for name in one.trip.holds:
                board.held[name][_WAYS_TO_CHARGERS - len(board.refills)] = one.way_hold

    # --- seeking ----------------------------------------------------------------------------------------------------

    def _asked(self, role: int, robot: RobotState, *, more: bool, careful: bool, later: Sequence[int]) -> Ask:
        def ask(spot: Spot) -> Asked | None:
            demand = self.demand(role, spot)
            if demand is None:
                return None
            if not careful:
                return Asked(demand.way, demand.levels, demand.levels)
            reserve = self._reserve(robot, demand.ends, more)
            if reserve is None:
                return None
            needed = {name: level + reserve[name] for name, level in demand.levels.items()}
            wished: Levels = {}
            if later or (self._board.problem.returning and not more):
                rest = self._rest(robot, demand.ends, later)
                wished = {name: demand.levels[name] + level for name, level in rest.items()}
            return Asked(demand.way, needed, wished)

        return ask

    def _rest(self, robot: RobotState, spot: Spot, later: Sequence[int]) -> Levels:
        """What roles, one after the other, and the way home take from a spot on, if no charger is visited; nothing if there is no way."""
        total = dict.fromkeys(self._chargers.refilled[robot.type_id], 0.0)
        for role in later:
            demand = self.demand(role, spot)
            if demand is None:
                return {}
            spot = demand.ends
            for name in total:
                total[name] += demand.levels[name]
        if self._board.problem.returning:
            trip = self._board.problem.trips.approach(robot.type_id, spot, robot.home)
            if isinstance(trip, Blocked):
                return {}
            for name, level in self._spent(robot, trip.metres).items():
                total[name] += level
        return total

    def _reserve(self, robot: RobotState, spot: Spot, more: bool) -> Levels | None:
        """What must be left at the end of a role: for the way to a charger, or home; None if there is no way."""
        returning, trips = self._board.problem.returning, self._board.problem.trips
        refilled = self._chargers.refilled[robot.type_id]
        if not more and not returning:
            return dict.fromkeys(refilled, 0.0)
        found: dict[str, float] = {}
        for name in refilled:
            goals: list[Spot] = [one.spot for one in self._chargers.stations[robot.type_id] if one.stock == name]
            if returning and not more:
                goals.append(robot.home)
            ways = [trips.approach(robot.type_id, spot, goal) for goal in goals]
            metres = [way.metres for way in ways if not isinstance(way, Blocked)]
            if not metres:
                return None
            found[name] = self._per_m[robot.type_id].get(name, 0.0) * min(metres)
        return found

    def _spent(self, robot: RobotState, metres: float) -> Levels:
        per_m = self._per_m[robot.type_id]
        return {name: per_m.get(name, 0.0) * metres for name in self._chargers.refilled[robot.type_id]}

    def _find(self, robot: RobotState, ask: Ask, taken: Sequence[Refill], *, full: bool) -> Stance | None:
        """The soonest way on; ``full``: at the last charger, too, a robot fills up."""
        levels = {name: robot.left[name] for name in self._chargers.refilled[robot.type_id]}
        asked = ask(robot.spot)
        if asked is not None and _lasts(levels, asked.needed):
            return Stance(robot.spot, robot.free_at)
        stops = [(robot.free_at, 0, _Stop(robot.free_at, robot.spot, levels))]
        best: tuple[int, _Stop] | None = None
        seen: set[object] = set()
        count = 0
        while stops and (best is None or stops[0][0] < best[0]):
            _, _, stop = heapq.heappop(stops)
            where = stop.refills[-1].station.id if stop.refills else ""
            key = where, frozenset(one.station.stock for one in stop.refills)
            if key in seen:
                continue
            seen.add(key)
            for station in self._chargers.stations[robot.type_id]:
                if station.id == where:
                    continue
                for needed in (ask(station.spot), None):
                    reached = self._refilled(robot, stop, station, needed, taken, full=full)
                    if reached is None:
                        continue
                    if needed is not None:
                        begin = reached.free_at + needed.way
                        best = (begin, reached) if best is None or begin < best[0] else best
                    elif len(reached.refills) < MOST_STOPS:
                        count += 1
                        heapq.heappush(stops, (reached.free_at, count, reached))
        return None if best is None else Stance(best[1].spot, best[1].free_at, best[1].refills)

    def _refilled(
        self,
        robot: RobotState,
        stop: _Stop,
        station: Station,
        asked: Asked | None,
        taken: Sequence[Refill],
        *,
        full: bool,
    ) -> _Stop | None:
        """A visit to one more charger: with what is needed from there on, or else filled up; None if that cannot be."""
        board, stock = self._board, station.stock
        trip = board.problem.trips.approach(robot.type_id, stop.spot, station.spot)
        if isinstance(trip, Blocked):
            return None
        spent = self._spent(robot, trip.metres)
        levels = {name: level - spent[name] for name, level in stop.levels.items()}
        most = board.problem.fleet.by_id[robot.type_id].limits[stock]
        if any(level < -TOLERANCE for level in levels.values()):
            return None
        target = most
        if asked is not None:
            others = {name: level for name, level in asked.needed.items() if name != stock}
            if asked.needed[stock] > most + TOLERANCE or not _lasts(levels, others):
                return None
            if not full:
                target = min(most, max(asked.needed[stock], asked.wished.get(stock, 0.0)))
        amount = target - levels[stock]
        if amount <= TOLERANCE:
            return None
        leaves = self._sets_out(stop, trip, taken)
        if leaves is None:
            return None
        arrives, lasts = leaves + trip.ticks, station.lasts(amount)
        held = [Hold(one.start, one.end, 1) for one in taken if one.station.id == station.id]
        start = first_room([*board.plugged.get(station.id, ()), *held], station.capacity, 1, arrives, lasts)
        assert start is not None, "visits to chargers have an end"
        refill = Refill(robot.id, station, trip, leaves, arrives, start, start + lasts, amount)
        return _Stop(start + lasts, station.spot, {**levels, stock: target}, (*stop.refills, refill))

    def _sets_out(self, stop: _Stop, trip: Trip, taken: Sequence[Refill]) -> int | None:
        """When a robot can go on to a charger: once there is room in what it holds on the way; None if nobody knows when."""
        board, others = self._board, ways_held(taken)

        def held(name: str) -> list[Hold]:
            return [*board.held[name].values(), *others.get(name, ())]

        return room_for(board.problem.sharing, dict.fromkeys(trip.holds, 1), held, stop.free_at, trip.ticks)


def _lasts(levels: Levels, needed: Levels) -> bool:
    return all(levels[name] >= amount - TOLERANCE for name, amount in needed.items())
