"""Different robots for roles that need them at once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from missiontree.scheduling.world_state import RobotState


def match(ranked: Mapping[int, Sequence[RobotState]]) -> dict[int, RobotState] | None:
    """Different robots for all groups (augmenting paths, breadth first), each as far up its list as it comes."""
    group_of: dict[str, int] = {}
    taken: dict[int, RobotState] = {}
    for group in ranked:
        came_from: dict[str, int] = {}
        queue, end = [group], None
        for here in queue:
            for robot in ranked[here]:
                if robot.id in came_from:
                    continue
                came_from[robot.id] = here
                if robot.id not in group_of:
                    end = robot
                    break
                queue.append(group_of[robot.id])
            if end is not None:
                break
        if end is None:
            return None
        robot = end
        while True:
            owner = came_from[robot.id]
            before = taken.get(owner)
            taken[owner], group_of[robot.id] = robot, owner
            if owner == group or before is None:
                break
            robot = before
    return taken
