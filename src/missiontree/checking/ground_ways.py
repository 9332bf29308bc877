"""Shortest ways over open ground: straight, or bending at corners of what is closed (the visibility graph)."""

from __future__ import annotations

import math
from collections.abc import Iterator

from missiontree.checking.closed import closed_areas, inside, passes_through
from missiontree.checking.dijkstra import shortest
from missiontree.mission.area import Area, Corner
from missiontree.mission.fleet import RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene


class GroundWays:
    """
    Open ground with closed areas in it.

    Parameters
    ----------
    scene
        Where the closed areas are.
    robot_type
        Who travels.
    """

    def __init__(self, scene: Scene, robot_type: RobotType) -> None:
        self._scene = scene
        self._type = robot_type
        self._closed: dict[str, tuple[Area, ...]] = {}

    def least(self, origin: Position, destination: Position, speed_mps: float | None) -> float:
        """See :class:`missiontree.checking.ways.Map`."""
        if origin.floor != destination.floor:
            return math.inf
        floor = origin.floor
        if floor not in self._closed:
            self._closed[floor] = closed_areas(self._type, self._scene, floor)
        metres = _round(self._closed[floor], (origin.x_m, origin.y_m), (destination.x_m, destination.y_m))
        return metres if speed_mps is None else metres / speed_mps


def _round(areas: tuple[Area, ...], start: Corner, goal: Corner) -> float:
    if any(inside(point, area) for point in (start, goal) for area in areas):
        return math.inf

    def free(first: Corner, second: Corner) -> bool:
        return not passes_through(first, second, areas)

    if free(start, goal):
        return math.dist(start, goal)
    corners = dict.fromkeys(corner for area in areas for corner in area.corners)
    stops = [goal, *(corner for corner in corners if not any(inside(corner, area) for area in areas))]

    def neighbours(point: Corner) -> Iterator[tuple[Corner, float]]:
        return ((other, math.dist(point, other)) for other in stops if other != point and free(point, other))

    return shortest([(start, 0.0)], neighbours).get(goal, math.inf)
