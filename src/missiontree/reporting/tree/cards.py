"""The boxes of a drawn tree: the words in each, and how large it is."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass

from missiontree.reporting.palette import Livery
from missiontree.reporting.text_box import balanced, text_width, wrapped
from missiontree.reporting.tree.shape import ShapeKind, ShapeNode

SIZE, NOTE_SIZE = 13.0, 11.0
LINE, NOTE_LINE, TAG_LINE = 16.0, 14.0, 21.0
TAG_HEIGHT, SWATCH = 17.0, 10.0
TAG_SIDES = SWATCH + 17.0
MOST_LINES, MOST_TAGS, TAG_ROOM = 8, 4, 170.0
LEAST_WIDTH = 84.0
_TEXT_WIDTH: dict[ShapeKind, float] = {
    "task": 150.0,
    "routine": 150.0,
    "action": 150.0,
    "impossible": 120.0,
    "more": 110.0,
}
_LONG_LINES = 4
_ROUND = (1.18, 1.4)
"""Sides of an ellipse to begin with, in shares of those of its words."""
_INSIDE = 0.94
_ROUND_ROOMS = (0.7, 0.85, 1.0, 1.2, 1.45, 1.75)
"""Room for the words of an ellipse that is tried out, in shares of the usual."""
_BEST_SHAPE = 2.4
_SHORT = 1.3
"""Labels up to so many times as wide as a line stay on one line: no bracket stands alone below."""
_EVEN_ROOMS = (0.55, 0.65, 0.75, 0.85, 0.95)
_UNBROKEN = re.compile(r"[^\s(,\-_/]+[(,\-_/]*")


@dataclass(frozen=True, slots=True)
class Tag:
    """
    A robot's badge.

    Parameters
    ----------
    text
        The name, as far as there is room for it.
    livery
        How the robot's surfaces look; None for a badge that counts those left out.
    width
        Outer width.
    """

    text: str
    livery: Livery | None
    width: float


@dataclass(frozen=True, slots=True)
class Card:
    """
    A box and its words.

    Parameters
    ----------
    lines, note, tags
        Words of the label and of the note, line by line, and badges; each stands below the one before.
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
    tags: tuple[Tag, ...] = ()

    def reach(self, aside: float) -> float:
        """Distance from the middle to the upper or lower edge, at a distance aside of the middle."""
        if not self.round:
            return self.height / 2
        return self.height / 2 * math.sqrt(max(0.0, 1 - (2 * aside / self.width) ** 2))

    def breadth(self, below: float) -> float:
        """Distance from the middle to the left or right edge, at a distance below the middle."""
        if not self.round:
            return self.width / 2
        return self.width / 2 * math.sqrt(max(0.0, 1 - (2 * below / self.height) ** 2))

    @property
    def text_height(self) -> float:
        """Height of everything written."""
        return len(self.lines) * LINE + len(self.note) * NOTE_LINE + len(self.tags) * TAG_LINE


def card_of(node: ShapeNode) -> Card:
    """The box that a node needs."""
    room, whole = _TEXT_WIDTH[node.kind], text_width(node.label, SIZE)
    widest = max((text_width(part, SIZE) for part in _UNBROKEN.findall(node.label)), default=0.0)
    if node.kind == "task":
        rooms = [room * share for share in _ROUND_ROOMS if room * share >= widest] or [room]
        return min((_card(node, tried) for tried in rooms), key=_ungainly)
    if whole <= _SHORT * room:
        return _card(node, max(whole + 1, room))
    if whole > _LONG_LINES * room:
        room *= 1.6
    count = len(wrapped(node.label, SIZE, room, MOST_LINES))
    even = [room * share for share in _EVEN_ROOMS if room * share >= widest]  # no wider than as many lines need
    return _card(node, next((less for less in even if len(wrapped(node.label, SIZE, less, MOST_LINES)) == count), room))


def _ungainly(card: Card) -> float:
    """How large a round card is, and how far from the shape that the eye likes."""
    shape = card.width / card.height / _BEST_SHAPE
    return card.width * card.height * math.sqrt(max(shape, 1 / shape))


def _card(node: ShapeNode, room: float) -> Card:
    lines = tuple(balanced(node.label, SIZE, room, MOST_LINES))
    note = tuple(balanced(words, NOTE_SIZE, room, MOST_LINES)) if (words := note_of(node)) else ()
    bare = Card(lines, note, 0.0, 0.0, node.kind == "task", tuple(_tags(node)))
    parts = list(_extents(bare))
    width, height = max(half for half, _, _ in parts) * 2, bare.text_height
    if not bare.round:
        return _sized(bare, max(width + 18, LEAST_WIDTH), height + 14)
    wide, high = width * _ROUND[0] + 14, height * _ROUND[1] + 12
    most = max(math.hypot(2 * half / wide, 2 * y / high) for half, top, bottom in parts for y in (top, bottom))
    grown = max(1.0, most / _INSIDE)
    return _sized(bare, max(wide * grown, LEAST_WIDTH), high * grown)


def _sized(card: Card, width: float, height: float) -> Card:
    return Card(card.lines, card.note, width, height, card.round, card.tags)


def note_of(node: ShapeNode) -> str:
    """What stands below the label: the note, and how much is folded."""
    folded = ""
    if node.hidden and node.kind == "more":
        folded = f"{node.hidden:,} nodes"
    elif node.hidden:
        folded = f"… {node.hidden:,} node{'s' if node.hidden > 1 else ''}"
    return ", ".join(part for part in (node.note, folded) if part)


def _tags(node: ShapeNode) -> Iterator[Tag]:
    shown = node.team if len(node.team) <= MOST_TAGS else node.team[: MOST_TAGS - 1]
    for badge in shown:
        text = wrapped(badge.text, NOTE_SIZE, TAG_ROOM, 1)[0]
        yield Tag(text, badge.livery, text_width(text, NOTE_SIZE) + TAG_SIDES)
    if len(shown) < len(node.team):
        text = f"and {len(node.team) - len(shown)} more"
        yield Tag(text, None, text_width(text, NOTE_SIZE) + TAG_SIDES)


def _extents(card: Card) -> Iterator[tuple[float, float, float]]:
    """Half of the width, upper edge and lower edge of everything written, from the middle."""
    top = -card.text_height / 2
    for line in card.lines:
        yield text_width(line, SIZE) / 2, top + 0.15 * LINE, top + LINE
        top += LINE
    for line in card.note:
        yield text_width(line, NOTE_SIZE) / 2, top + 0.15 * NOTE_LINE, top + NOTE_LINE
        top += NOTE_LINE
    for tag in card.tags:
        yield tag.width / 2, top + TAG_LINE - TAG_HEIGHT, top + TAG_LINE
        top += TAG_LINE
