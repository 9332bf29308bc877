"""Shortest ways on an occupancy grid: from cell centre to cell centre in 8 directions, cutting no corners."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from missiontree.checking.closed import closed_areas, inside
from missiontree.checking.dijkstra import shortest
from missiontree.mission.area import Corner
from missiontree.mission.fleet import RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.ways import OccupancyGrid

Cell = tuple[int, int]
"""Column from the left and row from below, both from 0."""


MOST_KEPT = 1_000_000
"""Lengths remembered, by start and goal; grids can be large."""
MOST_JOINED = 50_000
"""Cells of a grid whose neighbours are remembered."""


class GridWays:
    """
    The cells that one robot type may enter: free ones whose centre no closed area holds.

    A point is joined to the centre of its cell straight; two points of one cell are joined straight.

    Parameters
    ----------
    scene
        Where the closed areas are.
    grid
        The map of cells.
    robot_type
        Who travels.
    """

    def __init__(self, scene: Scene, grid: OccupancyGrid, robot_type: RobotType) -> None:
        self._grid = grid
        self._areas = areas = closed_areas(robot_type, scene, grid.floor)
        cells = (
            (column, row)
            for row, marks in enumerate(reversed(grid.rows))
            for column, mark in enumerate(marks)
            if mark == "."
        )
        self._free = {cell for cell in cells if not any(inside(self._centre(cell), area) for area in areas)}
        self._lengths: dict[Cell, dict[Cell, float]] = {}
        self._joined: dict[Cell, list[tuple[Cell, float]]] = {}

    def least(self, origin: Position, destination: Position, speed_mps: float | None) -> float:
        """See :class:`missiontree.checking.ways.Map`."""
        metres = self._metres(origin, destination)
        return metres if speed_mps is None else metres / speed_mps

    def _metres(self, origin: Position, destination: Position) -> float:
        start, goal = self._cell(origin), self._cell(destination)
        if {origin.floor, destination.floor} != {self._grid.floor} or not {start, goal} <= self._free:
            return math.inf
        here, there = (origin.x_m, origin.y_m), (destination.x_m, destination.y_m)
        if any(inside(point, area) for point in (here, there) for area in self._areas):
            return math.inf
        if start == goal:
            return math.dist(here, there)
        if start not in self._lengths:
            if (len(self._lengths) + 1) * len(self._free) > MOST_KEPT:
                self._lengths.clear()
            self._lengths[start] = shortest([(start, 0.0)], self._neighbours)
        steps = self._lengths[start].get(goal, math.inf)
        return math.dist(here, self._centre(start)) + steps + math.dist(there, self._centre(goal))

    def _neighbours(self, cell: Cell) -> Iterable[tuple[Cell, float]]:
        if len(self._free) > MOST_JOINED:
            return self._beside(cell)
        found = self._joined.get(cell)
        if found is None:
            found = self._joined[cell] = list(self._beside(cell))
        return found

    def _beside(self, cell: Cell) -> Iterator[tuple[Cell, float]]:
        column, row = cell
        for across in (-1, 0, 1):
            for up in (-1, 0, 1):
                passed = ((column + across, row), (column, row + up), (column + across, row + up))
                if (across or up) and all(other in self._free for other in passed):
                    yield (column + across, row + up), math.hypot(across, up) * self._grid.cell_m

    def _cell(self, position: Position) -> Cell:
        grid = self._grid
        columns, rows = len(grid.rows[0]), len(grid.rows)
        return (
            _index((position.x_m - grid.x_m) / grid.cell_m, columns),
            _index((position.y_m - grid.y_m) / grid.cell_m, rows),
        )

    def _centre(self, cell: Cell) -> Corner:
        grid = self._grid
        return (grid.x_m + (cell[0] + 0.5) * grid.cell_m, grid.y_m + (cell[1] + 0.5) * grid.cell_m)


def _index(share: float, count: int) -> int:
    """Cell along one side; points on a border belong to the cell above it, those on the far border of the grid to its last."""
    if not abs(share) < 1e9:
        return -1
    index = math.floor(share + 1e-9)
    return count - 1 if index == count and share <= count + 1e-9 else index
