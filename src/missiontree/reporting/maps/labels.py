"""Finds room for labels: beside what they name, never over each other, off the lines where that can be had."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from missiontree.reporting.maps.boxes import STEP, Box, Cell, Point, cell_of, cells, steps

RINGS = (0.0, 8.0, 18.0, 32.0, 50.0, 72.0, 98.0, 128.0)
"""Distances from its mark at which a label may stand."""
LEADER_FROM = 18.0
"""A label that is farther from its mark than that gets a line to it."""
_LEADER = 10.0
_DIRECTIONS = tuple(
    (math.cos(math.radians(angle)), -math.sin(math.radians(angle)), cost)
    for angle, cost in (
        (0, 0.0),
        (180, 2.0),
        (90, 2.5),
        (270, 3.0),
        (45, 1.0),
        (315, 1.5),
        (135, 3.5),
        (225, 4.0),
        (22.5, 2.0),
        (337.5, 2.5),
        (157.5, 4.0),
        (202.5, 4.5),
        (67.5, 4.0),
        (112.5, 4.5),
        (247.5, 5.0),
        (292.5, 5.0),
    )
)
_STROKE = 6.0
"""Half the width of a line that a label should keep off."""
_APART = 9.0
_TOO_CLOSE = 16.0


@dataclass(frozen=True, slots=True)
class Placed:
    """
    A place for a label.

    Parameters
    ----------
    box
        Its rectangle.
    leader
        A line from its mark to it; None if it stands right beside.
    price
        How bad it is, by its distance and direction and by the lines it covers.
    """

    box: Box
    leader: tuple[Point, Point] | None
    price: float

    def covers(self) -> Iterator[Box]:
        """What it takes: its rectangle, and small ones along its leader."""
        yield self.box
        if self.leader is not None:
            for x, y in steps(*self.leader):
                yield _stroke(x, y)


def _stroke(x: float, y: float) -> Box:
    """What a leader takes at one of its points."""
    return Box(x - 2, y - 2, x + 2, y + 2)


class Ground:
    """
    What labels have to mind on a panel: marks are never covered, lines rather not.

    Parameters
    ----------
    bounds
        Nothing is placed outside.
    """

    def __init__(self, bounds: Box) -> None:
        self._bounds = bounds
        self._taken: dict[Cell, list[Box]] = {}
        self._marks: dict[Cell, list[Box]] = {}
        self._lines: dict[Cell, list[tuple[float, float, float]]] = {}

    def take(self, box: Box) -> None:
        """Keep labels off a rectangle."""
        for cell in cells(box):
            self._taken.setdefault(cell, []).append(box)

    def mark(self, box: Box) -> None:
        """Keep labels off a mark, and those of others a little away, so that nobody takes them for its own."""
        self.take(box)
        for cell in cells(box.grown(_APART)):
            self._marks.setdefault(cell, []).append(box)

    def discourage(self, points: Iterable[Point], weight: float) -> None:
        """Make it dear to cover a line: so much for every unit of its length."""
        last: Point | None = None
        for point in points:
            if last is not None:
                for x, y in steps(last, point):
                    self._lines.setdefault(cell_of(x, y), []).append((x, y, weight * STEP))
            last = point

    def free(self, box: Box) -> bool:
        """Whether a label may stand there."""
        return box.within(self._bounds) and not self._meets_what_is_taken(box)

    def _meets_what_is_taken(self, box: Box, mark: Box | None = None) -> bool:
        """Whether anything stands there, but for one mark."""
        for cell in cells(box):
            for other in self._taken.get(cell, ()):
                if box.meets(other) and other != mark:
                    return True
        return False

    def places(self, mark: Box, width: float, height: float, farthest: float) -> Iterator[Placed]:
        """
        Free places for a label round its mark, ring by ring.

        Parameters
        ----------
        mark
            What it names.
        width, height
            Its size.
        farthest
            How far from its mark it may stand.
        """
        for ring in RINGS:
            if ring > farthest:
                return
            for box, cost in _round(mark, width, height, ring):
                if not self.free(box):
                    continue
                start, end = _leader(mark, box)
                led = math.dist(start, end) >= LEADER_FROM
                if led and not self._clear(start, end, mark):
                    continue
                price = ring + cost + (_LEADER if led else 0.0) + self._price(box, mark)
                yield Placed(box, (start, end) if led else None, price)

    def place(self, mark: Box, width: float, height: float, farthest: float = RINGS[-1]) -> Placed | None:
        """Take the best free place for a label; None if there is none."""
        best = min(self.places(mark, width, height, farthest), key=lambda place: place.price, default=None)
        if best is not None:
            for box in best.covers():
                self.take(box)
        return best

    def takes(self, place: Placed, mark: Box) -> bool:
        """Take a place if it is still free; whether it was."""
        if not self.free(place.box) or (place.leader is not None and not self._clear(*place.leader, mark)):
            return False
        for box in place.covers():
            self.take(box)
        return True

    def _price(self, box: Box, mark: Box) -> float:
        wide, apart = box.grown(_STROKE), box.grown(_APART)
        covered = math.fsum(
            weight
            for cell in cells(wide)
            for x, y, weight in self._lines.get(cell, ())
            if wide.left < x < wide.right and wide.top < y < wide.bottom
        )
        close = {
            other for cell in cells(box) for other in self._marks.get(cell, ()) if other != mark and apart.meets(other)
        }
        return covered + _TOO_CLOSE * len(close)

    def _clear(self, start: Point, end: Point, mark: Box) -> bool:
        """Whether a leader crosses nothing that is taken."""
        return not any(self._meets_what_is_taken(_stroke(x, y), mark) for x, y in steps(start, end))


def _round(mark: Box, width: float, height: float, ring: float) -> Iterator[tuple[Box, float]]:
    """Rectangles round a mark at a distance, with what each direction costs."""
    x, y = (mark.left + mark.right) / 2, (mark.top + mark.bottom) / 2
    half_width, half_height = (mark.right - mark.left) / 2 + 3 + ring, (mark.bottom - mark.top) / 2 + 2 + ring
    for across, down, cost in _DIRECTIONS:
        middle_x = x + across * (half_width + width / 2)
        middle_y = y + down * (half_height + height / 2)
        box = Box(middle_x - width / 2, middle_y - height / 2, middle_x + width / 2, middle_y + height / 2)
        yield box, cost
        if abs(across) == 1.0 and height > 20:  # beside its mark, a tall label may begin or end level with it
            yield Box(box.left, y - 8, box.right, y - 8 + height), cost + 0.5
            yield Box(box.left, y + 8 - height, box.right, y + 8), cost + 1.0
        if abs(down) == 1.0 and width > 40:  # above and below, it may be moved along
            yield Box(x - 10, box.top, x - 10 + width, box.bottom), cost + 0.5
            yield Box(x + 10 - width, box.top, x + 10, box.bottom), cost + 1.0


def _leader(mark: Box, box: Box) -> tuple[Point, Point]:
    """From the edge of a mark, taken as round, to the nearest point of a label."""
    x, y = (mark.left + mark.right) / 2, (mark.top + mark.bottom) / 2
    end = (min(max(x, box.left), box.right), min(max(y, box.top), box.bottom))
    length = math.dist((x, y), end)
    if length == 0:
        return end, end
    radius = min((mark.right - mark.left) / 2, length)
    return (x + (end[0] - x) * radius / length, y + (end[1] - y) * radius / length), end
