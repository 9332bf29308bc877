"""The line that a robot's leg follows on the map, and when it is where on it."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from missiontree.estimation.access import Access, access_of
from missiontree.estimation.grid import GridWays
from missiontree.estimation.obstacles import Obstacles, xy
from missiontree.estimation.polygon import Point, distance
from missiontree.estimation.straight import Plane
from missiontree.estimation.travel import speed_of
from missiontree.mission.fleet import RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Leg

_STRAIGHT_M = 1e-6


@dataclass(frozen=True, slots=True)
class Waypoint:
    """
    A robot is here then; between two waypoints of one floor it moves evenly and straight.

    Parameters
    ----------
    t_s
        When, in seconds from the start of the schedule.
    x_m, y_m
        Where, in frame ``map``.
    floor
        On which floor. From one floor to the next it is in a lift.
    """

    t_s: float
    x_m: float
    y_m: float
    floor: str


@dataclass(frozen=True, slots=True)
class _Stretch:
    """Where a part of a leg ends, how long it is in metres and how long it takes in a lift."""

    end: Position
    length_m: float
    ride_s: float = 0.0


class DrawnGrid(GridWays):
    """A grid whose ways can be drawn: the same search as the one that measures them."""

    def way(self, origin: Position, destination: Position) -> list[Point] | None:
        """Corners of a shortest way, both ends included; None if there is none."""
        if self._refusal(origin) is not None or self._refusal(destination) is not None:
            return None
        start, goal = self._cell(xy(origin)), self._cell(xy(destination))
        if start == goal:
            return [xy(origin), xy(destination)]
        tree = self._tree(min(start, goal))  # of equal ways, the way back is the way there
        if tree.cost(max(start, goal)) is None:
            return None
        way = tree.way(max(start, goal))
        cells = way if start < goal else way[::-1]
        return without_straight([xy(origin), *map(self._centre, cells), xy(destination)])


class WayFinder:
    """
    Finds the lines of legs again, since a schedule keeps of them only the road nodes.

    A leg that cannot be found on the map, such as one of a plan that somebody changed by hand, is drawn straight.

    Parameters
    ----------
    scene
        The world, introduced entities included.
    """

    def __init__(self, scene: Scene) -> None:
        self._scene = scene
        self._accesses: dict[str, Access] = {}
        self._grids: dict[Access, DrawnGrid] = {}
        self._planes: dict[tuple[Access, str], Plane] = {}

    def line(self, leg: Leg, kind: RobotType | None, brought: Sequence[str] = ()) -> tuple[Waypoint, ...]:
        """
        Where a robot is on a leg, from its start to its end; at least two waypoints.

        Parameters
        ----------
        leg
            The leg.
        kind
            Type of the robot; None if the fleet does not have it, then the leg is drawn as its nodes have it.
        brought
            Entities that move along; a slow one may make the robot prefer a lift.
        """
        return _timed(leg, self._stretches(leg, kind, brought))

    def _stretches(self, leg: Leg, kind: RobotType | None, brought: Sequence[str]) -> list[_Stretch]:
        if leg.via:
            return self._by_road(leg, kind, brought)
        points: list[Point] | None = None
        if kind is not None and leg.origin.floor == leg.destination.floor and leg.distance_m > 0:
            access = self._access(kind)
            if self._scene.grid is not None:
                points = self._grid(access).way(leg.origin, leg.destination)
            elif self._scene.roads is None:
                points = self._plane(access, leg.origin.floor).way(xy(leg.origin), xy(leg.destination))
        if points is None:
            return [_Stretch(leg.destination, leg.distance_m)]
        ends = [Position(x, y, floor=leg.origin.floor) for x, y in points]
        return [_Stretch(end, distance(xy(start), xy(end))) for start, end in pairwise(ends)]

    def _by_road(self, leg: Leg, kind: RobotType | None, brought: Sequence[str]) -> list[_Stretch]:
        nodes = [(name, self._scene.road_points[name]) for name in leg.via if name in self._scene.road_points]
        stretches = [_stretch(leg.origin, nodes[0][1])] if nodes else []
        speed = self._speed(kind, brought)
        for (start, here), (end, there) in pairwise(nodes):
            stretches.append(self._step(start, here, end, there, kind, speed))
        return [*stretches, _stretch(nodes[-1][1] if nodes else leg.origin, leg.destination)]

    def _step(
        self, start: str, here: Position, end: str, there: Position, kind: RobotType | None, speed: float
    ) -> _Stretch:
        """The quickest open road or lift between neighbours."""
        closed = self._access(kind) if kind is not None else Access((), (), ())
        shut_roads = {closure.index for closure in closed.roads}
        shut_lifts = {closure.index for closure in closed.lifts}
        graph = self._scene.roads
        found = []
        for index, road in enumerate(graph.roads if graph is not None else ()):
            fits = road.ends == (start, end) or (road.ends == (end, start) and not road.one_way)
            if fits and index not in shut_roads:
                length_m = road.length_m if road.length_m is not None else distance(xy(here), xy(there))
                found.append((length_m / speed, _Stretch(there, length_m)))
        for index, lift in enumerate(graph.lifts if graph is not None else ()):
            if start in lift.stops and end in lift.stops and index not in shut_lifts:
                found.append((lift.ride_s, _Stretch(there, 0.0, lift.ride_s)))
        return min(found, key=lambda one: one[0])[1] if found else _stretch(here, there)

    def _speed(self, kind: RobotType | None, brought: Iterable[str]) -> float:
        known = self._scene.by_id
        return (speed_of(kind, (known[name] for name in brought if name in known)) if kind else None) or 1.0

    def _access(self, kind: RobotType) -> Access:
        if kind.id not in self._accesses:
            self._accesses[kind.id] = access_of(kind, self._scene)
        return self._accesses[kind.id]

    def _grid(self, access: Access) -> DrawnGrid:
        assert self._scene.grid is not None
        if access not in self._grids:
            self._grids[access] = DrawnGrid(self._scene.grid, access)
        return self._grids[access]

    def _plane(self, access: Access, floor: str) -> Plane:
        if (access, floor) not in self._planes:
            self._planes[access, floor] = Plane(Obstacles(access.on_floor(floor)))
        return self._planes[access, floor]


def without_straight(points: Sequence[Point]) -> list[Point]:
    """The points without those on a straight line between their neighbours, and without repetitions."""
    kept: list[Point] = []
    for point in points:
        if kept and distance(kept[-1], point) <= _STRAIGHT_M:
            continue
        if len(kept) >= 2 and _goes_on(kept[-2], kept[-1], point):
            kept[-1] = point
        else:
            kept.append(point)
    return kept if len(kept) > 1 else [points[0], points[-1]]


def _goes_on(first: Point, middle: Point, last: Point) -> bool:
    (ax, ay), (bx, by) = (middle[0] - first[0], middle[1] - first[1]), (last[0] - middle[0], last[1] - middle[1])
    return abs(ax * by - ay * bx) <= _STRAIGHT_M * math.hypot(ax, ay) * math.hypot(bx, by) and ax * bx + ay * by > 0


def _stretch(start: Position, end: Position) -> _Stretch:
    return _Stretch(end, distance(xy(start), xy(end)) if start.floor == end.floor else 0.0)


def _timed(leg: Leg, stretches: Sequence[_Stretch]) -> tuple[Waypoint, ...]:
    """Lifts take their time, the rest is shared out by metres; where that is more than there is, all is shrunk alike."""
    whole_s = leg.end_s - leg.start_s
    length_m = math.fsum(stretch.length_m for stretch in stretches)
    rides_s = math.fsum(stretch.ride_s for stretch in stretches)
    on_foot_s = max(0.0, whole_s - rides_s) if length_m > 0 else 0.0
    shrink = min(1.0, whole_s / rides_s) if rides_s > 0 else 0.0
    points = [Waypoint(leg.start_s, leg.origin.x_m, leg.origin.y_m, leg.origin.floor)]
    t_s = leg.start_s
    for stretch in stretches:
        t_s += stretch.ride_s * shrink + (on_foot_s * stretch.length_m / length_m if length_m > 0 else 0.0)
        points.append(Waypoint(min(t_s, leg.end_s), stretch.end.x_m, stretch.end.y_m, stretch.end.floor))
    points[-1] = replace(points[-1], t_s=leg.end_s)
    return tuple(points)
