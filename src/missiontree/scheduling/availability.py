"""Robots that come late or leave early: proofs that all of a type have left too early, and whether a draft keeps to their times."""

from __future__ import annotations

from missiontree.mission.fleet import Fleet
from missiontree.mission.reason import Reason
from missiontree.mission.ticks import seconds, ticks_within
from missiontree.scheduling.bounds import Bounds
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.problem import Done, Draft, Homeward, Problem

RULE = "robot_away"


def some_leave(fleet: Fleet) -> bool:
    """Whether some robot leaves before the end."""
    return any(
        kind.available_until_s is not None or any(robot.available_until_s is not None for robot in kind.robots)
        for kind in fleet.types
    )


def least_holds(graph: TaskGraph, bounds: Bounds) -> dict[int, int]:
    """Ticks from the start of each role's first action to the end of its last at least; a move at its beginning counts nothing."""
    holds = {}
    for role, leaves in graph.roles.items():
        moved = bounds.duration[graph.activity_of[leaves[0]]] if graph.tree.action(leaves[0]).moves else 0
        spans = (bounds.duration[graph.activity_of[leaf]] + bounds.lag.get(leaf, 0) for leaf in leaves)
        holds[role] = sum(spans) - moved
    return holds


def gone_before(graph: TaskGraph, bounds: Bounds, fleet: Fleet) -> list[Reason]:
    """Actions that cannot end before every robot of their type has left; the latest of each type is told."""
    latest: dict[str, int] = {}
    for kind in fleet.types:
        ends = [kind.availability(robot)[1] for robot in kind.members]
        known = [end for end in ends if end is not None]
        if len(known) == len(ends):
            latest[kind.id] = ticks_within(max(known))
    late: dict[str, tuple[int, int]] = {}
    for leaf, activity in graph.activity_of.items():
        kind_id, end = graph.tree.action(leaf).robot_type, bounds.heads[2 * activity + 1] + bounds.homes.get(leaf, 0)
        if kind_id in latest and end > latest[kind_id]:
            late[kind_id] = max(late.get(kind_id, (0, 0)), (end, leaf))
    return [
        Reason(
            rule=RULE,
            message=f"{_what(graph, bounds, leaf)} before {_shown(end)}, and the last robot of type {kind_id} leaves at "
            f"{_shown(latest[kind_id])}.",
            node=graph.name(leaf),
            robot=kind_id,
            found=f"until {_shown(latest[kind_id])}",
            needed=f"until {_shown(end)}",
            hint="Let a robot stay longer (available_until_s), or give the task another way of being done.",
        )
        for kind_id, (end, leaf) in sorted(late.items())
    ]


def away(problem: Problem, draft: Draft) -> tuple[Reason, ...]:
    """Robots that a draft keeps longer than they stay, each with its last action."""
    if not problem.leaving:
        return ()
    spans: list[Done | Homeward] = [*draft.done, *draft.returns]
    last = {one.robot: one for one in sorted(spans, key=lambda one: one.end)}
    reasons = []
    for robot, one in sorted(last.items()):
        kind = problem.fleet.type_of[robot]
        until_s = kind.availability(problem.fleet.robots[robot])[1]
        if until_s is not None and one.end > ticks_within(until_s):
            reasons.append(
                Reason(
                    rule=RULE,
                    message=f"{robot} leaves at {until_s:g} s; a try kept it until {_shown(one.end)}.",
                    node=problem.graph.name(one.leaf) if isinstance(one, Done) else "its way home",
                    robot=robot,
                    found=f"until {until_s:g} s",
                    needed=f"until {_shown(one.end)}",
                    hint="Nothing proves that no schedule keeps to it; let the robot stay longer, or add another.",
                )
            )
    return tuple(reasons)


def _what(graph: TaskGraph, bounds: Bounds, leaf: int) -> str:
    home = f"After {graph.name(leaf)!r} nobody can be home" if bounds.homes.get(leaf) else ""
    return home or f"{graph.name(leaf)!r} cannot end"


def _shown(count: int) -> str:
    return f"{seconds(count):g} s"
