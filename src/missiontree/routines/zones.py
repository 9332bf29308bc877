"""In which zones of the scene an entity is."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.mission.area import Area, Corner
from missiontree.mission.entity import Entity
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene


def zones_of(entity: Entity, scene: Scene) -> tuple[str, ...]:
    """
    Zones that an entity is in, as far as planning knows.

    Its own ``zone`` if it has one, else that of the place it is at, else all zones whose area holds the position that planning
    takes it to be at. Several if areas overlap; a robot must then be allowed in every one.
    """
    if entity.zone is not None:
        return (entity.zone,)
    if entity.place is not None and (zone := scene.by_id[entity.place].zone) is not None:
        return (zone,)
    position = scene.whereabouts(entity).position
    if position is None:
        return ()
    return tuple(zone.id for zone in scene.zones if zone.area is not None and holds(zone.area, position))


def holds(area: Area, position: Position) -> bool:
    """Whether a position in frame ``map`` is inside the area or on its edge (even-odd rule)."""
    if position.floor != area.floor:
        return False
    point = (position.x_m, position.y_m)
    inside = False
    for start, end in zip(area.corners, (*area.corners[1:], area.corners[0]), strict=True):
        if _on_edge(point, start, end):
            return True
        if (start[1] > point[1]) != (end[1] > point[1]):
            crossing_x_m = start[0] + (point[1] - start[1]) / (end[1] - start[1]) * (end[0] - start[0])
            inside ^= point[0] < crossing_x_m
    return inside


def _on_edge(point: Corner, start: Corner, end: Corner) -> bool:
    turn = (end[0] - start[0]) * (point[1] - start[1]) - (end[1] - start[1]) * (point[0] - start[0])
    return turn == 0 and all(_between(point[axis], (start[axis], end[axis])) for axis in (0, 1))


def _between(value: float, ends: Sequence[float]) -> bool:
    return min(ends) <= value <= max(ends)
