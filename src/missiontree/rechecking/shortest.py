"""
How short a way can be at the very least.

Roads are followed as they are open to a robot type. What else stands in the way, keep-outs, zones, blocked cells, is left out of account:
whoever minds that has no shorter way, only a longer one.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from missiontree.mission.fleet import RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene

EQUALLY_M = 1e-3
Step = tuple[str, str, float, float]
"""From a point to a point: metres driven, and seconds ridden beside."""


def least(world: Scene, kind: RobotType, origin: Position, destination: Position, speed_mps: float | None) -> float:
    """The least length in metres that a way could have; with a speed, the least time in seconds. Infinite if there is no way."""
    pace = 1.0 if speed_mps is None else 1 / speed_mps
    if origin == destination:
        return 0.0
    if world.roads is not None:
        return _by_road(world, kind, origin, destination, pace, rides=speed_mps is not None)
    if origin.floor != destination.floor:
        return math.inf
    straight = _apart(origin, destination)
    if world.grid is not None:  # ways lead from the middle of a cell to the middle of a cell
        straight = max(0.0, straight - math.sqrt(2) * world.grid.cell_m)
    return straight * pace


def _by_road(
    world: Scene, kind: RobotType, origin: Position, destination: Position, pace: float, *, rides: bool
) -> float:
    """Straight to the nearest point of the roads, along them, and straight from the nearest one (Bellman and Ford, in rounds)."""
    assert world.roads is not None
    steps = _steps(world, kind)
    joined = {node.id for node in world.roads.nodes} | {end for road in world.roads.roads for end in road.ends}
    joined |= {stop for lift in world.roads.lifts for stop in lift.stops}
    points = {name: at for name, at in world.road_points.items() if name in joined}
    # Where something may stand between a point and the node nearest to it, the way may join the roads at any other.
    slack_m = math.inf if world.keep_outs or kind.zones is not None else EQUALLY_M
    far = dict.fromkeys(points, math.inf)
    far |= {name: metres * pace for name, metres in _nearest(points, origin, slack_m).items()}
    for _ in points:
        changed = False
        for start, end, metres, seconds in steps:
            reached = far[start] + metres * pace + (seconds if rides else 0.0)
            if reached < far[end]:
                far[end] = reached
                changed = True
        if not changed:
            break
    there = [far[name] + metres * pace for name, metres in _nearest(points, destination, slack_m).items()]
    return min(there, default=math.inf)


def _nearest(points: Mapping[str, Position], where: Position, slack_m: float) -> dict[str, float]:
    """The points of a floor that are nearest, up to some slack, with their distance."""
    near = {name: _apart(where, at) for name, at in points.items() if at.floor == where.floor}
    closest = min(near.values(), default=0.0)
    return {name: metres for name, metres in near.items() if metres <= closest + slack_m}


def _steps(world: Scene, kind: RobotType) -> list[Step]:
    """Every road that is open to a type, in both directions or one, and every ride of a lift that works for it."""
    steps: list[Step] = []
    assert world.roads is not None
    for road in world.roads.roads:
        one, other = road.ends
        length_m = _apart(world.road_points[one], world.road_points[other]) if road.length_m is None else road.length_m
        barred = road.zone is not None and kind.zones is not None and road.zone not in kind.zones
        if road.blocked or barred or (road.types is not None and kind.id not in road.types):
            continue
        steps.append((one, other, length_m, 0.0))
        if not road.one_way:
            steps.append((other, one, length_m, 0.0))
    for lift in world.roads.lifts:
        if lift.blocked or (lift.types is not None and kind.id not in lift.types):
            continue
        steps.extend((one, other, 0.0, lift.ride_s) for one in lift.stops for other in lift.stops if one != other)
    return steps


def _apart(one: Position, other: Position) -> float:
    return math.hypot(one.x_m - other.x_m, one.y_m - other.y_m)
