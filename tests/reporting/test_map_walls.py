"""Walls as rectangles: every blocked cell once, no free one."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from missiontree.mission.ways import OccupancyGrid
from missiontree.reporting.maps.walls import LEAST_CELL, Rect, walls

BLOCKS = st.lists(st.text(".#", min_size=9, max_size=9), min_size=1, max_size=9)


def cells(rects: tuple[Rect, ...]) -> list[tuple[int, int]]:
    return [
        (column, row)
        for rect in rects
        for column in range(rect.column, rect.column + rect.columns)
        for row in range(rect.row, rect.row + rect.rows)
    ]


@given(BLOCKS)
def test_every_blocked_cell_is_covered_once_and_no_free_one(rows: list[str]) -> None:
    drawn = walls(OccupancyGrid(rows=tuple(rows), cell_m=1.0), 10.0)
    blocked = [(column, row) for row, line in enumerate(rows) for column, sign in enumerate(line) if sign == "#"]
    assert sorted(cells(drawn.rects)) == sorted(blocked)
    assert drawn.coarse == 1


def test_a_wall_is_few_rectangles() -> None:
    """The frame of a room of 40 by 30 cells: top, bottom, left, right."""
    rows = ("#" * 40, *(f"#{'.' * 38}#",) * 28, "#" * 40)
    assert walls(OccupancyGrid(rows=rows, cell_m=1.0), 10.0).rects == (
        Rect(0, 0, 40, 1),
        Rect(0, 1, 1, 28),
        Rect(39, 1, 1, 28),
        Rect(0, 29, 40, 1),
    )


@given(BLOCKS, st.integers(2, 5))
def test_where_cells_are_too_small_to_be_seen_no_wall_vanishes(rows: list[str], by: int) -> None:
    """At that scale a cell is 1.5 / by units wide, so that by cells make one that can be seen."""
    drawn = walls(OccupancyGrid(rows=tuple(rows), cell_m=1.0), LEAST_CELL / by)
    assert drawn.coarse == by
    covered = set(cells(drawn.rects))
    for row, line in enumerate(rows):
        for column, sign in enumerate(line):
            if sign == "#":
                assert (column // by, row // by) in covered


def test_a_large_grid_stays_small() -> None:
    """A million cells, every other one a wall, at a thousand units a side: no rectangle below a unit and a half."""
    rows = tuple("".join("#." if row % 2 else ".#" for _ in range(500)) for row in range(1000))
    drawn = walls(OccupancyGrid(rows=rows, cell_m=0.05), 20.0)
    assert drawn.coarse == 2
    assert len(drawn.rects) == 1
