"""Why a run came to a halt with work left: who is held, and what waits."""

from __future__ import annotations

from missiontree.mission.reason import Reason
from missiontree.scheduling.board import Board


def deadlock_reason(board: Board) -> Reason:
    """The first action that finds no robot, and the robots that are held meanwhile."""
    held = [robot for robot in board.world.robots.values() if robot.role is not None]
    roles = board.graph.tree.roles
    waits = [activity for activity in range(len(board.graph.activities)) if activity not in board.placed]
    waits = [activity for activity in waits if not board.missing[2 * activity]] or waits
    first = board.graph.activities[waits[0]][0]
    what = board.graph.name(first)
    who = ", ".join(f"{robot.id} in {roles[robot.role].label!r}" for robot in held[:4] if robot.role is not None)
    return Reason(
        rule="deadlock",
        message=f"{what!r} finds no robot"
        + (f" while {who} {'is' if len(held) == 1 else 'are'} held, waiting." if held else " that may do it."),
        node=what,
        robot=board.graph.tree.action(first).robot_type,
        hint="Another robot of that type, or another order, may resolve it.",
    )
