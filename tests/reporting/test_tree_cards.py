"""Boxes hold their words, and rows hold their boxes."""

import math
from itertools import pairwise

from hypothesis import given
from hypothesis import strategies as st

from missiontree.reporting.text_box import text_width
from missiontree.reporting.tree_cards import LINE, MARGIN, NOTE_LINE, NOTE_SIZE, SIZE, Card, card_of, lay_out, set_rows
from missiontree.reporting.tree_shape import Shape, ShapeKind, ShapeNode
from tests.reporting.shapes import shapes


@given(
    st.text(alphabet="abmW (_母", max_size=400),
    st.sampled_from(("", "no routine yet", "Search(cat), only drone or cart")),
    st.sampled_from(("task", "routine", "action", "impossible")),
)
def test_words_stay_within_their_box(label: str, note: str, kind: ShapeKind) -> None:
    card = card_of(ShapeNode("n", " ".join(label.split()), note, kind, None))
    top = -(len(card.lines) * LINE + len(card.note) * NOTE_LINE) / 2
    for line, size, height in [
        *((line, SIZE, LINE) for line in card.lines),
        *((line, NOTE_SIZE, NOTE_LINE) for line in card.note),
    ]:
        # letters reach from a fifth of the line's height to just above its end
        for y in (top + 0.2 * height, top + 0.95 * height):
            assert text_width(line, size) / 2 <= half_width(card, y)
        top += height


def half_width(card: Card, y: float) -> float:
    """Half of the width that a box has at a height above or below its middle."""
    if not card.round:
        return card.width / 2
    return card.width / 2 * math.sqrt(max(0.0, 1 - (2 * y / card.height) ** 2))


def test_an_ellipse_is_lower_at_its_sides() -> None:
    # a circle of radius 5: 3 aside, its edge is 4 away; a rectangle's edge is where it is
    assert Card((), (), 10, 10, round=True).reach(3) == 4
    assert Card((), (), 10, 10, round=False).reach(3) == 5


@given(shapes())
def test_rows_are_below_each_other_and_hold_their_boxes(shape: Shape) -> None:
    cards = [card_of(node) for node in shape.nodes]
    layout = lay_out(shape, cards)
    gaps = [7.0] * (max(layout.level) + 1)
    rows = set_rows(layout, cards, gaps)
    for node, card in enumerate(cards):
        level = rows.level[node]
        assert rows.tops[level] - 1e-9 <= rows.y[node] - card.height / 2
        assert rows.y[node] + card.height / 2 <= rows.bottoms[level] + 1e-9
        assert rows.x[node] - card.width / 2 >= MARGIN - 1e-9
        assert rows.x[node] + card.width / 2 <= rows.width - MARGIN + 1e-9
    assert all(abs(after - before - 7) < 1e-9 for before, after in zip(rows.bottoms, rows.tops[1:], strict=False))
    assert all(before < after for before, after in pairwise(rows.tops))
