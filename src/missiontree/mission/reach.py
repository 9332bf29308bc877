"""
How far times and ways may reach, so that every time is still exact to a tick.

Times are counted in milliseconds, and what is read is rounded up but for a share of 1e-12 that sums of decimal fractions carry as
noise. Up to a thousand million seconds, some 31 years, that share is less than a tick.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot

from missiontree.mission.fleet import Fleet
from missiontree.mission.position import Position
from missiontree.mission.routine import RoutineLibrary
from missiontree.mission.scene import Scene

MOST_S = 1e9
"""Seconds from the start of a mission that a time may name, and that anything may last."""
MOST_M = 1e7
"""Metres that a coordinate may be from the origin, and a road may be long: a quarter of the way round the earth."""


def refuse_endless(fleet: Fleet, scene: Scene, routines: RoutineLibrary) -> None:
    """
    Refuse ways and actions that would last longer than that, by the longest way that there could be, at the robot's speed.

    Raises
    ------
    ValueError
        With the robot type.
    """
    far_m = _longest_m(fleet, scene)
    steps = (step for one in routines.routines for way in one.branches for role in way.roles for step in role.actions)
    longest_s = max((step.duration_s for step in steps), default=0.0)
    brought = [entity.max_speed_mps for entity in scene.all_entities if entity.max_speed_mps is not None]
    for kind in fleet.types:
        own = kind.limits.get("max_speed_mps")
        slowest = min((own, *brought)) if own is not None else None
        if slowest is not None and far_m > MOST_S * slowest:
            raise ValueError(
                f"robot type {kind.id!r}, alone or with what it brings, moves at {slowest:g} m/s, and a way in this scene may be "
                f"{far_m:,.0f} m long: that could take more than {MOST_S:,.0f} s, the longest time that is counted. Either "
                "max_speed_mps is too low, or something too far away."
            )
        for name in kind.capabilities:
            capability = kind.capability(name)
            if capability is not None and capability.duration.plus_s + capability.duration.scale * longest_s > MOST_S:
                raise ValueError(
                    f"capability {name!r} of robot type {kind.id!r} makes an action of {longest_s:g} s last longer than {MOST_S:,.0f} s, "
                    "the longest time that is counted."
                )


def _longest_m(fleet: Fleet, scene: Scene) -> float:
    """No way that passes nothing twice is longer."""
    spots = list(_spots(fleet, scene))
    wide = max((spot.x_m for spot in spots), default=0.0) - min((spot.x_m for spot in spots), default=0.0)
    high = max((spot.y_m for spot in spots), default=0.0) - min((spot.y_m for spot in spots), default=0.0)
    roads, points = scene.roads.roads if scene.roads is not None else (), scene.road_points
    along = sum(
        road.length_m
        if road.length_m is not None
        else hypot(
            points[road.ends[0]].x_m - points[road.ends[1]].x_m, points[road.ends[0]].y_m - points[road.ends[1]].y_m
        )
        for road in roads
    )
    grid = scene.grid
    cells = 0.0 if grid is None else 2 * grid.cell_m * sum(map(len, grid.rows))
    return 4 * hypot(wide, high) + along + cells


def _spots(fleet: Fleet, scene: Scene) -> Iterator[Position]:
    yield from scene.road_points.values()
    for entity in scene.all_entities:
        spot = scene.whereabouts(entity).position
        if spot is not None:
            yield spot
    for kind in fleet.types:
        starts = (kind.position, *(robot.position for robot in kind.robots))
        yield from (scene.in_map(start) for start in starts if start is not None)
