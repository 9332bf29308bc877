"""From where to where, how far and how long: the ways of the scene's map, found once and remembered between calls."""

from __future__ import annotations

from collections.abc import Iterable
from threading import Lock
from typing import Protocol

from missiontree.estimation.access import Access, access_of
from missiontree.estimation.grid import GridWays
from missiontree.estimation.leg import STAY, Blocked, Leg, for_robot
from missiontree.estimation.roads import RoadWays
from missiontree.estimation.straight import StraightWays
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Robot, RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene

__all__ = ["Blocked", "Leg", "TravelModel", "Ways", "speed_of", "start_of", "travel_model", "travel_time_s"]


class Ways(Protocol):
    """The seam: finds ways on one kind of map, under one set of closures."""

    def leg(self, origin: Position, destination: Position, speed_mps: float) -> Leg | Blocked:
        """
        Find the quickest way.

        Parameters
        ----------
        origin, destination
            Two different points, in frame ``map``.
        speed_mps
            Speed by which travel is weighed against the ride of a lift, above 0.
        """
        ...


class TravelModel:
    """
    The ways of a scene, for every robot type.

    With a road graph the ways are its roads (:class:`~missiontree.estimation.roads.RoadWays`), with an occupancy grid its
    free cells (:class:`~missiontree.estimation.grid.GridWays`), else straight lines round what is closed
    (:class:`~missiontree.estimation.straight.StraightWays`). Robot types to which the same is closed share one map. Every
    leg is remembered, so asking again is a look-up.

    Parameters
    ----------
    scene
        The world, introduced entities included.
    """

    def __init__(self, scene: Scene) -> None:
        self._scene = scene
        self._lock = (
            Lock()
        )  # scenes are shared by threads, and a way is searched for from where the last search stopped
        self._accesses: dict[tuple[str, tuple[str, ...] | None], Access] = {}
        self._ways: dict[Access, Ways] = {}
        self._legs: dict[tuple[Ways, float, Position, Position], Leg | Blocked] = {}
        self._has_lifts = scene.roads is not None and bool(scene.roads.lifts)

    def leg(
        self, robot_type: RobotType, origin: Position, destination: Position, speed_mps: float | None = None
    ) -> Leg | Blocked:
        """
        The quickest way that a robot type may take.

        Parameters
        ----------
        robot_type
            Who travels.
        origin, destination
            From where to where, in any frame of the scene. If they are the same point the leg is 0 m long, wherever it is.
        speed_mps
            Speed of this leg, above 0, where a led or carried entity slows the robot down. Default: the type's own, or 1 m/s if
            it has none. It matters only where lifts compete with roads.
        """
        start, goal = self._scene.in_map(origin), self._scene.in_map(destination)
        if start == goal:
            return STAY
        speed = (speed_mps or speed_of(robot_type) or 1.0) if self._has_lifts else 1.0
        with self._lock:
            ways = self._ways_of(robot_type)
            key = (ways, speed, start, goal)
            found = self._legs.get(key)
            if found is None:
                found = self._legs[key] = ways.leg(start, goal, speed)
        return found if isinstance(found, Leg) else for_robot(found, robot_type.id)

    def _ways_of(self, robot_type: RobotType) -> Ways:
        key = (robot_type.id, robot_type.zones)  # nothing else of a type opens or closes a way
        access = self._accesses.get(key)
        if access is None:
            access = self._accesses[key] = access_of(robot_type, self._scene)
        ways = self._ways.get(access)
        if ways is None:
            ways = self._ways[access] = _ways(self._scene, access)
        return ways


def travel_model(scene: Scene) -> TravelModel:
    """The ways of a scene, kept with it: whoever asks for the same scene again need not search for them anew."""
    model: TravelModel = scene.derived.setdefault("travel", TravelModel(scene))
    return model


def _ways(scene: Scene, access: Access) -> Ways:
    if scene.roads is not None:
        return RoadWays(scene.roads, scene.road_points, access)
    if scene.grid is not None:
        return GridWays(scene.grid, access)
    return StraightWays(access)


def travel_time_s(leg: Leg, speed_mps: float) -> float:
    """
    How long a leg takes, in seconds.

    Parameters
    ----------
    leg
        The way.
    speed_mps
        Speed in metres per second, above 0; lifts ride at their own.
    """
    return leg.distance_m / speed_mps + leg.ride_s


def speed_of(robot_type: RobotType, brought: Iterable[Entity] = ()) -> float | None:
    """
    Speed of a robot on a leg, in metres per second; None if the type's own speed is not known.

    Parameters
    ----------
    robot_type
        Who travels; its limit ``max_speed_mps`` counts.
    brought
        Entities led or carried; the slowest of them whose speed is known caps the robot's.
    """
    own = robot_type.limits.get("max_speed_mps")
    if own is None:
        return None
    return min([own, *(entity.max_speed_mps for entity in brought if entity.max_speed_mps is not None)])


def start_of(robot: Robot, scene: Scene) -> Position | None:
    """Where a robot starts, in frame ``map``; None if that is not known."""
    if robot.position is not None:
        return scene.in_map(robot.position)
    if robot.place is not None:
        return scene.whereabouts(scene.by_id[robot.place]).position
    return None
