"""The boxes of a drawn tree, written as SVG: outline, words, badges."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.reporting.escape import xml_safe
from missiontree.reporting.palette import MUTED, PAPER
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.tree.cards import (
    LINE,
    NOTE_LINE,
    NOTE_SIZE,
    SWATCH,
    TAG_HEIGHT,
    TAG_LINE,
    Card,
    Tag,
)
from missiontree.reporting.tree.ink import NODE_WIDTH, box_colours, line_colour, words_colour
from missiontree.reporting.tree.shape import ShapeNode, State
from missiontree.reporting.tree.words import title_of

PILE = 3.0
"""A folded subtree looks like a pile of cards, each so far below and to the right of the one above it."""
OPEN_NOTES = frozenset({"no routine yet", "nobody can do it"})


def box(node: ShapeNode, card: Card, x: float, y: float, prefix: str) -> Iterator[str]:
    """A node at its place. Patterns of badges have ids that start with the prefix."""
    fill, stroke = box_colours(node.kind, node.state)
    dashes = ' stroke-dasharray="5 4"' if node.note in OPEN_NOTES else ""
    style = f'fill="{fill}" stroke="{stroke}" stroke-width="{n(NODE_WIDTH[node.state])}"'
    yield f'<g class="mt-{node.kind} mt-{node.state}"><title>{xml_safe(title_of(node))}</title>'
    if node.hidden:
        for place in (2, 1):
            yield _outline(card, x + place * PILE, y + place * PILE, f'class="mt-pile" {style}')
    yield _outline(card, x, y, f'class="mt-box" {style}{dashes}')
    yield from _words(node, card, x, y, prefix)
    yield "</g>"


def _outline(card: Card, x: float, y: float, style: str) -> str:
    if card.round:
        return f'<ellipse cx="{n(x)}" cy="{n(y)}" rx="{n(card.width / 2)}" ry="{n(card.height / 2)}" {style}/>'
    return (
        f'<rect x="{n(x - card.width / 2)}" y="{n(y - card.height / 2)}" width="{n(card.width)}" '
        f'height="{n(card.height)}" rx="4" {style}/>'
    )


def _words(node: ShapeNode, card: Card, x: float, y: float, prefix: str) -> Iterator[str]:
    top = y - card.text_height / 2
    for line in card.lines:
        yield f'<text x="{n(x)}" y="{n(top + 0.77 * LINE)}" fill="{words_colour(node.state)}">{xml_safe(line)}</text>'
        top += LINE
    for line in card.note:
        yield (
            f'<text class="mt-note" x="{n(x)}" y="{n(top + 0.77 * NOTE_LINE)}" fill="{MUTED}" '
            f'font-size="{n(NOTE_SIZE)}">{xml_safe(line)}</text>'
        )
        top += NOTE_LINE
    for tag in card.tags:
        yield from tag_lines(tag, x, top + TAG_LINE - TAG_HEIGHT / 2, node.state, prefix)
        top += TAG_LINE


def tag_lines(tag: Tag, x: float, y: float, state: State, prefix: str) -> Iterator[str]:
    """A badge with its middle at (x, y): a swatch in the robot's colour, and its name."""
    left, middle, kind = x - tag.width / 2, x, "mt-tag"
    fill, stroke = PAPER, line_colour("quiet")
    if tag.livery is not None:
        middle += SWATCH / 2 + 1
        if state != "quiet":
            kind += f" mt-hue-{tag.livery.number}"
            fill, stroke = tag.livery.hue.tint, tag.livery.hue.deep
    yield (
        f'<rect class="{kind}" x="{n(left)}" y="{n(y - TAG_HEIGHT / 2)}" width="{n(tag.width)}" '
        f'height="{n(TAG_HEIGHT)}" rx="{n(TAG_HEIGHT / 2)}" fill="{fill}" stroke="{stroke}" stroke-width="1"/>'
    )
    if tag.livery is not None:
        yield (
            f'<circle class="mt-swatch mt-hue-{tag.livery.number}" cx="{n(left + 10)}" cy="{n(y)}" r="{n(SWATCH / 2)}" '
            f'fill="{tag.livery.paint(prefix)}" stroke="{tag.livery.hue.deep}" stroke-width="0.8"/>'
        )
    yield (
        f'<text class="mt-name" x="{n(middle)}" y="{n(y + 4)}" font-size="{n(NOTE_SIZE)}" '
        f'fill="{words_colour(state)}">{xml_safe(tag.text)}</text>'
    )
