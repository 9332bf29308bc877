"""Points, segments and polygons in the plane, with a tolerance of a micrometre."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

Point = tuple[float, float]

TOLERANCE_M = 1e-6


class Polygon:
    """
    A closed polygon, convex or not.

    What is inside is told by the even-odd rule. Its edge belongs to the outside: it may be touched.

    Parameters
    ----------
    corners
        At least three points, in order along the edge, in metres.
    """

    __slots__ = ("_high", "_low", "corners", "edges")

    def __init__(self, corners: Sequence[Point]) -> None:
        self.corners = tuple(corners)
        self.edges = tuple(zip(self.corners, (*self.corners[1:], self.corners[0]), strict=True))
        self._low = (min(x for x, _ in corners), min(y for _, y in corners))
        self._high = (max(x for x, _ in corners), max(y for _, y in corners))

    def covers(self, point: Point) -> bool:
        """Whether a point is inside, by casting a ray; for points on the edge either answer may come. Linear."""
        x, y = point
        inside = False
        for (x1, y1), (x2, y2) in self.edges:
            if (y1 > y) != (y2 > y) and x < x1 + (y - y1) * (x2 - x1) / (y2 - y1):
                inside = not inside
        return inside

    def holds(self, point: Point) -> bool:
        """Whether a point is inside by more than the tolerance. Linear."""
        if not self.near(point, point) or not self.covers(point):
            return False
        return all(distance_to_segment(point, *edge) > TOLERANCE_M for edge in self.edges)

    def near(self, start: Point, end: Point) -> bool:
        """Whether the boxes around polygon and segment meet: a quick test that rules most segments out."""
        return (
            min(start[0], end[0]) <= self._high[0]
            and max(start[0], end[0]) >= self._low[0]
            and min(start[1], end[1]) <= self._high[1]
            and max(start[1], end[1]) >= self._low[1]
        )

    def cuts(self, start: Point, end: Point) -> Iterator[float]:
        """
        Where a segment meets the edges: shares of its length, strictly between 0 and 1, in any order.

        Corners within the tolerance of the segment are among them, so that edges that lie along it are cut at both ends.
        """
        dx, dy = end[0] - start[0], end[1] - start[1]
        length = math.hypot(dx, dy)
        for (px, py), (qx, qy) in self.edges:
            ex, ey, ax, ay = qx - px, qy - py, px - start[0], py - start[1]
            turn = dx * ey - dy * ex
            if abs(dx * ay - dy * ax) <= TOLERANCE_M * length:
                share = (ax * dx + ay * dy) / length**2
            elif turn != 0 and 0 <= (ax * dy - ay * dx) / turn <= 1:
                share = (ax * ey - ay * ex) / turn
            else:
                continue
            if 0 < share < 1:
                yield share


def distance(start: Point, end: Point) -> float:
    """Straight distance in metres."""
    return math.hypot(end[0] - start[0], end[1] - start[1])


def distance_to_segment(point: Point, start: Point, end: Point) -> float:
    """Distance of a point from the nearest point of a segment, in metres."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    squared = dx * dx + dy * dy
    share = 0.0 if squared == 0 else ((point[0] - start[0]) * dx + (point[1] - start[1]) * dy) / squared
    share = min(1.0, max(0.0, share))
    return math.hypot(point[0] - start[0] - share * dx, point[1] - start[1] - share * dy)


def pierced(start: Point, end: Point, polygons: Sequence[Polygon]) -> Polygon | None:
    """
    A polygon that a segment passes through, or None if it stays outside all of them.

    The polygons count as one body: where two of them share an edge there is no way between. The segment is cut wherever it
    meets an edge; each piece lies wholly inside or wholly outside, which a point a tolerance to the left and one to the right of
    its middle tell. Touching an edge or a corner leaves at least one of the two outside.

    Parameters
    ----------
    start, end
        Ends of the segment; they may lie on edges.
    polygons
        The body. Quadratic in the number of edges that the segment meets, linear in all others.
    """
    close = [polygon for polygon in polygons if polygon.near(start, end)]
    length = distance(start, end)
    if not close or length <= TOLERANCE_M:
        return None
    aside = ((start[1] - end[1]) / length * TOLERANCE_M, (end[0] - start[0]) / length * TOLERANCE_M)
    cuts = sorted({0.0, 1.0, *(share for polygon in close for share in polygon.cuts(start, end))})
    for low, high in pairwise(cuts):
        if (high - low) * length <= TOLERANCE_M:
            continue
        middle = (low + high) / 2
        x, y = start[0] + middle * (end[0] - start[0]), start[1] + middle * (end[1] - start[1])
        left = _first_covering((x + aside[0], y + aside[1]), close)
        if left is not None and _first_covering((x - aside[0], y - aside[1]), close) is not None:
            return left
    return None


def _first_covering(point: Point, polygons: Sequence[Polygon]) -> Polygon | None:
    return next((polygon for polygon in polygons if polygon.covers(point)), None)
