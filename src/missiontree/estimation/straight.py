"""Ways without a map: straight lines, and the shortest way round what is closed."""

from __future__ import annotations

import math
from collections.abc import Iterable
from itertools import pairwise

from missiontree.estimation.access import Access
from missiontree.estimation.leg import Blocked, Leg, unreachable
from missiontree.estimation.obstacles import Obstacles, describe, xy
from missiontree.estimation.polygon import Point, distance
from missiontree.estimation.shortest import ShortestTree
from missiontree.mission.position import Position

_ORIGIN = -1


class StraightWays:
    """
    Shortest ways in the plane with polygons in it.

    Parameters
    ----------
    access
        What is closed to the robot type.
    """

    def __init__(self, access: Access) -> None:
        self._access = access
        self._floors: dict[str, Plane] = {}

    def leg(self, origin: Position, destination: Position, speed_mps: float = 1.0) -> Leg | Blocked:
        """Find the shortest way; see :class:`missiontree.estimation.travel.Ways`. The speed makes no difference."""
        if origin.floor != destination.floor:
            return unreachable(
                f"Nothing joins floor {origin.floor} and floor {destination.floor}.",
                found=f"no way from {describe(origin)} to {describe(destination)}",
                hint="give the scene a road graph with a lift that stops on both floors",
            )
        plane = self._floors.get(origin.floor)
        if plane is None:
            plane = self._floors[origin.floor] = Plane(Obstacles(self._access.on_floor(origin.floor)))
        refusal = plane.obstacles.forbid(origin) or plane.obstacles.forbid(destination)
        if refusal is not None:
            return refusal
        way = plane.way(xy(origin), xy(destination))
        if way is None:
            name = plane.obstacles.crossed(xy(origin), xy(destination))
            return unreachable(
                f"{describe(destination)} is cut off from {describe(origin)} by {name}.", found=f"{name}"
            )
        return Leg(math.fsum(distance(start, end) for start, end in pairwise(way)))


class Plane:
    """
    One floor as a visibility graph over the corners of what is closed (Lozano-Perez and Wesley, 1979).

    A shortest way bends at corners only. With n corners, what a point sees takes O(n * n) and is found once per point and
    corner, a way O(n log n) more; with nothing closed on the line between, a look at the edges is all.

    Parameters
    ----------
    obstacles
        What is closed on the floor.
    """

    def __init__(self, obstacles: Obstacles) -> None:
        self.obstacles = obstacles
        corners = dict.fromkeys(corner for polygon in obstacles.polygons for corner in polygon.corners)
        self._corners = [corner for corner in corners if obstacles.holding(corner) is None]
        self._seen: dict[Point, list[tuple[int, float]]] = {}
        self._trees: dict[Point, ShortestTree] = {}

    def way(self, origin: Point, destination: Point) -> list[Point] | None:
        """Points of a shortest way, both ends included; None if there is no way."""
        if self.obstacles.crossed(origin, destination) is None:
            return [origin, destination]
        tree = self._trees.get(origin)
        if tree is None:
            tree = self._trees[origin] = ShortestTree(_ORIGIN, lambda node: self._visible(origin, node))
        ends = [
            (cost + last, corner)
            for corner, last in self._visible_from(destination)
            if (cost := tree.cost(corner)) is not None
        ]
        if not ends:
            return None
        corners = tree.way(min(ends)[1])[1:]
        return [origin, *(self._corners[corner] for corner in corners), destination]

    def _visible(self, origin: Point, node: int) -> Iterable[tuple[int, float]]:
        return self._visible_from(origin if node == _ORIGIN else self._corners[node])

    def _visible_from(self, point: Point) -> list[tuple[int, float]]:
        seen = self._seen.get(point)
        if seen is None:
            seen = self._seen[point] = [
                (number, distance(point, corner))
                for number, corner in enumerate(self._corners)
                if corner != point and self.obstacles.crossed(point, corner) is None
            ]
        return seen
