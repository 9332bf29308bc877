"""The arrows of a drawn tree as lines on the page."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from missiontree.mission.tree import LinkKind
from missiontree.reporting.text_box import text_width
from missiontree.reporting.tree.cards import Card
from missiontree.reporting.tree.routes import LINK_SIZE, LINK_WORDS, Anchor, Route
from missiontree.reporting.tree.rows import Rows

_CLEAR, _HALF_LINE = 5.0, 6.0
"""How far words on links stay from what crosses theirs: at their sides, above and below."""
LANE = 15.0
LANES_FROM = 46.0
"""Where the first lane runs below a row: the marks of the gates are above it."""
LANES_FROM_LEAVES = 22.0
"""The same below a row of leaves."""

Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Arrow:
    """
    A link as a line.

    Parameters
    ----------
    kind
        Kind of the link.
    points
        Corners of the line, from the first node to the second.
    label_at
        Middle of the stretch that a word stands on.
    upright
        That stretch goes up or down.
    """

    kind: LinkKind
    points: tuple[Point, ...]
    label_at: Point
    upright: bool


def draw(
    routes: Sequence[Route], rows: Rows, cards: Sequence[Card], left: float, forked: Collection[int]
) -> list[Arrow]:
    """
    Lines on the page for routes.

    Parameters
    ----------
    routes
        The ways.
    rows, cards
        Where everything stands.
    left
        How far the page is to the right of the layout.
    forked
        Levels on which some node has children.
    """
    return _cleared([_arrow(route, rows, cards, left, forked) for route in routes])


def lanes_from(has_children: bool) -> float:
    """Where the first lane runs below a row."""
    return LANES_FROM if has_children else LANES_FROM_LEAVES


def _arrow(route: Route, rows: Rows, cards: Sequence[Card], left: float, forked: Collection[int]) -> Arrow:
    points = list(_ends(route.start, rows, cards, left))
    for run in route.runs:
        y = rows.bottoms[run.gap] + lanes_from(run.gap in forked) + LANE * run.lane
        points += [(left + run.start, y), (left + run.end, y)]
    points += reversed(list(_ends(route.end, rows, cards, left)))
    corners = _without_repeats(points)
    upright = not route.runs and len(corners) != 2
    stretches = [(a, b) for a, b in pairwise(corners) if (a[0] == b[0]) == upright] or list(pairwise(corners))
    (x1, y1), (x2, y2) = max(stretches, key=lambda ends: abs(ends[0][0] - ends[1][0]) + abs(ends[0][1] - ends[1][1]))
    return Arrow(route.kind, corners, ((x1 + x2) / 2, (y1 + y2) / 2), upright)


def _cleared(arrows: Sequence[Arrow]) -> list[Arrow]:
    """Words moved along their stretches to where no other link crosses them, if there is such a place."""
    upright = [
        (x1, min(y1, y2), max(y1, y2))
        for one in arrows
        for (x1, y1), (x2, y2) in pairwise(one.points)
        if x1 == x2 and y1 != y2
    ]
    return [_clear(one, upright) for one in arrows]


def _clear(arrow: Arrow, upright: Sequence[tuple[float, float, float]]) -> Arrow:
    half, (middle, y) = text_width(LINK_WORDS[arrow.kind], LINK_SIZE) / 2 + _CLEAR, arrow.label_at
    level = [sorted((x1, x2)) for (x1, y1), (x2, y2) in pairwise(arrow.points) if y1 == y2 == y]
    if arrow.upright or half <= _CLEAR or not level:
        return arrow
    low, high = min(level, key=lambda ends: abs(sum(ends) / 2 - middle))
    crossed = sorted(x for x, top, bottom in upright if top - _HALF_LINE < y < bottom + _HALF_LINE and low < x < high)
    rooms = [(a + half, b - half) for a, b in pairwise((low, *crossed, high)) if b - a >= 2 * half]
    places = [min(max(middle, first), last) for first, last in rooms]
    return replace(arrow, label_at=(min(places, key=lambda x: abs(x - middle), default=middle), y))


def _ends(anchor: Anchor, rows: Rows, cards: Sequence[Card], left: float) -> Iterator[Point]:
    """From the edge of a box to where the line goes on up or down."""
    x, y, card = rows.x[anchor.node], rows.y[anchor.node], cards[anchor.node]
    if anchor.upright:
        yield left + anchor.x, y + anchor.side * card.reach(left + anchor.x - x)
        return
    yield x + anchor.side * card.breadth(anchor.shift), y + anchor.shift
    yield left + anchor.x, y + anchor.shift


def _without_repeats(points: Sequence[Point]) -> tuple[Point, ...]:
    kept = [points[0]]
    for point in points[1:]:
        if abs(point[0] - kept[-1][0]) + abs(point[1] - kept[-1][1]) > 1e-6:
            kept.append(point)
    return tuple(kept) if len(kept) > 1 else (points[0], points[-1])
