"""What a robot type may not enter or use, and whether a straight line passes through it; plain geometry of the checker's own."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

from missiontree.mission.area import Area, Corner
from missiontree.mission.fleet import RobotType
from missiontree.mission.scene import Scene
from missiontree.mission.ways import Lift, Road

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
    """Whether a point is inside an area and off its edge."""
    return _covers(point, area) and all(_gap(point, *edge) > NOISE_M for edge in _edges(area))


def passes_through(start: Corner, end: Corner, areas: Sequence[Area]) -> bool:
    """
    Whether a straight line enters the inside of closed areas, which count as one body: where two touch nobody slips between.

    The line is cut wherever an edge may meet it. A piece is inside if the body covers both what is just left of its middle and
    what is just right of it.
    """
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = math.hypot(dx, dy)
    if not NOISE_M < length < math.inf:
        return False
    left = (-dy / length * NOISE_M, dx / length * NOISE_M)
    for low, high in pairwise(sorted(_cuts(start, (dx, dy), areas))):
        middle = (low + high) / 2
        x, y = start[0] + middle * dx, start[1] + middle * dy
        sides = ((x + left[0], y + left[1]), (x - left[0], y - left[1]))
        if (high - low) * length > NOISE_M and all(any(_covers(side, area) for area in areas) for side in sides):
            return True
    return False


def _cuts(start: Corner, way: Corner, areas: Sequence[Area]) -> set[float]:
    """Shares of a line where edges cross it, or corners lie beside it."""
    (dx, dy), cuts = way, {0.0, 1.0}
    for (x1, y1), (x2, y2) in (edge for area in areas for edge in _edges(area)):
        ex, ey = x2 - x1, y2 - y1
        turn = dx * ey - dy * ex
        if turn:
            cuts.add(((x1 - start[0]) * ey - (y1 - start[1]) * ex) / turn)
        cuts.add(((x1 - start[0]) * dx + (y1 - start[1]) * dy) / (dx * dx + dy * dy))
    return {share for share in cuts if 0 <= share <= 1}


def _covers(point: Corner, area: Area) -> bool:
    """Whether a point is inside, by the even-odd rule; on the edge either answer may come."""
    x, y = point
    odd = False
    for (x1, y1), (x2, y2) in _edges(area):
        if (y1 > y) != (y2 > y) and x < x1 + (y - y1) * (x2 - x1) / (y2 - y1):
            odd = not odd
    return odd


def _edges(area: Area) -> zip[tuple[Corner, Corner]]:
    return zip(area.corners, (*area.corners[1:], area.corners[0]), strict=True)


def _gap(point: Corner, start: Corner, end: Corner) -> float:
    """Distance of a point from a segment."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    squared = dx * dx + dy * dy
    share = ((point[0] - start[0]) * dx + (point[1] - start[1]) * dy) / squared if squared else 0.0
    share = min(1.0, max(0.0, share))
    return math.hypot(point[0] - start[0] - share * dx, point[1] - start[1] - share * dy)
