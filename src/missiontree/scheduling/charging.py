"""What actions and ways use of the budgets of robots, of their types, and of the mission."""

from __future__ import annotations

from collections.abc import Mapping

from missiontree.mission.grounded import Action
from missiontree.mission.reason import Reason
from missiontree.scheduling.board import Board
from missiontree.scheduling.impossible import TOLERANCE
from missiontree.scheduling.stuck import StuckError
from missiontree.scheduling.trips import Trip
from missiontree.scheduling.world_state import RobotState


def charge(board: Board, robot: RobotState, action: Action, trip: Trip | None) -> None:
    """
    Take off what an action and the way to it use.

    Raises
    ------
    StuckError
        If a budget does not last.
    """
    spend(board, robot, action.uses, trip, action.text)


def spend(board: Board, robot: RobotState, uses: Mapping[str, float], trip: Trip | None, what: str) -> None:
    """
    Take off what is used for something, and on the way to it.

    Raises
    ------
    StuckError
        If a budget does not last; it names ``what``.
    """
    kind = board.problem.fleet.by_id[robot.type_id]
    use = dict(uses)
    if trip is not None:
        board.metres += trip.metres
        for name, amount in kind.uses_per_m.items():
            use[name] = use.get(name, 0.0) + amount * trip.metres
    for whose, left in ((robot.id, robot.left), (kind.id, board.totals[kind.id]), ("The mission", board.shared)):
        for name, amount in use.items():
            if name in left:
                left[name] -= amount
                if left[name] < -TOLERANCE:
                    raise StuckError(
                        Reason(
                            rule="budget_exceeded",
                            message=f"{whose} runs out of {name} at {what!r}, {-left[name]:g} short.",
                            node=what,
                            robot="" if left is board.shared else whose,
                        )
                    )
