"""Cells of an occupancy grid that would have to be cleared: of those that close a way, the fewest."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator
from dataclasses import replace

from missiontree.estimation.travel import start_of
from missiontree.explaining.case import Case
from missiontree.explaining.changes.editing import with_scene
from missiontree.explaining.changes.needs import Needs
from missiontree.mission.change import Change
from missiontree.mission.position import Position
from missiontree.mission.ways import OccupancyGrid

Cell = tuple[int, int]
"""Row from the top, column from the left; from 0."""
MOST_CELLS = 20
"""What needs more cells cleared is another building."""


def candidates(case: Case, needs: Needs) -> Iterator[Change]:
    """For each start of a robot and each place that the mission names: the fewest cells that close the way between them."""
    grid, world = case.brief.world.grid, case.brief.world.extended(case.tree.entities)
    if grid is None:
        return
    starts = {start_of(robot, world) for kind in case.brief.fleet.types for robot in kind.members}
    named = dict.fromkeys(name for node in case.tree.nodes for name in node.arguments.values())
    goals = [world.whereabouts(world.by_id[name]).position for name in named if name in world.by_id]
    found: dict[Change, None] = {}
    for start in sorted(_cells_of(grid, starts)):
        closed = fewest_closed(grid, start)
        for goal in dict.fromkeys(_cells_of(grid, goals)):
            if 0 < len(closed.get(goal, ())) <= MOST_CELLS:
                found[
                    Change(kind="clear_cells", target=" ".join(f"{row},{column}" for row, column in closed[goal]))
                ] = None
    yield from found


def _cells_of(grid: OccupancyGrid, positions: Iterable[Position | None]) -> set[Cell]:
    """Cells that positions lie in, as far as they lie on the grid."""
    cells = set()
    for position in positions:
        if position is None or position.floor != grid.floor:
            continue
        column = int((position.x_m - grid.x_m) // grid.cell_m)
        row = len(grid.rows) - 1 - int((position.y_m - grid.y_m) // grid.cell_m)
        if 0 <= row < len(grid.rows) and 0 <= column < len(grid.rows[0]):
            cells.add((row, column))
    return cells


def fewest_closed(grid: OccupancyGrid, start: Cell) -> dict[Cell, tuple[Cell, ...]]:
    """
    For each cell, the closed cells on a way there that has the fewest of them, by steps to the four sides.

    A search that takes free cells first (0-1 breadth-first search): linear in the cells.
    """
    closed: dict[Cell, int] = {start: grid.rows[start[0]][start[1]] == "#"}
    came: dict[Cell, Cell] = {}
    waiting = deque([start])
    while waiting:
        row, column = cell = waiting.popleft()
        for beside in ((row - 1, column), (row, column - 1), (row, column + 1), (row + 1, column)):
            if not (0 <= beside[0] < len(grid.rows) and 0 <= beside[1] < len(grid.rows[0])):
                continue
            more = grid.rows[beside[0]][beside[1]] == "#"
            if closed[cell] + more < closed.get(beside, len(grid.rows) * len(grid.rows[0]) + 1):
                closed[beside], came[beside] = closed[cell] + more, cell
                (waiting.append if more else waiting.appendleft)(beside)
    return {cell: _closed_on_way(grid, came, cell) for cell in closed if closed[cell] <= MOST_CELLS}


def _closed_on_way(grid: OccupancyGrid, came: dict[Cell, Cell], cell: Cell) -> tuple[Cell, ...]:
    way = [cell]
    while way[-1] in came:
        way.append(came[way[-1]])
    return tuple(one for one in reversed(way) if grid.rows[one[0]][one[1]] == "#")


def clear_cells(case: Case, change: Change) -> Case:
    """Closed cells are free."""
    grid = case.brief.world.grid
    assert grid is not None, "only cells there are can be cleared"
    rows = [list(row) for row in grid.rows]
    for row, column in _named(change):
        rows[row][column] = "."
    return with_scene(case, grid=replace(grid, rows=tuple("".join(row) for row in rows)))


def clear_cells_words(case: Case, change: Change) -> str:
    """As an order: where the cells are, in metres."""
    grid = case.brief.world.grid
    assert grid is not None, "only cells there are can be cleared"
    cells = [
        f"({grid.x_m + (column + 0.5) * grid.cell_m:g}, {grid.y_m + (len(grid.rows) - row - 0.5) * grid.cell_m:g})"
        for row, column in _named(change)
    ]
    if len(cells) == 1:
        return f"clear the cell of the grid at {cells[0]}"
    return f"clear {len(cells)} cells of the grid, at {', '.join(cells)}"


def _named(change: Change) -> list[Cell]:
    pairs = (cell.split(",") for cell in change.target.split())
    return [(int(row), int(column)) for row, column in pairs]
