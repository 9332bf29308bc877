"""What keeps robots from a role, as far as a run has come: a budget, with what the role takes and what is left, or that there is no way."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from missiontree.estimation.travel import Blocked
from missiontree.mission.reason import Reason
from missiontree.scheduling.board import Board
from missiontree.scheduling.chargers import NOBODY
from missiontree.scheduling.demand import Demands
from missiontree.scheduling.impossible import TOLERANCE
from missiontree.scheduling.world_state import RobotState


class _Shortage(NamedTuple):
    """By how much a budget falls short, whose it is, its name, what the role takes of it, what is left, and what there was."""

    short: float
    whose: str
    name: str
    takes: float
    left: float
    limit: float


def shortage(board: Board, role: int) -> Reason | None:
    """
    The budget for want of which no robot takes a role; None if it is not for a budget.

    Parameters
    ----------
    board
        A run that came to a halt.
    role
        A role that nobody has taken yet. Of several robots, the one is told of that lacks least.
    """
    demands, nearest = Demands(board), None
    for robot in _free(board, role):
        demand = demands.ask(role, robot.spot)
        if demand is not None and board.problem.returning:
            demand = demands.home(demand, robot)
        if demand is None:
            continue
        lacking = max(_lacking(board, robot, demand.needs), default=None)
        if lacking is None:
            return None  # this one could pay, so that something else keeps it from the role
        nearest = lacking if nearest is None else min(nearest, lacking)
    return None if nearest is None else _reason(board, role, nearest)


def cut_off(board: Board, role: int) -> Reason | None:
    """That none of the robots that might take a role can get there from where it is by now; None if one can, or there is none."""
    demands, free = Demands(board), _free(board, role)
    action = board.graph.tree.action(board.graph.roles[role][0])
    ways = [demands.trip(robot.spot, action) for robot in free]
    blocked = [way for way in ways if isinstance(way, Blocked)]
    if not blocked or len(blocked) < len(ways):
        return None
    reason = blocked[0].reason
    return Reason(
        rule="unreachable",
        message=f"From where it is by then, {free[0].id} cannot get to {action.at} for {action.text!r}: {reason.message}",
        node=board.graph.name(board.graph.roles[role][0]),
        robot=board.staffing.type_of[role],
        found=reason.found,
        needed=action.at or "",
        hint=reason.hint,
    )


def _free(board: Board, role: int) -> list[RobotState]:
    """Robots that might take a role: the one that is bound to it, else all of its type that nothing holds."""
    bound = board.bound(role)
    if bound is not None:
        return [bound]
    type_id = board.staffing.type_of[role]
    return [robot for robot in board.world.robots.values() if robot.type_id == type_id and robot.role is None]


def _lacking(board: Board, robot: RobotState, needs: Mapping[str, float]) -> Iterator[_Shortage]:
    kind = board.problem.fleet.by_id[robot.type_id]
    refilled = board.problem.chargers.refilled.get(kind.id, NOBODY)
    own = {name: kind.budget(board.problem.fleet.robots[robot.id], name) or 0.0 for name in robot.left}
    together = f"all robots of type {kind.label!r} together", "all robots together"
    for name, takes in needs.items():
        for whose, left, limits in (
            (robot.id, {} if name in refilled else robot.left, own),
            (together[0], board.totals[kind.id], kind.total_limits),
            (together[1], board.shared, board.problem.shared),
        ):
            if name in left and takes > left[name] + TOLERANCE:
                yield _Shortage(takes - left[name], whose, name, takes, left[name], limits[name])


def _reason(board: Board, role: int, lacking: _Shortage) -> Reason:
    what = board.graph.name(board.graph.roles[role][0])
    return Reason(
        rule="budget_exceeded",
        message=f"{what!r} takes {lacking.takes:g} of {lacking.name}, and of the {lacking.limit:g} that {lacking.whose} may use "
        f"{lacking.left:g} is left.",
        node=what,
        robot=board.staffing.type_of[role],
        found=f"{lacking.name} {lacking.limit:g}",
        needed=f"{lacking.name} {lacking.limit - lacking.left + lacking.takes:g}",
    )
