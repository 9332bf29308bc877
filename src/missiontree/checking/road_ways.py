"""Shortest ways on the road graph; off-road points join the nearest node of their floor that they see, straight."""

from __future__ import annotations

import math
from itertools import pairwise

from missiontree.checking.closed import closed_areas, inside, may_use, passes_through
from missiontree.checking.dijkstra import shortest
from missiontree.mission.area import Area
from missiontree.mission.fleet import RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Leg
from missiontree.mission.ways import RoadGraph

Step = tuple[str, float, float]
"""Where a step leads, its metres, and the seconds of a ride."""


class RoadWays:
    """
    Roads and lifts that one robot type may use.

    Parameters
    ----------
    scene
        Where the nodes are.
    roads
        The road graph.
    robot_type
        Who travels.
    """

    def __init__(self, scene: Scene, roads: RoadGraph, robot_type: RobotType) -> None:
        self._scene = scene
        self._type = robot_type
        self._closed: dict[str, tuple[Area, ...]] = {}
        ends = [end for road in roads.roads for end in road.ends] + [
            stop for lift in roads.lifts for stop in lift.stops
        ]
        points = scene.road_points
        names = dict.fromkeys([node.id for node in roads.nodes] + ends)
        self.points = {name: points[name] for name in names}
        self.steps: dict[str, list[Step]] = {name: [] for name in self.points}
        for road in roads.roads:
            if may_use(robot_type, road):
                self._add_road(road.ends[0], road.ends[1], road.length_m, road.one_way)
        for lift in roads.lifts:
            if may_use(robot_type, lift):
                for stop in lift.stops:
                    self.steps[stop] += [(other, 0.0, lift.ride_s) for other in lift.stops if other != stop]

    def _add_road(self, first: str, second: str, length_m: float | None, one_way: bool) -> None:
        start, end = self.points[first], self.points[second]
        if start.floor == end.floor and not self.sees(start, end):
            return
        metres = length_m if length_m is not None else math.hypot(start.x_m - end.x_m, start.y_m - end.y_m)
        self.steps[first].append((second, metres, 0.0))
        if not one_way:
            self.steps[second].append((first, metres, 0.0))

    def least(self, origin: Position, destination: Position, speed_mps: float | None) -> float:
        """See :class:`missiontree.checking.ways.Map`."""

        def cost(metres: float, ride_s: float) -> float:
            return metres if speed_mps is None else metres / speed_mps + ride_s

        lengths = shortest(
            [(name, cost(metres, 0.0)) for name, metres in self.nearest(origin)],
            lambda name: [(other, cost(metres, ride_s)) for other, metres, ride_s in self.steps[name]],
        )
        ends = [lengths[name] + cost(metres, 0.0) for name, metres in self.nearest(destination) if name in lengths]
        return min(ends, default=math.inf)

    def nearest(self, position: Position) -> list[tuple[str, float]]:
        """The nearest node that a point sees, with its distance; all of them where several are equally near."""
        here = (position.x_m, position.y_m)
        if any(inside(here, area) for area in self._areas(position.floor)):
            return []
        gaps = sorted(
            (math.hypot(point.x_m - position.x_m, point.y_m - position.y_m), name)
            for name, point in self.points.items()
            if point.floor == position.floor
        )
        near: list[tuple[str, float]] = []
        for gap, name in gaps:
            if near and gap > near[0][1] + 1e-9:
                break
            if self.sees(position, self.points[name]):
                near.append((name, gap))
        return near

    def problem(self, leg: Leg) -> str:
        """What is wrong with the road nodes that a leg names, or leaves out; empty if nothing is."""
        if not leg.via:
            stays = leg.origin.floor == leg.destination.floor and _straight_m(leg.origin, leg.destination) <= 1e-3
            return "" if stays and leg.distance_m <= 1e-3 else "names no road node, and there is no way past the roads"
        if unknown := [name for name in leg.via if name not in self.points]:
            return f"passes {unknown[0]!r}, which is no road node"
        metres = 0.0
        for first, second in pairwise(leg.via):
            open_steps = [length for other, length, _ in self.steps[first] if other == second]
            if not open_steps:
                return f"goes from {first} to {second}, between which no road or lift is open to it"
            metres += min(open_steps)
        ends = ((leg.origin, leg.via[0]), (leg.destination, leg.via[-1]))
        for end, name in ends:
            if end.floor != self.points[name].floor:
                return f"joins {name}, which is on another floor"
            near = [node for node, _ in self.nearest(end)]
            if near and name not in near:
                return f"joins {name}; the nearest node of the road is {' or '.join(near)}"
            metres += _straight_m(end, self.points[name])
        if leg.distance_m < metres - 1e-3:
            return f"claims {leg.distance_m:g} m; the way that it names is {metres:g} m long"
        return ""

    def named_s(self, leg: Leg, speed_mps: float) -> float:
        """Seconds that the road nodes of a leg take at a speed; 0 where they are no way at all."""
        if self.problem(leg) or not leg.via:
            return 0.0
        ends = _straight_m(leg.origin, self.points[leg.via[0]]) + _straight_m(leg.destination, self.points[leg.via[-1]])
        between = (
            min(metres / speed_mps + ride_s for other, metres, ride_s in self.steps[first] if other == second)
            for first, second in pairwise(leg.via)
        )
        return ends / speed_mps + sum(between)

    def sees(self, first: Position, second: Position) -> bool:
        """Whether the straight line between two points of a floor keeps out of everything that is closed."""
        line = (first.x_m, first.y_m), (second.x_m, second.y_m)
        return not passes_through(*line, self._areas(first.floor))

    def _areas(self, floor: str) -> tuple[Area, ...]:
        if floor not in self._closed:
            self._closed[floor] = closed_areas(self._type, self._scene, floor)
        return self._closed[floor]


def _straight_m(first: Position, second: Position) -> float:
    return math.hypot(first.x_m - second.x_m, first.y_m - second.y_m)
