"""Where the boxes of a drawn tree stand: from left to right as the tidy layout has it, from the top down row by row."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

from missiontree.reporting.tree.blocks import Blocks
from missiontree.reporting.tree.cards import Card
from missiontree.reporting.tree.layout import Layout, tidy_layout
from missiontree.reporting.tree.shape import Shape

MARGIN = 26.0
SIBLING_GAP, FRAME_PADDING = 30.0, 10.0
STRAIGHT = 30.0
"""Edges do not go aside by so little: it would look like a mistake."""
STACK_GAP = 15.0
LEAST_ROW, LEAST_GAP = 30.0, 27.0
"""No row is lower, no two are closer to each other."""
RAIL = 15.0
"""From the line that a column hangs on to its boxes."""


@dataclass(frozen=True, slots=True)
class Rows:
    """
    Where everything stands on the page.

    Parameters
    ----------
    x, y
        Middle of every box.
    level
        Row of every box.
    tops, bottoms
        Upper and lower edge of every row. Columns may reach below theirs, where nothing else is.
    spans
        Left and right edge of every frame, by node.
    blocks
        What is laid out.
    sides
        Left and right edge of every block; of a column, the line that it hangs on included.
    width, height
        Size of the page.
    """

    x: tuple[float, ...]
    y: tuple[float, ...]
    level: tuple[int, ...]
    tops: tuple[float, ...]
    bottoms: tuple[float, ...]
    spans: dict[int, tuple[float, float]]
    blocks: Blocks
    sides: tuple[tuple[float, float], ...]
    width: float
    height: float

    def rail(self, block: int) -> float:
        """Where the line that leads to a block comes down: on the middle of a box, at the side of a column."""
        low, high = self.sides[block]
        return low + 1 if self.blocks.hangs(block) else (low + high) / 2


def even_columns(cards: Sequence[Card], blocks: Blocks) -> list[Card]:
    """The boxes of every column as wide as its widest."""
    even = list(cards)
    for members in blocks.members:
        width = max(cards[node].width for node in members)
        for node in members:
            even[node] = replace(cards[node], width=width)
    return even


def half_width(block: int, blocks: Blocks, cards: Sequence[Card]) -> float:
    """From the middle of a block to its side, the line that it may hang on included."""
    return cards[blocks.members[block][0]].width / 2 + (RAIL if blocks.hangs(block) else 0.0)


def height_of(block: int, blocks: Blocks, cards: Sequence[Card]) -> float:
    """From the upper edge of a block to its lower one."""
    nodes = blocks.members[block]
    return sum(cards[node].height for node in nodes) + STACK_GAP * (len(nodes) - 1)


def lay_out(shape: Shape, cards: Sequence[Card], blocks: Blocks) -> Layout:
    """
    Levels of the blocks, and places from left to right.

    A column keeps its room on as many levels below its own as it can reach into, if rows are as low as they ever are: so equal
    columns take equal room wherever they stand. Those rooms come after the blocks in the layout.
    """
    children = [list(below) for below in blocks.children]
    widths = [2 * half_width(block, blocks, cards) for block in range(len(children))]
    for block in range(len(blocks.members)):
        above = block
        for _ in range(reach_of(block, blocks, cards)):
            children[above].append(len(children))
            above = len(children)
            children.append([])
            widths.append(widths[block])
    framed = [blocks.of[node] for node in shape.frames]
    return tidy_layout(children, widths, SIBLING_GAP, framed, FRAME_PADDING, STRAIGHT)


def reach_of(block: int, blocks: Blocks, cards: Sequence[Card]) -> int:
    """How many levels below its own a column reaches at most."""
    if len(blocks.members[block]) < 2:
        return 0
    more = height_of(block, blocks, cards) - cards[blocks.members[block][0]].height
    return math.ceil(more / (LEAST_ROW + LEAST_GAP))


def set_rows(
    layout: Layout,
    cards: Sequence[Card],
    blocks: Blocks,
    gaps: Sequence[float],
    closed: Collection[int] = (),
    least_width: float = 0.0,
) -> Rows:
    """
    Give every level its row: single boxes on one line, columns hanging from the top.

    Parameters
    ----------
    layout
        Levels, and places from left to right.
    cards
        The boxes.
    blocks
        Which boxes stand in columns.
    gaps
        Room below each level.
    closed
        Levels below which something runs, so that no column may reach further down.
    least_width
        How wide the page is at least; the tree stands in its middle.
    """
    levels = layout.level[: len(blocks.members)]
    heads, ends = [LEAST_ROW] * len(gaps), [0.0] * len(gaps)
    for nodes, level in zip(blocks.members, levels, strict=True):
        heads[level] = max(heads[level], cards[nodes[0]].height)
    columns: list[list[int]] = [[] for _ in gaps]
    for block, level in enumerate(levels):
        columns[level].append(block)
    tops, bottoms, below = [], [], MARGIN
    for level, (head, gap) in enumerate(zip(heads, gaps, strict=True)):
        tops.append(below)
        for block in columns[level]:
            last = _last_level(level, reach_of(block, blocks, cards), len(gaps), closed)
            ends[last] = max(ends[last], below + height_of(block, blocks, cards))
        bottoms.append(max(below + head, ends[level]))
        below = bottoms[-1] + gap
    width = max(layout.width + 2 * MARGIN, least_width)
    left = (width - layout.width) / 2
    y = [0.0] * len(cards)
    for nodes, level in zip(blocks.members, levels, strict=True):
        top = tops[level] if len(nodes) > 1 else tops[level] + (heads[level] - cards[nodes[0]].height) / 2
        for node in nodes:
            y[node] = top + cards[node].height / 2
            top += cards[node].height + STACK_GAP
    halves = [half_width(block, blocks, cards) for block in range(len(blocks.members))]
    return Rows(
        x=tuple(left + layout.x[block] for block in blocks.of),
        y=tuple(y),
        level=tuple(levels[block] for block in blocks.of),
        tops=tuple(tops),
        bottoms=tuple(bottoms),
        spans={blocks.members[block][0]: (left + low, left + high) for block, (low, high) in layout.spans.items()},
        blocks=blocks,
        sides=tuple((left + x - half, left + x + half) for x, half in zip(layout.x, halves, strict=False)),
        width=width,
        height=below + MARGIN,
    )


def _last_level(level: int, reach: int, levels: int, closed: Collection[int]) -> int:
    """The level that a column may reach down to."""
    last = level
    while last - level < reach and last + 1 < levels and last not in closed:
        last += 1
    return last
