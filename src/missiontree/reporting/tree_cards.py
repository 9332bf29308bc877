"""The boxes of a drawn tree: how large each is, and where it stands on its row."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from missiontree.reporting.text_box import text_width, wrapped
from missiontree.reporting.tree_layout import Layout, tidy_layout
from missiontree.reporting.tree_shape import Shape, ShapeNode

SIZE, NOTE_SIZE = 13.0, 11.0
LINE, NOTE_LINE = 16.0, 14.0
MOST_LINES = 8
SIBLING_GAP, FRAME_PADDING = 30.0, 10.0
MARGIN = 24.0
_TEXT_WIDTH = {"task": 150.0, "routine": 150.0, "action": 104.0, "impossible": 120.0}
_LEAST_WIDTH = 84.0
_LONG_LINES = 4
_ROUND = (
    1.22  # an ellipse around a text, in shares of the text's own sides; less than the root of 2, as lines are centred
)


@dataclass(frozen=True, slots=True)
class Card:
    """
    A box and its words.

    Parameters
    ----------
    lines, note
        Words of the label and of the note, line by line.
    width, height
        Outer size.
    round
        An ellipse, else a rectangle.
    """

    lines: tuple[str, ...]
    note: tuple[str, ...]
    width: float
    height: float
    round: bool

    def reach(self, aside: float) -> float:
        """Distance from the middle to the upper or lower edge, at a distance aside of the middle."""
        if not self.round:
            return self.height / 2
        return self.height / 2 * math.sqrt(max(0.0, 1 - (2 * aside / self.width) ** 2))


def card_of(node: ShapeNode) -> Card:
    """The box that a node needs."""
    room = _TEXT_WIDTH[node.kind]
    if text_width(node.label, SIZE) > _LONG_LINES * room:
        room *= 1.6
    lines = wrapped(node.label, SIZE, room, MOST_LINES)
    note = wrapped(node.note, NOTE_SIZE, room, MOST_LINES) if node.note else []
    width = max([text_width(line, SIZE) for line in lines] + [text_width(line, NOTE_SIZE) for line in note])
    height = len(lines) * LINE + len(note) * NOTE_LINE
    is_round = node.kind == "task"
    if is_round:
        width, height = width * _ROUND + 16, height * 1.5 + 10
    else:
        width, height = width + 18, height + 14
    return Card(tuple(lines), tuple(note), max(width, _LEAST_WIDTH), height, is_round)


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
        Upper and lower edge of every row.
    spans
        Left and right edge of every frame.
    width, height
        Size of the page.
    """

    x: tuple[float, ...]
    y: tuple[float, ...]
    level: tuple[int, ...]
    tops: tuple[float, ...]
    bottoms: tuple[float, ...]
    spans: dict[int, tuple[float, float]]
    width: float
    height: float


def lay_out(shape: Shape, cards: Sequence[Card]) -> Layout:
    """Levels, and places from left to right."""
    return tidy_layout(shape.children, [card.width for card in cards], SIBLING_GAP, shape.frames, FRAME_PADDING)


def set_rows(layout: Layout, cards: Sequence[Card], gaps: Sequence[float]) -> Rows:
    """
    Give every level its row, boxes on the middle line of theirs.

    Parameters
    ----------
    layout
        Levels, and places from left to right.
    cards
        The boxes.
    gaps
        Room below each level.
    """
    heights = [0.0] * len(gaps)
    for card, level in zip(cards, layout.level, strict=True):
        heights[level] = max(heights[level], card.height)
    tops, bottoms, y = [], [], MARGIN
    for height, gap in zip(heights, gaps, strict=True):
        tops.append(y)
        bottoms.append(y + height)
        y += height + gap
    return Rows(
        x=tuple(MARGIN + x for x in layout.x),
        y=tuple((tops[level] + bottoms[level]) / 2 for level in layout.level),
        level=layout.level,
        tops=tuple(tops),
        bottoms=tuple(bottoms),
        spans={node: (MARGIN + low, MARGIN + high) for node, (low, high) in layout.spans.items()},
        width=layout.width + 2 * MARGIN,
        height=y + MARGIN,
    )
