"""What a role asks of a robot: its way to the first action and its use of budgets, as far as can be foreseen."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field

from missiontree.estimation.travel import Blocked
from missiontree.mission.grounded import Action
from missiontree.scheduling.board import Board
from missiontree.scheduling.trips import Spot, Trip
from missiontree.scheduling.world_state import RobotState


@dataclass(frozen=True, slots=True)
class Demand:
    """
    What a role asks of a robot that stands somewhere.

    Parameters
    ----------
    way
        Ticks of the way to its first action, or of the move that it is.
    metres
        Metres of it.
    needs
        What the role uses of each budget.
    ends
        Where the role leaves the robot, if everything that it does not move itself stays where it is.
    after
        Ticks of the way home after it, if that is part of it.
    levels
        What the role alone uses of what robots of its type can refill.
    """

    way: int
    metres: float
    needs: Mapping[str, float] = field(default_factory=dict)
    ends: Spot = None
    after: int = 0
    levels: Mapping[str, float] = field(default_factory=dict)


class Demands:
    """
    Demands of roles, remembered per spot until something is moved; roles that are alike share them.

    Parameters
    ----------
    board
        The run.
    """

    def __init__(self, board: Board) -> None:
        self._board, self._world = board, board.world
        fleet = board.problem.fleet
        self._per_m = {kind.id: dict(kind.uses_per_m) for kind in fleet.types}
        self._limited = {
            kind.id: {
                *kind.limits,
                *kind.total_limits,
                *board.problem.shared,
                *(name for robot in kind.robots for name in robot.remaining),
            }
            for kind in fleet.types
        }
        self._asks_walk = {
            kind.id: bool(kind.uses_per_m) or board.problem.returning or kind.id in board.problem.chargers.stations
            for kind in fleet.types
        }
        self._found: dict[int, dict[int, Demand | None]] = {}
        self._moves = 0

    def of(self, role: int) -> dict[int, Demand | None]:
        """What is remembered of roles like this one, by number of the spot; ask :meth:`ask` for what is not there."""
        if self._moves != self._world.moves:
            self._found.clear()
            self._moves = self._world.moves
        return self._found.setdefault(self._board.problem.alike[role], {})

    def ask(self, role: int, spot: Spot) -> Demand | None:
        """What a role asks of a robot at a spot; None if there is no way to its first action."""
        trip = self.trip(spot, self._board.graph.tree.action(self._board.graph.roles[role][0]))
        if isinstance(trip, Blocked):
            return None
        way, metres = (0, 0.0) if trip is None else (trip.ticks, trip.metres)
        whole_m, ends = self._walk(spot, role) if self._asks_walk[self._board.staffing.type_of[role]] else (0.0, spot)
        whole_m = max(whole_m, metres)
        return Demand(way, metres, self._needs(role, whole_m), ends, levels=self._levels(role, whole_m))

    def home(self, demand: Demand, robot: RobotState) -> Demand | None:
        """A demand with the way home after it; None if there is none."""
        trip = self._board.problem.trips.approach(robot.type_id, demand.ends, robot.home)
        if isinstance(trip, Blocked):
            return None
        needs = dict(demand.needs)
        for name, amount in self._per_m[robot.type_id].items():
            if name in self._limited[robot.type_id]:
                needs[name] = needs.get(name, 0.0) + amount * trip.metres
        return Demand(demand.way, demand.metres, needs, robot.home, trip.ticks, demand.levels)

    def trip(self, spot: Spot, action: Action) -> Trip | Blocked | None:
        """The way to an action; None if it can be done anywhere."""
        if action.at is None and not action.moves:
            return None
        destination = self._world.spot(action)
        if destination is None and not action.moves:
            return None
        return self._board.problem.trips.trip(action, spot, destination)

    def _needs(self, role: int, metres: float) -> dict[str, float]:
        board, type_id = self._board, self._board.staffing.type_of[role]
        if not self._limited[type_id]:
            return {}
        needs = dict(board.problem.needs[board.staffing.group_of[role]])
        if self._per_m[type_id]:
            uses = self._uses_of(role)
            for name, amount in self._per_m[type_id].items():
                needs[name] = max(needs.get(name, 0.0), uses.get(name, 0.0) + amount * metres)
        return {name: amount for name, amount in needs.items() if name in self._limited[type_id]}

    def _levels(self, role: int, metres: float) -> dict[str, float]:
        type_id = self._board.staffing.type_of[role]
        names = self._board.problem.chargers.refilled.get(type_id, ())
        uses, per_m = (self._uses_of(role), self._per_m[type_id]) if names else ({}, {})
        return {name: uses.get(name, 0.0) + per_m.get(name, 0.0) * metres for name in sorted(names)}

    def _uses_of(self, role: int) -> dict[str, float]:
        uses: dict[str, float] = {}
        for leaf in self._board.graph.roles[role]:
            for name, amount in self._board.graph.tree.action(leaf).uses.items():
                uses[name] = uses.get(name, 0.0) + amount
        return uses

    def _walk(self, spot: Spot, role: int) -> tuple[float, Spot]:
        """Metres of a whole role, and where it ends, if everything that it does not move itself stays where it is."""
        metres, here = 0.0, spot
        moved: dict[str, Spot] = {}
        for leaf in self._board.graph.roles[role]:
            action = self._board.graph.tree.action(leaf)
            there = moved[action.at] if action.at in moved else self._world.spot(action)
            if action.is_somewhere:
                trip = self._board.problem.trips.trip(action, here, there)
                metres += 0.0 if isinstance(trip, Blocked) else trip.metres
                here = there
            moved |= dict.fromkeys(action.brings, there)
        return metres, here


def lasts(
    demand: Demand,
    robot: RobotState,
    pooled: Sequence[Mapping[str, float]],
    slack: float,
    refilled: Collection[str] = (),
) -> bool:
    """
    Whether the robot's budgets, and those it shares with others, last for a demand; what is not limited always does.

    What the robot can refill (``refilled``) is no budget of its own.
    """
    return all(
        amount <= left.get(name, amount) + slack
        for name, amount in demand.needs.items()
        for left in ((robot.left, *pooled) if name not in refilled else pooled)
    )
