"""A floor of the map as lines of characters."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from itertools import accumulate, pairwise

from rich.cells import cell_len

from missiontree.estimation.polygon import Polygon
from missiontree.mission.ways import OccupancyGrid
from missiontree.reporting.escape import one_line
from missiontree.reporting.maps.cards import name_of
from missiontree.reporting.maps.clusters import resting
from missiontree.reporting.maps.layout import MapLayout, Panel
from missiontree.reporting.maps.legend import metres, round_length
from missiontree.reporting.maps.routes import Route
from missiontree.reporting.maps.things import MapContent, Thing, ThingKind

TALLEST = 26
"""Lines of a floor at most."""
SIGNS: dict[ThingKind, str] = {
    "place": "■",
    "lift": "↕",
    "person": "☺",
    "animal": "♞",
    "object": "□",
    "robot": "®",
    "node": "+",
}
UNSURE, WALL, CLOSED, PARTLY, ROAD, SHARED = "?", "█", "░", ":", "·", "*"
LONGEST = 18
_ASPECT = 2.0
"""A character is about twice as high as wide."""


class CharacterMap:
    """
    What is on a floor, each thing with its name where there is room.

    Parameters
    ----------
    content, routes
        What is shown; ways are written as the small letter of their robot.
    layout, panel
        Where it is.
    width
        Characters of a line.
    """

    def __init__(
        self, content: MapContent, layout: MapLayout, panel: Panel, routes: Sequence[Route], width: int
    ) -> None:
        self._layout, self._panel = layout, panel
        self._unit = max(panel.width / width, panel.height / TALLEST / _ASPECT)
        self._columns = max(1, math.floor(panel.width / self._unit))
        self._rows = max(1, math.ceil(panel.height / self._unit / _ASPECT))
        self._signs = [[" "] * self._columns for _ in range(self._rows)]
        self._named: set[tuple[int, int]] = set()
        self._ground(content)
        self._ways(routes)
        self._things(content, routes)

    def lines(self) -> list[str]:
        """From the top, without blank lines above and below."""
        lines = ["".join(row).rstrip() for row in self._signs]
        filled = [number for number, line in enumerate(lines) if line]
        return lines[filled[0] : filled[-1] + 1] if filled else []

    def scale(self) -> str:
        """A bar of a round length."""
        length_m = round_length(14 * self._unit / self._layout.scale)
        bar = max(2, round(length_m * self._layout.scale / self._unit))
        return f"├{'─' * (bar - 2)}┤ {metres(length_m)}"

    def _cell(self, x_m: float, y_m: float) -> tuple[int, int] | None:
        """Column and row of a point; None if it is outside."""
        point = self._layout.at(x_m, y_m, self._panel.floor)
        if point is None:
            return None
        column = math.floor((point[0] - self._panel.x) / self._unit)
        row = math.floor((point[1] - self._panel.y) / self._unit / _ASPECT)
        return (column, row) if 0 <= column < self._columns and 0 <= row < self._rows else None

    def _put(self, cell: tuple[int, int] | None, sign: str) -> None:
        if cell is not None:
            self._signs[cell[1]][cell[0]] = sign

    def _ground(self, content: MapContent) -> None:
        closed = [shown for shown in content.areas if shown.role == "keep_out"]
        for shown in sorted(closed, key=lambda shown: shown.closed_to is None):  # what is closed to all lies on top
            if shown.area.floor == self._panel.floor:
                self._fill(Polygon(shown.area.corners), CLOSED if shown.closed_to is None else PARTLY)
        if content.scene.grid is not None and content.scene.grid.floor == self._panel.floor:
            self._walls(content.scene.grid)
        for road in content.roads:
            if road.start.floor == self._panel.floor:
                for cell in self._between((road.start.x_m, road.start.y_m), (road.end.x_m, road.end.y_m)):
                    self._put(cell, ROAD)

    def _fill(self, polygon: Polygon, sign: str) -> None:
        for cell, point in self._middles():
            if polygon.covers(point):
                self._put(cell, sign)

    def _walls(self, grid: OccupancyGrid) -> None:
        """A character is wall if any blocked cell has its middle in it, or it has its own in a blocked cell."""
        for number, row in enumerate(reversed(grid.rows)):
            for column, sign in enumerate(row):
                if sign == "#":
                    x_m, y_m = grid.x_m + (column + 0.5) * grid.cell_m, grid.y_m + (number + 0.5) * grid.cell_m
                    self._put(self._cell(x_m, y_m), WALL)
        for cell, (x_m, y_m) in self._middles():
            column, number = math.floor((x_m - grid.x_m) / grid.cell_m), math.floor((y_m - grid.y_m) / grid.cell_m)
            if (
                0 <= column < len(grid.rows[0])
                and 0 <= number < len(grid.rows)
                and grid.rows[-1 - number][column] == "#"
            ):
                self._put(cell, WALL)

    def _middles(self) -> Iterator[tuple[tuple[int, int], tuple[float, float]]]:
        """Every character with the point in its middle, in metres."""
        panel, layout = self._panel, self._layout
        for row in range(self._rows):
            y_m = layout.y_m - ((row + 0.5) * self._unit * _ASPECT - panel.height / 2) / layout.scale
            for column in range(self._columns):
                yield (column, row), (layout.x_m + ((column + 0.5) * self._unit - panel.width / 2) / layout.scale, y_m)

    def _ways(self, routes: Sequence[Route]) -> None:
        taken: dict[tuple[int, int], str] = {}
        for route in routes:
            sign = route.letter.lower()
            for passage in route.passages:
                for start, end in pairwise(passage.line):
                    if start.floor == end.floor == self._panel.floor:
                        for cell in self._between((start.x_m, start.y_m), (end.x_m, end.y_m)):
                            if cell is not None:
                                taken[cell] = sign if taken.get(cell, sign) == sign and len(sign) == 1 else SHARED
        for cell, sign in taken.items():
            self._put(cell, sign)

    def _things(self, content: MapContent, routes: Sequence[Route]) -> None:
        still = resting(content.things, routes)
        here = [thing for thing in still if thing.spot.floor == self._panel.floor and thing.kind != "node"]
        starts = [route for route in routes if route.start is not None and route.start.floor == self._panel.floor]
        signs = [(self._cell(thing.spot.x_m, thing.spot.y_m), self._sign(thing), name_of(thing)) for thing in here]
        for route in starts:
            assert route.start is not None
            signs.append((self._cell(route.start.x_m, route.start.y_m), route.letter, one_line(route.robot)))
        first = {cell: sign for cell, sign, _ in reversed(signs) if cell is not None}
        for cell, sign in first.items():
            self._put(cell, sign[:1])
            self._named.add(cell)
        names: dict[tuple[int, int], list[str]] = {}
        for found, _, name in signs:
            if found is not None:
                names.setdefault(found, []).append(name)
        for cell, called in names.items():
            more = f" +{len(called) - 1}" if len(called) > 1 else ""
            self._name(cell, _cut(called[0], LONGEST) + more)

    @staticmethod
    def _sign(thing: Thing) -> str:
        return SIGNS[thing.kind] if thing.sure else UNSURE

    def _name(self, cell: tuple[int, int], name: str) -> None:
        """A name beside its sign, or below or above, where nothing with a name is."""
        length, (column, row) = _columns_of(name), cell
        for start, line in ((column + 2, row), (column - 1 - length, row), (column, row + 1), (column, row - 1)):
            span = [(at, line) for at in range(start - 1, start + length + 1)]
            inside = start >= 0 and start + length <= self._columns and 0 <= line < self._rows
            if inside and not any(one in self._named for one in span if one != cell):
                self._write(start, line, name, length)
                self._named.update(span)
                return

    def _write(self, start: int, row: int, name: str, length: int) -> None:
        for column in (start - 1, start + length):
            if 0 <= column < self._columns and (column, row) not in self._named:
                self._signs[row][column] = " "
        column = start
        for letter in name:
            room = cell_len(letter)
            if room == 0 and column > start:
                self._signs[row][column - 1] += letter  # a mark over the letter before
                continue
            self._signs[row][column] = letter
            for rest in range(1, room):
                self._signs[row][column + rest] = ""
            column += room

    def _between(self, start: tuple[float, float], end: tuple[float, float]) -> Iterator[tuple[int, int] | None]:
        """Cells along a line."""
        apart = math.dist(start, end) * self._layout.scale / self._unit
        count = max(1, math.ceil(2 * apart))
        for step in range(count + 1):
            share = step / count
            yield self._cell(start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1]))


def _cut(name: str, most: int) -> str:
    """A name that takes so many columns at most."""
    widths = list(accumulate(map(cell_len, name), initial=0))
    return name if widths[-1] <= most else f"{name[: max(0, bisect_right(widths, most - 1) - 1)]}…"


def _columns_of(name: str) -> int:
    """Columns that a name takes when its letters stand in cells of their own, as they do here: nothing is joined."""
    return sum(map(cell_len, name))
