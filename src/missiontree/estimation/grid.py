"""Ways over an occupancy grid: from cell to cell in eight directions, no corner cut."""

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
from missiontree.mission.ways import OccupancyGrid

_DIAGONAL = math.sqrt(2)
_WALL = "a wall"
_CLOSED_COST = 1e9
_CELLS_REMEMBERED = 1_000_000


class GridWays:
    """
    Shortest ways over the free cells of a grid.

    A cell is closed if it is ``#`` or if its centre is inside a closed area. Robots go from centre to centre, to eight
    neighbours; a diagonal step needs both cells beside it free. A point counts as being in its cell and is joined to the
    centre straight, so that a way is never shorter than the straight line; two points of one cell are joined straight. A
    point on the border of cells belongs to the one right of it and above.

    Building costs O(cells + cells in closed areas * their corners); all legs from one cell share one run of Dijkstra's
    algorithm, O(cells * log cells), which goes only as far as it must.

    Parameters
    ----------
    grid
        The map.
    access
        What is closed to the robot type.
    """

    def __init__(self, grid: OccupancyGrid, access: Access) -> None:
        self._grid = grid
        self._width = len(grid.rows[0]) + 2  # a closed border saves asking for it at every step
        self._obstacles = Obstacles(access.on_floor(grid.floor))
        self._closed = self._walls()
        self._free = bytearray(b"\x01") * (self._width * (len(grid.rows) + 2))
        for cell in self._closed:
            self._free[cell] = 0
        self._trees: dict[int, ShortestTree] = {}

    def _walls(self) -> dict[int, str]:
        """Name of what closes a cell, for every closed cell."""
        rows = ["#" * self._width, *(f"#{row}#" for row in self._grid.rows), "#" * self._width]
        closed: dict[int, str] = {}
        for cell, mark in enumerate("".join(rows)):
            if mark == "#":
                closed[cell] = _WALL
            elif (name := self._obstacles.holding(self._centre(cell))) is not None:
                closed[cell] = name
        return closed

    def leg(self, origin: Position, destination: Position, speed_mps: float = 1.0) -> Leg | Blocked:
        """Find the shortest way; see :class:`missiontree.estimation.travel.Ways`. The speed makes no difference."""
        refusal = self._refusal(origin) or self._refusal(destination)
        if refusal is not None:
            return refusal
        start, goal = self._cell(xy(origin)), self._cell(xy(destination))
        if start == goal:
            return Leg(distance(xy(origin), xy(destination)))
        tree = self._tree(start)
        if tree.cost(goal) is None:
            return self._cut_off(origin, start, destination, goal)
        ends = distance(xy(origin), self._centre(start)) + distance(xy(destination), self._centre(goal))
        return Leg(self._length_m(tree.way(goal)) + ends)

    def _tree(self, start: int) -> ShortestTree:
        tree = self._trees.get(start)
        if tree is None:
            if len(self._trees) > _CELLS_REMEMBERED // len(self._free):  # large grids: the oldest goes, or memory would
                del self._trees[next(iter(self._trees))]
            tree = self._trees[start] = ShortestTree(start, self._neighbours)
        return tree

    def _length_m(self, way: list[int]) -> float:
        # Steps are counted, not summed up, so that the length does not hang on their order.
        diagonal = sum(abs(end - start) not in {1, self._width} for start, end in pairwise(way))
        return (len(way) - 1 - diagonal + diagonal * _DIAGONAL) * self._grid.cell_m

    def _neighbours(self, cell: int) -> Iterable[tuple[int, float]]:
        free, width = self._free, self._width
        for across in (-1, 1):
            if free[cell + across]:
                yield cell + across, 1.0
        for down in (-width, width):
            if not free[cell + down]:
                continue
            yield cell + down, 1.0
            for across in (-1, 1):
                if free[cell + across] and free[cell + down + across]:
                    yield cell + down + across, _DIAGONAL

    def _cell(self, point: Point) -> int:
        """Number of the cell that a point of the grid is in."""
        column, row = self._column_and_row(point)
        return (row + 1) * self._width + column + 1

    def _column_and_row(self, point: Point) -> tuple[int, int]:
        grid = self._grid
        across, up = (point[0] - grid.x_m) / grid.cell_m, (point[1] - grid.y_m) / grid.cell_m
        return _index(across, len(grid.rows[0])), len(grid.rows) - 1 - _index(up, len(grid.rows))

    def _centre(self, cell: int) -> Point:
        grid = self._grid
        row, column = divmod(cell, self._width)
        return (
            grid.x_m + (column - 0.5) * grid.cell_m,
            grid.y_m + (len(grid.rows) - row + 0.5) * grid.cell_m,
        )

    def _refusal(self, position: Position) -> Blocked | None:
        """Why a robot may not stand at a position; None if it may."""
        if position.floor != self._grid.floor:
            return unreachable(
                f"{describe(position)} is not on floor {self._grid.floor}, the only floor of the grid.",
                hint="several floors need a road graph with lifts",
            )
        column, row = self._column_and_row(xy(position))
        if not (0 <= column < len(self._grid.rows[0]) and 0 <= row < len(self._grid.rows)):
            return unreachable(f"{describe(position)} is outside the grid, which spans {self._span()}.")
        closed = self._closed.get(self._cell(xy(position)))
        if closed == _WALL:
            return unreachable(
                f"{describe(position)} is inside a wall.", found=f"row {row + 1}, cell {column + 1} of the grid is '#'"
            )
        if closed is not None:
            return unreachable(
                f"{describe(position)} is in a cell of {closed}, which is closed to the robot.", found=closed
            )
        return self._obstacles.forbid(position)

    def _span(self) -> str:
        grid = self._grid
        x_m, y_m = grid.x_m + len(grid.rows[0]) * grid.cell_m, grid.y_m + len(grid.rows) * grid.cell_m
        return f"x from {grid.x_m:g} to {x_m:g} and y from {grid.y_m:g} to {y_m:g}"

    def _cut_off(self, origin: Position, start: int, destination: Position, goal: int) -> Blocked:
        """Why there is no way: what closes the cells that would have to be opened, as few as can be."""
        tree = ShortestTree(start, self._through_areas)
        apart = f"No way from {describe(origin)} to {describe(destination)}"
        if tree.cost(goal) is None:
            return unreachable(f"{apart}: walls of the grid lie between.", found="walls")
        names = dict.fromkeys(self._closed[cell] for cell in tree.way(goal) if cell in self._closed)
        found = " and ".join(names)
        return unreachable(f"{apart}: closed off by {found}.", found=found)

    def _through_areas(self, cell: int) -> Iterable[tuple[int, float]]:
        for step in (-self._width, -1, 1, self._width):
            if self._free[cell + step]:
                yield cell + step, 1.0
            elif self._closed[cell + step] in self._obstacles.names.values():
                yield cell + step, _CLOSED_COST


def _index(share: float, count: int) -> int:
    """Cell along one side, from 0; the far border of the grid still belongs to its last cell."""
    index = math.floor(share + 1e-9)
    return count - 1 if index == count and share <= count + 1e-9 else index
