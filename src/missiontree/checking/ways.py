"""
How far it is, worked out afresh: shortest ways on the road graph, on the grid, or straight round what is closed.

It shares nothing with the travel model that plans are made with, so that a fault there shows here.
"""

from __future__ import annotations

import math
from typing import Protocol

from missiontree.checking.grid_ways import GridWays
from missiontree.checking.ground_ways import GroundWays
from missiontree.checking.road_ways import RoadWays
from missiontree.mission.fleet import RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Leg


class Map(Protocol):
    """Shortest ways of one robot type on one kind of map."""

    def least(self, origin: Position, destination: Position, speed_mps: float | None) -> float:
        """Metres of the shortest way, or seconds of the quickest at a speed; infinite if there is none."""
        ...


class Ways:
    """
    The checker's own distances in a scene, remembered.

    Parameters
    ----------
    scene
        The world, introduced entities included.
    """

    def __init__(self, scene: Scene) -> None:
        self._scene = scene
        self._maps: dict[str, Map] = {}
        self._known: dict[tuple[str, Position, Position, float | None], float] = {}

    def shortest_m(self, robot_type: RobotType, origin: Position, destination: Position) -> float:
        """Metres of the shortest way that a type may take; infinite if there is none."""
        return self._least(robot_type, origin, destination, None)

    def quickest_s(self, robot_type: RobotType, origin: Position, destination: Position, speed_mps: float) -> float:
        """Seconds of the quickest way at a speed, rides in lifts included; infinite if there is none."""
        return self._least(robot_type, origin, destination, speed_mps)

    def via_problem(self, robot_type: RobotType, leg: Leg) -> str:
        """What is wrong with the road nodes that a leg names, or leaves out; empty if nothing is."""
        roads = self._map(robot_type)
        if isinstance(roads, RoadWays):
            return roads.problem(leg)
        return "names road nodes where there is no road graph" if leg.via else ""

    def named_s(self, robot_type: RobotType, leg: Leg, speed_mps: float) -> float:
        """Seconds that the road nodes of a leg take at a speed, rides in lifts included; 0 where they are no way."""
        roads = self._map(robot_type)
        return roads.named_s(leg, speed_mps) if isinstance(roads, RoadWays) else 0.0

    def _least(self, robot_type: RobotType, origin: Position, destination: Position, speed_mps: float | None) -> float:
        if origin == destination:
            return 0.0
        key = (robot_type.id, origin, destination, speed_mps)
        if key not in self._known:
            self._known[key] = self._map(robot_type).least(origin, destination, speed_mps)
        return self._known[key]

    def _map(self, robot_type: RobotType) -> Map:
        if robot_type.id not in self._maps:
            self._maps[robot_type.id] = self._drawn(robot_type)
        return self._maps[robot_type.id]

    def _drawn(self, robot_type: RobotType) -> Map:
        if self._scene.roads is not None:
            return RoadWays(self._scene, self._scene.roads, robot_type)
        if self._scene.grid is not None:
            return GridWays(self._scene, self._scene.grid, robot_type)
        return GroundWays(self._scene, robot_type)


def apart_m(first: Position, second: Position) -> float:
    """Straight distance of two points in metres; infinite between floors."""
    if first.floor != second.floor:
        return math.inf
    return math.hypot(first.x_m - second.x_m, first.y_m - second.y_m)
