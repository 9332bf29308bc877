"""Arrows find their way between the boxes."""

from itertools import pairwise

from hypothesis import given

from missiontree.reporting.tree_cards import Card, Rows, card_of, lay_out, set_rows
from missiontree.reporting.tree_links import LANE, LANES_FROM, Arrow, Point, Router, draw
from missiontree.reporting.tree_shape import Shape, ShapeNode
from tests.reporting.shapes import shapes


def drawn(shape: Shape) -> tuple[list[Arrow], Rows, list[Card]]:
    cards = [card_of(node) for node in shape.nodes]
    layout = lay_out(shape, cards)
    router = Router(shape, layout)
    routes = router.routes()
    gaps = [LANES_FROM + LANE * router.lanes[level] + 24 for level in range(max(layout.level) + 1)]
    rows = set_rows(layout, cards, gaps)
    return draw(routes, rows, cards), rows, cards


def meets(start: Point, end: Point, x: float, y: float, card: Card) -> bool:
    """Whether an upright or level stretch passes over the inside of a box."""
    return (
        min(start[0], end[0]) < x + card.width / 2 - 1e-6
        and max(start[0], end[0]) > x - card.width / 2 + 1e-6
        and min(start[1], end[1]) < y + card.height / 2 - 1e-6
        and max(start[1], end[1]) > y - card.height / 2 + 1e-6
    )


@given(shapes())
def test_arrows_pass_over_no_box(shape: Shape) -> None:
    arrows, rows, cards = drawn(shape)
    assert len(arrows) == len(shape.links)
    for arrow, (first, second, kind) in zip(arrows, shape.links, strict=True):
        assert arrow.kind == kind
        for start, end in pairwise(arrow.points):
            assert start[0] == end[0] or start[1] == end[1]
            for node, card in enumerate(cards):
                if node not in {first, second}:
                    assert not meets(start, end, rows.x[node], rows.y[node], card)


@given(shapes())
def test_arrows_start_and_end_at_the_edges_of_their_boxes(shape: Shape) -> None:
    arrows, rows, cards = drawn(shape)
    for arrow, (first, second, _) in zip(arrows, shape.links, strict=True):
        for (x, y), node in ((arrow.points[0], first), (arrow.points[-1], second)):
            aside = abs(x - rows.x[node])
            at_the_side = abs(aside - cards[node].width / 2) < 1e-6 and y == rows.y[node]
            assert at_the_side or abs(abs(y - rows.y[node]) - cards[node].reach(aside)) < 1e-6


def row(*links: tuple[int, int]) -> Shape:
    """Three leaves A, B, C below a root."""
    nodes = [ShapeNode("n0", "root", "", "task", "and")]
    nodes += [ShapeNode(f"n{i}", "ABC"[i - 1], "", "action", None) for i in (1, 2, 3)]
    return Shape(tuple(nodes), ((1, 2, 3), (), (), ()), tuple((*link, "precedence") for link in links))


def test_neighbours_are_joined_straight_and_only_once() -> None:
    arrows, rows, _ = drawn(row((1, 2), (3, 2), (2, 1)))
    assert arrows[0].points[0][0] < arrows[0].points[1][0]
    assert arrows[1].points[0][0] > arrows[1].points[1][0]
    assert {y for arrow in arrows[:2] for _, y in arrow.points} == {rows.y[1]}
    assert len(arrows[2].points) == 4  # down, along, up


def test_lanes_do_not_lie_on_each_other() -> None:
    arrows, _, _ = drawn(row((1, 3), (3, 1)))
    levels = [arrow.points[1][1] for arrow in arrows]
    assert abs(levels[0] - levels[1]) == LANE
    starts = {arrow.points[0] for arrow in arrows} | {arrow.points[-1] for arrow in arrows}
    assert len(starts) == 4
