"""How short a way can be at the very least. No way along roads or cells is shorter than the straight line, unless a road says so."""

from __future__ import annotations

import math

from missiontree.mission.position import Position
from missiontree.mission.scene import Scene


def least_m(world: Scene, origin: Position, destination: Position) -> float:
    """A length in metres that no way falls below."""
    straight = math.hypot(origin.x_m - destination.x_m, origin.y_m - destination.y_m)
    if world.grid is not None:  # ways lead from the middle of a cell to the middle of a cell
        return max(0.0, straight - math.sqrt(2) * world.grid.cell_m)
    return straight * _shrunk(world)


def _shrunk(world: Scene) -> float:
    """By how much the shortest road is shorter than its straight line, as a factor up to 1; 0 if a lift carries one sideways."""
    if world.roads is None:
        return 1.0
    points = world.road_points
    for lift in world.roads.lifts:
        if len({(points[stop].x_m, points[stop].y_m) for stop in lift.stops}) > 1:
            return 0.0
    least = 1.0
    for road in world.roads.roads:
        one, other = points[road.ends[0]], points[road.ends[1]]
        straight = math.hypot(one.x_m - other.x_m, one.y_m - other.y_m)
        if road.length_m is not None and straight > 0:
            least = min(least, road.length_m / straight)
    return least


def rides_s(world: Scene) -> list[float]:
    """Seconds that each way from floor to floor takes beside the driving: the ride in a lift, nothing on a road."""
    if world.roads is None:
        return []
    points = world.road_points
    ramps = [road for road in world.roads.roads if points[road.ends[0]].floor != points[road.ends[1]].floor]
    return [0.0 for _ in ramps] + [lift.ride_s for lift in world.roads.lifts]
