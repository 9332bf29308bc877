"""Why a run came to a halt with work left: who is held, and what waits."""

from __future__ import annotations

from missiontree.mission.reason import Reason
from missiontree.scheduling.board import Board
from missiontree.scheduling.shortage import cut_off, shortage


def deadlock_reason(board: Board) -> Reason:
    """The first action that finds no robot, and the robots that are held meanwhile, or what keeps them from it."""
    held = [robot for robot in board.world.robots.values() if robot.role is not None]
    roles = board.graph.tree.roles
    waits = [activity for activity in range(len(board.graph.activities)) if activity not in board.placed]
    waits = [activity for activity in waits if not board.missing[2 * activity]] or waits
    first = board.graph.activities[waits[0]][0]
    what, type_id = board.graph.name(first), board.graph.tree.action(first).robot_type
    if not held and (leaving := _leaving(board, type_id)):
        return Reason(
            rule="robot_away",
            message=f"{what!r} finds no robot that is there long enough: {', '.join(leaving[:4])}.",
            node=what,
            robot=type_id,
            found=leaving[0],
            hint="Let a robot stay longer (available_until_s), or add another.",
        )
    role = board.graph.tree.action(first).role
    if not held and (kept_from := shortage(board, role) or cut_off(board, role)) is not None:
        return kept_from
    who = ", ".join(f"{robot.id} in {roles[robot.role].label!r}" for robot in held[:4] if robot.role is not None)
    return Reason(
        rule="deadlock",
        message=f"{what!r} finds no robot"
        + (f" while {who} {'is' if len(held) == 1 else 'are'} held, waiting." if held else " that may do it."),
        node=what,
        robot=type_id,
        hint="Another robot of that type, or another order, may resolve it.",
    )


def _leaving(board: Board, type_id: str) -> list[str]:
    """Robots of a type that leave, each with when it does."""
    kind = board.problem.fleet.by_id[type_id]
    until = ((robot.id, kind.availability(robot)[1]) for robot in kind.members)
    return [f"{name} leaves at {seconds:g} s" for name, seconds in until if seconds is not None]
