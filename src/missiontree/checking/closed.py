"""What a robot type may not enter or use, and whether a straight line passes through it; plain geometry of the checker's own."""

from __future__ import annotations

import math
from itertools import pairwise

from missiontree.mission.fleet import RobotType
from missiontree.mission.scene import Area, Corner, Lift, Road, Scene

NOISE_M = 1e-5
"""Metres by which a line may enter an area and still count as touching its edge."""


def closed_areas(robot_type: RobotType, scene: Scene, floor: str) -> tuple[Area, ...]:
    """Keep-outs that hold for the type, and zones it may not enter, on one floor."""
    areas = [keep.area for keep in scene.keep_outs if keep.types is None or robot_type.id in keep.types]
    areas += [zone.area for zone in scene.zones if zone.area is not None and not may_enter(robot_type, zone.id)]
    return tuple(area for area in areas if area.floor == floor)


def may_enter(robot_type: RobotType, zone: str | None) -> bool:
    """Whether a type may enter a zone; None stands for no zone."""
    return zone is None or robot_type.zones is None or zone in robot_type.zones


def may_use(robot_type: RobotType, way: Road | Lift) -> bool:
    """Whether a type may use a road or a lift by that way's own rules."""
    zone = way.zone if isinstance(way, Road) else None
    return not way.blocked and (way.types is None or robot_type.id in way.types) and may_enter(robot_type, zone)


def inside(point: Corner, area: Area) -> bool:
    """Whether a point is inside an area and off its edge (even-odd rule)."""
    x, y = point
    odd = False
    for (x1, y1), (x2, y2) in _edges(area):
        if _gap(point, (x1, y1), (x2, y2)) <= NOISE_M:
            return False
        if (y1 > y) != (y2 > y) and x < x1 + (y - y1) * (x2 - x1) / (y2 - y1):
            odd = not odd
    return odd


def passes_through(start: Corner, end: Corner, area: Area) -> bool:
    """Whether a straight line enters the inside of an area: it is cut at every edge and the middle of each piece is asked."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    cuts = {0.0, 1.0}
    for (x1, y1), (x2, y2) in _edges(area):
        ex, ey = x2 - x1, y2 - y1
        turn = dx * ey - dy * ex
        if turn:
            share = ((x1 - start[0]) * ey - (y1 - start[1]) * ex) / turn
            if 0 < share < 1:
                cuts.add(share)
    middles = ((low + high) / 2 for low, high in pairwise(sorted(cuts)))
    return any(inside((start[0] + share * dx, start[1] + share * dy), area) for share in middles)


def _edges(area: Area) -> zip[tuple[Corner, Corner]]:
    return zip(area.corners, (*area.corners[1:], area.corners[0]), strict=True)


def _gap(point: Corner, start: Corner, end: Corner) -> float:
    """Distance of a point from a segment."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    squared = dx * dx + dy * dy
    share = ((point[0] - start[0]) * dx + (point[1] - start[1]) * dy) / squared if squared else 0.0
    share = min(1.0, max(0.0, share))
    return math.hypot(point[0] - start[0] - share * dx, point[1] - start[1] - share * dy)
