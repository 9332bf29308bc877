"""What is closed to a robot type: areas, roads, lifts. Types to which the same is closed share their ways."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.area import Area
from missiontree.mission.fleet import RobotType
from missiontree.mission.scene import Scene


@dataclass(frozen=True, slots=True)
class ClosedArea:
    """
    An area that may not be entered; its edge may be touched.

    Parameters
    ----------
    name
        What people call it: ``keep-out stairs``, ``zone kitchen``.
    area
        Its extent.
    """

    name: str
    area: Area


@dataclass(frozen=True, slots=True)
class Closure:
    """
    Something closed, and why.

    Parameters
    ----------
    index
        Position in the scene's list of roads or lifts.
    why
        ``is blocked``, ``is closed to this robot type``.
    """

    index: int
    why: str


@dataclass(frozen=True, slots=True)
class Access:
    """
    All that is closed to a robot type. Hashable: equal for types that may use the same ways.

    Parameters
    ----------
    areas
        Keep-outs that hold for the type, and zones with an area that it may not enter.
    roads, lifts
        Roads and lifts it may not use by their own rules; what areas close is not among them.
    """

    areas: tuple[ClosedArea, ...]
    roads: tuple[Closure, ...]
    lifts: tuple[Closure, ...]

    def on_floor(self, floor: str) -> tuple[ClosedArea, ...]:
        """Closed areas of one floor."""
        return tuple(closed for closed in self.areas if closed.area.floor == floor)


def access_of(robot_type: RobotType, scene: Scene) -> Access:
    """What the scene closes to a robot type. Linear in the scene."""
    return Access(_areas(robot_type, scene), _roads(robot_type, scene), _lifts(robot_type, scene))


def _areas(robot_type: RobotType, scene: Scene) -> tuple[ClosedArea, ...]:
    keep_outs = [
        ClosedArea(f"keep-out {keep_out.id}", keep_out.area)
        for keep_out in scene.keep_outs
        if _holds(keep_out.types, robot_type.id)
    ]
    zones = [
        ClosedArea(f"zone {zone.id}", zone.area)
        for zone in scene.zones
        if zone.area is not None and not _may_enter(robot_type, zone.id)
    ]
    return (*keep_outs, *zones)


def _roads(robot_type: RobotType, scene: Scene) -> tuple[Closure, ...]:
    closures = []
    for index, road in enumerate(scene.roads.roads if scene.roads else ()):
        if road.blocked:
            closures.append(Closure(index, "is blocked"))
        elif not _holds(road.types, robot_type.id):
            closures.append(Closure(index, "is closed to this robot type"))
        elif road.zone is not None and not _may_enter(robot_type, road.zone):
            closures.append(Closure(index, f"runs through zone {road.zone}, closed to this robot type"))
    return tuple(closures)


def _lifts(robot_type: RobotType, scene: Scene) -> tuple[Closure, ...]:
    closures = []
    for index, lift in enumerate(scene.roads.lifts if scene.roads else ()):
        if lift.blocked:
            closures.append(Closure(index, "is out of order"))
        elif not _holds(lift.types, robot_type.id):
            closures.append(Closure(index, "is closed to this robot type"))
    return tuple(closures)


def _holds(types: tuple[str, ...] | None, robot_type: str) -> bool:
    return types is None or robot_type in types


def _may_enter(robot_type: RobotType, zone: str) -> bool:
    return robot_type.zones is None or zone in robot_type.zones
