"""Rows by hand: where boxes and columns stand from the top down."""

from __future__ import annotations

import pytest

from missiontree.reporting.tree.blocks import blocks_of
from missiontree.reporting.tree.cards import Card
from missiontree.reporting.tree.rows import (
    LEAST_GAP,
    LEAST_ROW,
    MARGIN,
    RAIL,
    STACK_GAP,
    even_columns,
    half_width,
    height_of,
    lay_out,
    reach_of,
    set_rows,
)
from tests.reporting.tree_builders import routine, shape, step, task

CHAIN = shape(task("root", task("left", step("a"), step("b"), step("c")), task("right", task("deep", routine("leaf")))))
#              0           1            2          3          4            5              6           7
CARDS = [Card((), (), width, 40, round=False) for width in (100, 100, 90, 110, 90, 100, 100, 100)]


def test_columns_are_as_wide_as_their_widest_box() -> None:
    even = even_columns(CARDS, blocks_of(CHAIN))
    assert [card.width for card in even] == [100, 100, 110, 110, 110, 100, 100, 100]


def test_a_column_reaches_below_its_level_where_nothing_is_in_its_way() -> None:
    """The column hangs from level 2: three boxes of 40 and two gaps of 15, so 150 high."""
    blocks = blocks_of(CHAIN)
    cards = even_columns(CARDS, blocks)
    column = blocks.of[2]
    assert height_of(column, blocks, cards) == 3 * 40 + 2 * STACK_GAP == 150
    # below its first box, 110 are left: rows of 30 with gaps of 27 below each take two
    assert reach_of(column, blocks, cards) == 2
    assert LEAST_ROW + LEAST_GAP == 57
    rows = set_rows(lay_out(CHAIN, cards, blocks), cards, blocks, [30, 30, 30, 30])
    # rows are 40 high, 30 apart: 26, 96, 166, 236; the column ends at 166 + 150 = 316, so the last row does not end before
    assert rows.tops == (26, 96, 166, 236)
    assert rows.bottoms == (66, 136, 206, 316)
    assert [rows.y[node] for node in (2, 3, 4)] == [186, 241, 296]
    assert rows.height == 316 + 30 + MARGIN


def test_a_column_stays_on_its_level_where_something_runs_below_it() -> None:
    blocks = blocks_of(CHAIN)
    cards = even_columns(CARDS, blocks)
    rows = set_rows(lay_out(CHAIN, cards, blocks), cards, blocks, [30, 30, 30, 30], closed={2})
    assert rows.bottoms[2] == 166 + 150
    assert rows.tops[3] == 166 + 150 + 30


def test_nothing_comes_into_the_room_that_a_column_keeps() -> None:
    """Below the narrow right branch stands a very wide box: it keeps away from the column all the same."""
    blocks = blocks_of(CHAIN)
    cards = even_columns([*CARDS[:7], Card((), (), 600, 40, round=False)], blocks)
    rows = set_rows(lay_out(CHAIN, cards, blocks), cards, blocks, [30, 30, 30, 30])
    assert rows.x[7] - 300 == pytest.approx(rows.x[2] + 55 + 30)


def test_boxes_that_hang_on_a_line_leave_room_for_it_at_both_sides() -> None:
    drawn = shape(task("all", *(routine(f"r{number}") for number in range(44))))
    blocks = blocks_of(drawn)
    cards = [Card((), (), 100, 40, round=False)] * len(drawn.nodes)
    assert half_width(0, blocks, cards) == 50
    assert half_width(1, blocks, cards) == 50 + RAIL
    rows = set_rows(lay_out(drawn, cards, blocks), cards, blocks, [30, 30])
    low, high = rows.sides[1]
    assert (low, high) == (rows.x[1] - 65, rows.x[1] + 65)
    assert rows.rail(1) == low + 1
    assert rows.rail(0) == rows.x[0]


def test_small_boxes_stand_in_the_middle_of_their_row() -> None:
    drawn = shape(task("all", routine("a"), routine("b")))
    cards = [Card((), (), 90, height, round=False) for height in (40, 80, 40)]
    blocks = blocks_of(drawn)
    rows = set_rows(lay_out(drawn, cards, blocks), cards, blocks, [30, 30])
    assert rows.y[1] == rows.y[2] == 26 + 40 + 30 + 40
