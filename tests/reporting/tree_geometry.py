"""Plane geometry that the tests of drawn trees argue with."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

from missiontree.reporting.tree.placing import Placed

Point = tuple[float, float]
NEAR = 1e-6


class Box(NamedTuple):
    """A rectangle."""

    left: float
    top: float
    right: float
    bottom: float

    def meets(self, other: Box) -> bool:
        """Whether two rectangles have more than their edges in common."""
        return (
            self.left < other.right - NEAR
            and other.left < self.right - NEAR
            and self.top < other.bottom - NEAR
            and other.top < self.bottom - NEAR
        )

    def holds(self, other: Box) -> bool:
        """Whether the other rectangle lies in this one."""
        return (
            self.left <= other.left + NEAR
            and self.top <= other.top + NEAR
            and other.right <= self.right + NEAR
            and other.bottom <= self.bottom + NEAR
        )


def box_of(tree: Placed, node: int) -> Box:
    """The rectangle round a node."""
    x, y, card = tree.rows.x[node], tree.rows.y[node], tree.cards[node]
    return Box(x - card.width / 2, y - card.height / 2, x + card.width / 2, y + card.height / 2)


def passes(start: Point, end: Point, box: Box) -> bool:
    """Whether a stretch has a point inside a rectangle, found by cutting the stretch at the rectangle's sides."""
    low, high = 0.0, 1.0
    for axis, (least, most) in enumerate(((box.left, box.right), (box.top, box.bottom))):
        origin, way = start[axis], end[axis] - start[axis]
        if abs(way) < NEAR:
            if not least + NEAR < origin < most - NEAR:
                return False
            continue
        first, second = sorted(((least - origin) / way, (most - origin) / way))
        low, high = max(low, first), min(high, second)
    return high - low > NEAR


def crosses(one: tuple[Point, Point], other: tuple[Point, Point]) -> bool:
    """Whether two stretches cross, each with its ends on different sides of the other; touching is no crossing."""
    return _parts(one, other) and _parts(other, one)


def _parts(line: tuple[Point, Point], ends: tuple[Point, Point]) -> bool:
    first, second = (_side(line, point) for point in ends)
    return (first > NEAR and second < -NEAR) or (first < -NEAR and second > NEAR)


def _side(line: tuple[Point, Point], point: Point) -> float:
    (x1, y1), (x2, y2) = line
    length = ((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5 or 1.0
    return ((x2 - x1) * (point[1] - y1) - (y2 - y1) * (point[0] - x1)) / length


def edges_of(tree: Placed) -> Iterator[tuple[int, int, tuple[Point, Point]]]:
    """Every stretch of every edge of the tree, with the parent and the child; of a stem, the parent twice."""
    for fork in tree.forks:
        yield fork.node, fork.node, (fork.foot, fork.at)
        for branch in fork.branches:
            points = [branch.fork, branch.over, *((branch.turn,) if branch.turn else ()), branch.end]
            yield from ((fork.node, branch.child, stretch) for stretch in pairwise(points))
