"""Ways home: where robots return, each that takes part goes back to where it started, right after its last action."""

from __future__ import annotations

from missiontree.estimation.travel import Blocked
from missiontree.mission.reason import Reason
from missiontree.mission.ticks import seconds
from missiontree.scheduling.approach_budget import may_get_lost
from missiontree.scheduling.board import Board
from missiontree.scheduling.bounds import Bounds
from missiontree.scheduling.charging import spend
from missiontree.scheduling.detours import Detours
from missiontree.scheduling.places import Places
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.problem import Homeward
from missiontree.scheduling.room import Hold, room_for
from missiontree.scheduling.stuck import StuckError
from missiontree.scheduling.trips import Trip, Trips
from missiontree.scheduling.world_state import RobotState

RULE = "no_way_home"
_WAYS_HOME = -(1 << 40)
"""Below all numbers of activities and of ways to actions."""


def go_home(board: Board, detours: Detours) -> None:
    """
    Take every robot that has done something home, if the mission asks for it.

    Raises
    ------
    StuckError
        If there is no way, or a budget does not last for it.
    """
    if not board.problem.returning:
        return
    robots = (board.world.robots[name] for name in {one.robot for one in board.done.values()})
    for robot in sorted(
        robots, key=lambda one: (one.free_at, one.id)
    ):  # who is done first has first go at what robots share
        if detours.refills(robot.type_id) and (stance := detours.before_home(robot)) is not None:
            detours.visit(robot, stance.refills)
        trip = board.problem.trips.approach(robot.type_id, robot.spot, robot.home)
        if isinstance(trip, Blocked):
            raise StuckError(_blocked(f"{robot.id} ends where no way leads home", trip, robot.id))
        spend(board, robot, {}, trip, "its way home")
        leaves_at = _sets_out(board, robot, trip)
        board.returns.append(Homeward(robot.id, trip, leaves_at, leaves_at + trip.ticks))
        robot.spot, robot.stand, robot.free_at = robot.home, robot.home_stand, leaves_at + trip.ticks


def _sets_out(board: Board, robot: RobotState, trip: Trip) -> int:
    """When a robot can go home: as soon as there is room in what it holds on the way."""
    wanted = dict.fromkeys(trip.holds, 1)
    found = room_for(board.problem.sharing, wanted, lambda name: board.held[name].values(), robot.free_at, trip.ticks)
    assert found is not None, "everything else is over at some time"
    for name in trip.holds:
        board.held[name][_WAYS_HOME - robot.index] = Hold(found, found + trip.ticks, 1)
    return found


def never_home(graph: TaskGraph, places: Places, trips: Trips) -> list[Reason]:
    """Roles that end where no way leads to any start of the robots of their type; what comes after them makes no way either."""
    reasons: dict[str, Reason] = {}
    lost = may_get_lost(graph, places)
    for leaves in graph.roles.values():
        last = next((leaf for leaf in reversed(leaves) if graph.tree.action(leaf).at is not None), None)
        if last is None or graph.tree.action(last).robot_type in lost:
            continue
        action = graph.tree.action(last)
        ways = [
            trips.approach(action.robot_type, spot, home)
            for spot in places.of[last]
            for home in dict.fromkeys(trips.starts(action.robot_type))
        ]
        blocked = [way for way in ways if isinstance(way, Blocked)]
        if len(blocked) == len(ways):
            kind = trips.fleet.by_id[action.robot_type]
            reason = _blocked(f"No robot of type {kind.label!r} gets home from {action.at}", blocked[0], kind.id)
            reasons.setdefault(kind.id, reason)
    return list(reasons.values())


def home_too_late(bounds: Bounds, home_by: int | None) -> list[Reason]:
    """Why not all robots can be home by the mission's deadline; empty if nothing shows that."""
    if home_by is None or bounds.makespan <= home_by:
        return []
    return [
        Reason(
            rule="deadline_missed",
            message=f"All robots must be home by {seconds(home_by):g} s, and cannot before {seconds(bounds.makespan):g} s.",
            found=f"{seconds(bounds.makespan):g} s",
            needed=f"by {seconds(home_by):g} s",
            hint=f"Move the deadline by {seconds(bounds.makespan - home_by):g} s or more, or let robots stay out.",
        )
    ]


def _blocked(what: str, way: Blocked, robot: str) -> Reason:
    return Reason(
        rule=RULE,
        message=f"{what}: {way.reason.message}",
        robot=robot,
        found=way.reason.found,
        hint=way.reason.hint or "Open a way back, or let robots stay out.",
    )
