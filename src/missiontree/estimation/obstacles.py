"""The closed areas of one floor, as bodies that ways go round."""

from __future__ import annotations

from missiontree.estimation.access import ClosedArea
from missiontree.estimation.leg import Blocked, unreachable
from missiontree.estimation.polygon import Point, Polygon, pierced
from missiontree.mission.position import Position


class Obstacles:
    """
    What is closed on one floor.

    Parameters
    ----------
    areas
        The closed areas.
    """

    def __init__(self, areas: tuple[ClosedArea, ...]) -> None:
        self.names = {Polygon(closed.area.corners): closed.name for closed in areas}
        self.polygons = tuple(self.names)

    def holding(self, point: Point) -> str | None:
        """Name of the first area that a point is inside of; None if it is free."""
        return next((self.names[polygon] for polygon in self.polygons if polygon.holds(point)), None)

    def crossed(self, start: Point, end: Point) -> str | None:
        """Name of an area that a straight line passes through; None if the line is free."""
        polygon = pierced(start, end, self.polygons)
        return None if polygon is None else self.names[polygon]

    def forbid(self, position: Position) -> Blocked | None:
        """Why a robot may not stand at a position; None if it may."""
        name = self.holding(xy(position))
        if name is None:
            return None
        return unreachable(f"{describe(position)} is inside {name}, which is closed to the robot.", found=name)


def xy(position: Position) -> Point:
    """Coordinates of a position, in metres."""
    return (position.x_m, position.y_m)


def describe(position: Position) -> str:
    """A position in words: ``(3, 4.5)``, with its floor unless that is ``ground``."""
    floor = "" if position.floor == "ground" else f" on floor {position.floor}"
    return f"({position.x_m:g}, {position.y_m:g}){floor}"
