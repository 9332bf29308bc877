"""When an action can start, and with whom."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from missiontree.estimation.travel import Blocked
from missiontree.mission.grounded import Action
from missiontree.mission.ticks import ticks
from missiontree.scheduling.board import Board
from missiontree.scheduling.casting import Casting
from missiontree.scheduling.demand import Demands
from missiontree.scheduling.stuck import StuckError
from missiontree.scheduling.trips import Trip
from missiontree.scheduling.world_state import RobotState


@dataclass(slots=True)
class Offer:
    """
    An activity as it could be put into the schedule next.

    Parameters
    ----------
    start
        Its earliest start, in ticks.
    robots
        Who does it, by role.
    mates
        Robots taken at once for roles that begin later, by role.
    """

    start: int
    robots: dict[int, RobotState]
    mates: dict[int, RobotState]


def length(board: Board, activity: int, trips: Mapping[int, Trip | Blocked | None]) -> int:
    """Ticks that an activity takes by itself: as long as the slowest of those who do it; trips by leaf."""
    if activity in board.graph.until:
        return 0
    return max(
        trip.ticks if action.moves and isinstance(trip := trips[leaf], Trip) else ticks(action.duration_s)
        for leaf, action in board.actions(activity)
    )


class Placing:
    """
    Finds the earliest place of an activity.

    Parameters
    ----------
    board, casting, demands
        The run, who may be taken, and the ways.
    """

    def __init__(self, board: Board, casting: Casting, demands: Demands) -> None:
        self._board, self._casting, self._demands = board, casting, demands

    def offer(self, activity: int) -> Offer | None:
        """The earliest start with robots that are free; None if a robot, a thing or a shared resource is held nobody knows how long."""
        board = self._board
        ready, actions = board.time[2 * activity], board.actions(activity)
        if board.waiting and board.awaits(activity):
            return None
        opening = [action.role for _, action in actions if not board.begun[action.role]]
        mates: list[int] = []
        if opening and board.rule.crew != "none":
            crew = board.crews[board.crew_of[opening[0]]]
            mates = [role for role in crew if role not in opening and not board.secured(role)]
        chosen = self._casting.choose(opening, mates, ready) if opening else {}
        if chosen is None:
            return None
        robots = {
            action.role: board.robot_of_group[board.staffing.group_of[action.role]]
            for _, action in actions
            if board.begun[action.role]
        }
        robots |= {role: chosen[role] for role in opening}
        start = ready
        for _, action in actions:
            start = max(start, self._arrival(robots[action.role], action, ready), board.world.not_before(action))
        if activity in board.least_end or activity in board.problem.sharing.demand:
            trips = {leaf: self._demands.trip(robots[action.role].spot, action) for leaf, action in actions}
            lasts = length(board, activity, trips)
            start = max(start, board.least_end.get(activity, 0) - lasts)
            open_ended = activity in board.graph.until or activity in board.problem.hand_overs.taker
            found = board.room(activity, start, None if open_ended else lasts)
            if found is None:
                return None
            start = found
        return Offer(start, robots, {role: chosen[role] for role in mates})

    def stand_in(self, activity: int, free: int) -> object | None:
        """A key that activities share if one's offer is the other's; None if this one's is its own. Robots are free from ``free``."""
        board, joint = self._board, self._board.graph.activities[activity]
        role = board.role(activity)
        if (
            len(joint) > 1
            or activity in board.least_end
            or board.problem.leaving
            or (board.rule.crew != "none" and len(board.crews[board.crew_of[role]]) > 1)
        ):
            return None
        return board.problem.alike[role], max(board.time[2 * activity], free)

    def _arrival(self, robot: RobotState, action: Action, ready: int) -> int:
        """When the robot can begin the action."""
        trip = self._demands.trip(robot.spot, action)
        if isinstance(trip, Blocked):
            raise StuckError(trip.reason)
        return max(ready, robot.free_at + (trip.ticks if trip is not None and not action.moves else 0))
