"""When an action can start, and with whom."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from missiontree.estimation.travel import Blocked
from missiontree.mission.grounded import Action
from missiontree.mission.ticks import ticks
from missiontree.scheduling.board import Board
from missiontree.scheduling.casting import Casting
from missiontree.scheduling.demand import Demands
from missiontree.scheduling.detours import Detours, Stance
from missiontree.scheduling.passage import find_passage
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
    stances
        Where robots set out that go to a charger before, by role.
    departs
        When robots set out, by leaf, where what they hold on the way keeps them from doing so at once.
    """

    start: int
    robots: dict[int, RobotState]
    mates: dict[int, RobotState]
    stances: dict[int, Stance] = field(default_factory=dict)
    departs: Mapping[int, int] = field(default_factory=dict)


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
    board, casting, demands, detours
        The run, who may be taken, the ways, and where robots refill before.
    """

    def __init__(self, board: Board, casting: Casting, demands: Demands, detours: Detours) -> None:
        self._board, self._casting, self._demands, self._detours = board, casting, demands, detours

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
        stances = self._stances({role: robots[role] for role in opening})
        start = ready
        for _, action in actions:
            arrival = self._arrival(robots[action.role], action, ready, stances.get(action.role))
            start = max(start, arrival, board.world.not_before(action))
        departs: Mapping[int, int] = {}
        sharing = board.problem.sharing
        if activity in board.least_end or activity in sharing.demand or sharing.on_ways:
            spots = {role: stances[role].spot if role in stances else robot.spot for role, robot in robots.items()}
            trips = {leaf: self._demands.trip(spots[action.role], action) for leaf, action in actions}
            lasts = length(board, activity, trips)
            start = max(start, board.least_end.get(activity, 0) - lasts)
            open_ended = activity in board.graph.until or activity in board.problem.hand_overs.taker
            free = {role: stances[role].free_at if role in stances else robot.free_at for role, robot in robots.items()}
            free_of = {leaf: free[action.role] for leaf, action in actions}
            refills = [one for stance in stances.values() for one in stance.refills]
            found = find_passage(board, activity, free_of, trips, start, None if open_ended else lasts, refills)
            if found is None:
                return None
            start, departs = found.start, found.departs
        return Offer(start, robots, {role: chosen[role] for role in mates}, stances, departs)

    def _stances(self, opening: Mapping[int, RobotState]) -> dict[int, Stance]:
        """Where robots set out that must refill before their roles, none in another's way."""
        found: dict[int, Stance] = {}
        for role, robot in opening.items():
            if self._detours.refills(robot.type_id):
                taken = [one for stance in found.values() for one in stance.refills]
                stance = self._detours.before_role(role, robot, taken)
                if stance is not None and stance.refills:
                    found[role] = stance
        return found

    def stand_in(self, activity: int, free: int) -> object | None:
        """A key that activities share if one's offer is the other's; None if this one's is its own. Robots are free from ``free``."""
        board, joint = self._board, self._board.graph.activities[activity]
        role = board.role(activity)
        if (
            len(joint) > 1
            or activity in board.least_end
            or board.problem.leaving
            or board.problem.chargers
            or (board.rule.crew != "none" and len(board.crews[board.crew_of[role]]) > 1)
        ):
            return None
        return board.problem.alike[role], max(board.time[2 * activity], free)

    def _arrival(self, robot: RobotState, action: Action, ready: int, stance: Stance | None) -> int:
        """When the robot can begin the action."""
        spot, free_at = (robot.spot, robot.free_at) if stance is None else (stance.spot, stance.free_at)
        trip = self._demands.trip(spot, action)
        if isinstance(trip, Blocked):
            raise StuckError(trip.reason)
        return max(ready, free_at + (trip.ticks if trip is not None and not action.moves else 0))
