"""The blocked cells of a grid as few rectangles."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

from missiontree.mission.ways import OccupancyGrid

LEAST_CELL = 1.5
"""Cells smaller than that, in units of the picture, are drawn several as one."""


class Rect(NamedTuple):
    """Cells from a column and row on, counted from the upper left corner."""

    column: int
    row: int
    columns: int
    rows: int


@dataclass(frozen=True, slots=True)
class Walls:
    """
    What is blocked.

    Parameters
    ----------
    rects
        Rectangles that cover the blocked cells, each cell once.
    cell_m
        Side of their cells in metres.
    coarse
        How many cells of the grid are one of theirs, along each side; 1 if walls are drawn as they are.
    """

    rects: tuple[Rect, ...]
    cell_m: float
    coarse: int


def walls(grid: OccupancyGrid, scale: float) -> Walls:
    """
    Rectangles of a grid's walls; linear in its cells.

    Runs of blocked cells in a row become one, and so do equal runs in rows one above the other. Where cells would be too small to
    be seen, some are drawn as one, blocked if any of them is, so that no wall vanishes.

    Parameters
    ----------
    grid
        The map.
    scale
        Units of the picture for a metre.
    """
    coarse = max(1, math.ceil(LEAST_CELL / (grid.cell_m * scale))) if grid.cell_m * scale > 0 else len(grid.rows)
    coarse = min(coarse, max(len(grid.rows), len(grid.rows[0])))
    rows = _coarse(grid.rows, coarse) if coarse > 1 else grid.rows
    done: list[Rect] = []
    growing: dict[tuple[int, int], Rect] = {}
    for number, row in enumerate(rows):
        runs = _runs(row)
        still: dict[tuple[int, int], Rect] = {}
        for start, length in runs:
            before = growing.pop((start, length), None)
            still[start, length] = (
                Rect(start, number, length, 1) if before is None else before._replace(rows=before.rows + 1)
            )
        done += growing.values()
        growing = still
    done += growing.values()
    return Walls(tuple(sorted(done, key=lambda rect: (rect.row, rect.column))), grid.cell_m * coarse, coarse)


def _coarse(rows: tuple[str, ...], by: int) -> list[str]:
    merged = []
    for top in range(0, len(rows), by):
        band = rows[top : top + by]
        merged.append(
            "".join(
                "#" if any("#" in row[left : left + by] for row in band) else "." for left in range(0, len(rows[0]), by)
            )
        )
    return merged


def _runs(row: str) -> list[tuple[int, int]]:
    """Starts and lengths of the runs of blocked cells."""
    found: list[tuple[int, int]] = []
    start = row.find("#")
    while start >= 0:
        end = row.find(".", start)
        end = len(row) if end < 0 else end
        found.append((start, end - start))
        start = row.find("#", end)
    return found
