"""The tree as a picture, in the style of the paper's figures: a page of SVG without scripts, styles or fonts of its own."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from missiontree.mission.tree import LinkKind
from missiontree.reporting.escape import xml_safe
from missiontree.reporting.text_box import text_width
from missiontree.reporting.tree_cards import (
    FRAME_PADDING,
    LINE,
    MARGIN,
    NOTE_LINE,
    NOTE_SIZE,
    SIZE,
    Card,
    Rows,
    card_of,
    lay_out,
    set_rows,
)
from missiontree.reporting.tree_links import LANE, LANES_FROM, Arrow, Router, draw
from missiontree.reporting.tree_shape import Shape, ShapeKind

ROW_GAP = 58.0
MARK_WIDTH, MARK_HEIGHT = 36.0, 15.0
MARK_BELOW = 3.0
CORNER = 6.0
INK, RED, BLUE, VIOLET = "#333333", "#c0392b", "#1f5fbf", "#7d3c98"
FILLS: dict[ShapeKind, str] = {"task": "#ffffff", "routine": "#fdeeec", "action": "#fdeeec", "impossible": "#ffffff"}
LINK_LABELS: dict[LinkKind, str] = {
    "precedence": "",
    "same_robot": "same robot",
    "different_robot": "different robots",
    "until": "until",
}
LEGEND_ROW = 20.0


def svg_of(shape: Shape) -> str:
    """Draw a tree. Equal trees give equal bytes; linear in nodes, plus links times their depth."""
    cards = [card_of(node) for node in shape.nodes]
    layout = lay_out(shape, cards)
    router = Router(shape, layout)
    routes = router.routes()
    rows = set_rows(layout, cards, _gaps(max(layout.level) + 1, router))
    page = _Page(shape, cards, rows, draw(routes, rows, cards))
    return "\n".join(page.lines()) + "\n"


def _gaps(levels: int, router: Router) -> list[float]:
    """Room below each level: for marks, lanes and frames."""
    gaps = []
    for level in range(levels):
        lanes = router.lanes[level]
        room = LANES_FROM + LANE * lanes + 24.0 if lanes else 0.0
        gaps.append(max(room, ROW_GAP if level + 1 < levels else FRAME_PADDING))
    return gaps


@dataclass(frozen=True, slots=True)
class _Page:
    """Everything placed; writes itself from back to front."""

    shape: Shape
    cards: Sequence[Card]
    rows: Rows
    arrows: Sequence[Arrow]

    def lines(self) -> Iterator[str]:
        legend = list(self._legend())
        width = max([self.rows.width, *(2 * MARGIN + 46 + text_width(words, NOTE_SIZE) for _, words in legend)])
        height = self.rows.height + LEGEND_ROW * len(legend)
        yield (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{_n(width)}" height="{_n(height)}" '
            f'viewBox="0 0 {_n(width)} {_n(height)}" role="img" '
            f'font-family="Helvetica, Arial, &quot;DejaVu Sans&quot;, sans-serif" font-size="{_n(SIZE)}">'
        )
        yield f"<title>{xml_safe(self.shape.nodes[0].label)}</title>"
        yield from _HEADS
        yield f'<rect width="{_n(width)}" height="{_n(height)}" fill="#ffffff"/>'
        yield from self._group("frames", f'fill="none" stroke="{RED}" stroke-width="1.5"', self._frames())
        yield from self._group("edges", f'fill="none" stroke="{INK}" stroke-width="1.3"', self._edges())
        yield from self._group("links", 'fill="none" stroke-width="1.6"', self._links())
        yield from self._group("nodes", 'stroke-width="1.5" text-anchor="middle"', self._nodes())
        yield from self._group(
            "marks", f'stroke-width="1" text-anchor="middle" font-size="{_n(NOTE_SIZE)}"', self._marks()
        )
        yield from self._group("legend", f'font-size="{_n(NOTE_SIZE)}"', self._legend_lines(legend))
        yield "</svg>"

    def _group(self, name: str, style: str, content: Iterator[str]) -> Iterator[str]:
        lines = list(content)
        if lines:
            yield f'<g class="{name}" {style}>'
            yield from lines
            yield "</g>"

    def _frames(self) -> Iterator[str]:
        bottoms = [self.rows.y[node] + card.height / 2 for node, card in enumerate(self.cards)]
        for node in reversed(range(len(bottoms))):  # children stand after their parents
            bottoms[node] = max([bottoms[node], *(bottoms[child] for child in self.shape.children[node])])
        for node, (low, high) in self.rows.spans.items():
            top = self.rows.y[node] - self.cards[node].height / 2 - FRAME_PADDING
            yield (
                f'<rect x="{_n(low)}" y="{_n(top)}" width="{_n(high - low)}" '
                f'height="{_n(bottoms[node] + FRAME_PADDING - top)}" rx="6"/>'
            )

    def _edges(self) -> Iterator[str]:
        rows = self.rows
        for node, below in enumerate(self.shape.children):
            if not below:
                continue
            x, fork = rows.x[node], rows.bottoms[rows.level[node]] + MARK_BELOW + MARK_HEIGHT
            yield f'<path d="M{_n(x)} {_n(rows.y[node] + self.cards[node].height / 2)} L{_n(x)} {_n(fork)}"/>'
            dashes = ' stroke-dasharray="6 4"' if self.shape.nodes[node].gate == "xor" else ""
            for child in below:
                over = (rows.x[child], rows.tops[rows.level[child]] - FRAME_PADDING)
                end = (rows.x[child], rows.y[child] - self.cards[child].height / 2)
                points = " L".join(f"{_n(px)} {_n(py)}" for px, py in ((x, fork), over, end))
                yield f'<path d="M{points}"{dashes}/>'

    def _links(self) -> Iterator[str]:
        for arrow in self.arrows:
            label = LINK_LABELS[arrow.kind]
            colour, dashes = (VIOLET, ' stroke-dasharray="2 3"') if label else (BLUE, "")
            head = "" if arrow.kind in {"same_robot", "different_robot"} else f' marker-end="url(#{_HEAD_OF[colour]})"'
            yield f'<path d="{_rounded(arrow.points)}" stroke="{colour}"{dashes}{head}/>'
            if label:
                (x1, y), (x2, _) = arrow.points[arrow.label_at], arrow.points[arrow.label_at + 1]
                text = f'x="{_n((x1 + x2) / 2)}" y="{_n(y - 2)}" text-anchor="middle" font-size="9"'
                yield f'<text {text} stroke="#ffffff" stroke-width="3">{label}</text>'  # keeps lines off the letters
                yield f'<text {text} fill="{colour}" stroke="none">{label}</text>'

    def _nodes(self) -> Iterator[str]:
        for index, (node, card) in enumerate(zip(self.shape.nodes, self.cards, strict=True)):
            x, y = self.rows.x[index], self.rows.y[index]
            stroke = INK if node.kind == "task" else RED
            dashes = ' stroke-dasharray="5 4"' if node.kind == "impossible" or node.note == "no routine yet" else ""
            style = f'fill="{FILLS[node.kind]}" stroke="{stroke}"{dashes}'
            yield f"<g><title>{xml_safe(f'{node.label} {node.note}'.strip())}</title>"
            if card.round:
                yield f'<ellipse cx="{_n(x)}" cy="{_n(y)}" rx="{_n(card.width / 2)}" ry="{_n(card.height / 2)}" {style}/>'
            else:
                yield (
                    f'<rect x="{_n(x - card.width / 2)}" y="{_n(y - card.height / 2)}" width="{_n(card.width)}" '
                    f'height="{_n(card.height)}" rx="4" {style}/>'
                )
            yield from _words(card, x, y)
            yield "</g>"

    def _marks(self) -> Iterator[str]:
        for index, node in enumerate(self.shape.nodes):
            if node.gate is None or (node.gate == "and" and len(self.shape.children[index]) < 2):
                continue  # over one child, AND says nothing
            x, y = self.rows.x[index], self.rows.bottoms[self.rows.level[index]] + MARK_BELOW
            yield _mark(x, y, node.gate.upper())

    def _legend(self) -> Iterator[tuple[str, str]]:
        gates = {node.gate for node, below in zip(self.shape.nodes, self.shape.children, strict=True) if len(below) > 1}
        kinds = {arrow.kind for arrow in self.arrows}
        if "and" in gates:
            yield "and", "all of them are done"
        if "xor" in gates:
            yield "xor", "exactly one of them is done"
        if "precedence" in kinds:
            yield "precedence", "ends before the other starts"
        if kinds & {"same_robot", "different_robot", "until"}:
            yield "other", "other links, as written on them"

    def _legend_lines(self, entries: Sequence[tuple[str, str]]) -> Iterator[str]:
        y = self.rows.height
        for sign, words in entries:
            middle = y - MARGIN / 2 + LEGEND_ROW / 2
            if sign in {"and", "xor"}:
                yield f'<g text-anchor="middle">{_mark(MARGIN + MARK_WIDTH / 2, middle - MARK_HEIGHT / 2, sign.upper())}</g>'
            else:
                colour, dashes = (BLUE, "") if sign == "precedence" else (VIOLET, ' stroke-dasharray="2 3"')
                head = f' marker-end="url(#{_HEAD_OF[BLUE]})"' if sign == "precedence" else ""
                yield (
                    f'<path d="M{_n(MARGIN)} {_n(middle)} L{_n(MARGIN + MARK_WIDTH)} {_n(middle)}" '
                    f'stroke="{colour}" stroke-width="1.6"{dashes}{head}/>'
                )
            yield f'<text x="{_n(MARGIN + 46)}" y="{_n(middle + 4)}" fill="{INK}">{words}</text>'
            y += LEGEND_ROW


_HEAD_OF = {BLUE: "missiontree-head-blue", VIOLET: "missiontree-head-violet"}
_HEADS = (
    "<defs>",
    *(
        f'<marker id="{name}" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="9" markerHeight="9" '
        f'markerUnits="userSpaceOnUse" orient="auto"><path d="M0 0 L10 5 L0 10 z" fill="{colour}"/></marker>'
        for colour, name in _HEAD_OF.items()
    ),
    "</defs>",
)


def _words(card: Card, x: float, y: float) -> Iterator[str]:
    top = y - (len(card.lines) * LINE + len(card.note) * NOTE_LINE) / 2
    for line in card.lines:
        yield f'<text x="{_n(x)}" y="{_n(top + 0.77 * LINE)}" fill="{INK}" stroke="none">{xml_safe(line)}</text>'
        top += LINE
    for line in card.note:
        yield (
            f'<text x="{_n(x)}" y="{_n(top + 0.77 * NOTE_LINE)}" fill="#666666" stroke="none" '
            f'font-size="{_n(NOTE_SIZE)}">{xml_safe(line)}</text>'
        )
        top += NOTE_LINE


def _mark(x: float, y: float, word: str) -> str:
    return (
        f'<rect x="{_n(x - MARK_WIDTH / 2)}" y="{_n(y)}" width="{_n(MARK_WIDTH)}" height="{_n(MARK_HEIGHT)}" rx="7" '
        f'fill="#ffffff" stroke="{INK}"/>'
        f'<text x="{_n(x)}" y="{_n(y + 11.5)}" fill="{INK}" stroke="none">{word}</text>'
    )


def _rounded(points: Sequence[tuple[float, float]]) -> str:
    """A path through points, its corners rounded."""
    parts = [f"M{_n(points[0][0])} {_n(points[0][1])}"]
    for before, corner, after in zip(points, points[1:], points[2:], strict=False):
        near = _towards(corner, before)
        far = _towards(corner, after)
        parts.append(f"L{_n(near[0])} {_n(near[1])} Q{_n(corner[0])} {_n(corner[1])} {_n(far[0])} {_n(far[1])}")
    parts.append(f"L{_n(points[-1][0])} {_n(points[-1][1])}")
    return " ".join(parts)


def _towards(corner: tuple[float, float], other: tuple[float, float]) -> tuple[float, float]:
    length = ((other[0] - corner[0]) ** 2 + (other[1] - corner[1]) ** 2) ** 0.5
    share = 0.0 if length == 0 else min(CORNER, length / 2) / length
    return (corner[0] + share * (other[0] - corner[0]), corner[1] + share * (other[1] - corner[1]))


def _n(number: float) -> str:
    """A number with at most one decimal, the same on every machine."""
    text = f"{number:.1f}"
    return text.removesuffix(".0") if text != "-0.0" else "0"
