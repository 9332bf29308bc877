"""Rectangles of the picture, and the cells by which those near a point are found."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

Point = tuple[float, float]
Cell = tuple[int, int]

STEP = 6.0
"""Distance of the points that stand for a line."""
_CELL = 24.0


@dataclass(frozen=True, slots=True)
class Box:
    """A rectangle: left, top, right, bottom."""

    left: float
    top: float
    right: float
    bottom: float

    def meets(self, other: Box) -> bool:
        """Whether two rectangles have more than an edge in common."""
        return (
            self.left < other.right and other.left < self.right and self.top < other.bottom and other.top < self.bottom
        )

    def within(self, other: Box) -> bool:
        """Whether it is inside another."""
        return (
            self.left >= other.left
            and self.top >= other.top
            and self.right <= other.right
            and self.bottom <= other.bottom
        )

    def grown(self, by: float) -> Box:
        """The same, larger on every side."""
        return Box(self.left - by, self.top - by, self.right + by, self.bottom + by)


def cell_of(x: float, y: float) -> Cell:
    """The cell of a point, for looking up what is near."""
    return math.floor(x / _CELL), math.floor(y / _CELL)


def cells(box: Box) -> list[Cell]:
    """The cells that a rectangle touches."""
    rows = range(math.floor(box.top / _CELL), math.floor(box.bottom / _CELL) + 1)
    columns = range(math.floor(box.left / _CELL), math.floor(box.right / _CELL) + 1)
    return [(column, row) for column in columns for row in rows]


def steps(start: Point, end: Point) -> Iterator[Point]:
    """Points along a line, about every six units."""
    count = max(1, math.ceil(math.dist(start, end) / STEP))
    for step in range(count + 1):
        yield start[0] + (end[0] - start[0]) * step / count, start[1] + (end[1] - start[1]) * step / count
