"""What joins the rows of a Gantt chart: arrows from what is waited for to what waits, and bridges between joint work."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from missiontree.reporting.gantt.layout import Place
from missiontree.reporting.palette import BLUE, INK, PAPER, VIOLET
from missiontree.reporting.svg_numbers import n

BACK = 7.0
"""How far before its goal an arrow turns towards it: the length of its head, and a little."""
ASIDE = 3.5
"""How much farther from it an arrow turns that goes up, so that it does not run along one that goes down."""
_HEAD = 6.0
_CORNER = 3.0
_NEAR = 4.0
WASH = 0.14
"""How much of its colour the tint between joint work has."""


class Box(NamedTuple):
    """A bar as drawn: left and right, and the row it is in."""

    left: float
    right: float
    place: Place


Point = tuple[float, float]


class Arrow(NamedTuple):
    """An arrow as written: the line, which passes behind bars, and the head, which stands in front of them."""

    line: str
    head: str


def arrow(first: Box, second: Box, *, lit: bool, to_end: bool) -> Arrow:
    """
    An arrow from the end of one bar to the start of another in another row, or down to its end.

    It leaves through the side of the bar, runs along the edge of the row if there is far to go, and comes in from the left.
    """
    down = second.place.top > first.place.top
    edge = first.place.bar_bottom if down else first.place.bar_top
    hall = first.place.bottom if down else first.place.top  # between two rows nothing is written
    back = BACK if down else BACK + ASIDE
    leave = max(first.left + 1.0, first.right - back)
    if to_end:
        goal = (max(second.left + 1.0, second.right - back), second.place.bar_top if down else second.place.bar_bottom)
        turn = goal[0]
    else:
        goal = (second.left, second.place.middle)
        turn = goal[0] - back
    points = [(leave, edge)]
    if abs(leave - turn) <= _NEAR:
        turn = leave
    else:
        points += [(leave, hall), (turn, hall)]
    points += [goal] if to_end else [(turn, goal[1]), goal]
    colour, width, kind = (INK, 2.4, "mt-critical mt-line") if lit else (BLUE, 1.4, "mt-link mt-line")
    head_kind = "mt-critical mt-fill" if lit else "mt-link mt-fill"
    return Arrow(
        f'<path class="{kind}" d="{_path(_short_of_goal(points))}" fill="none" stroke="{colour}" stroke-width="{n(width)}"/>',
        f'<path class="{head_kind}" d="{_head(points, _HEAD + (1.0 if lit else 0.0))}" fill="{colour}" stroke="{PAPER}" '
        'stroke-width="1.6" stroke-linejoin="round" paint-order="stroke"/>',
    )


def bridge(boxes: Sequence[Box]) -> Iterator[str]:
    """What joins bars of joint work: lines at their start and their end, from each row to the next that takes part."""
    for upper, lower in _neighbours(boxes):
        top, height = upper.place.bar_bottom, lower.place.bar_top - upper.place.bar_bottom
        yield (
            f'<path class="mt-joint mt-line" d="M{n(upper.left + 1)} {n(top)} v{n(height)} M{n(upper.right - 1)} {n(top)} '
            f'v{n(height)}" fill="none" stroke="{VIOLET}" stroke-width="2" stroke-dasharray="5 2"/>'
        )


def wash(boxes: Sequence[Box]) -> Iterator[str]:
    """
    The tint between bars of joint work that are in neighbouring rows; over rows that have no part in it, there is none.

    It lies over the words of the rows: so it colours their halos as it does the ground.
    """
    for upper, lower in _neighbours(boxes):
        if upper.place.bottom == lower.place.top:
            top, height = upper.place.bar_bottom, lower.place.bar_top - upper.place.bar_bottom
            yield (
                f'<rect class="mt-joint mt-fill" x="{n(upper.left)}" y="{n(top)}" width="{n(upper.right - upper.left)}" '
                f'height="{n(height)}" fill="{VIOLET}" fill-opacity="{WASH}" pointer-events="none"/>'
            )


def _neighbours(boxes: Sequence[Box]) -> Iterator[tuple[Box, Box]]:
    return pairwise(sorted(boxes, key=lambda box: box.place.top))


def _path(points: Sequence[Point]) -> str:
    """A line through points with small round corners."""
    parts = [f"M{n(points[0][0])} {n(points[0][1])}"]
    for before, corner, after in zip(points, points[1:], points[2:], strict=False):
        near, far = _towards(corner, before), _towards(corner, after)
        parts.append(f"L{n(near[0])} {n(near[1])} Q{n(corner[0])} {n(corner[1])} {n(far[0])} {n(far[1])}")
    return " ".join([*parts, f"L{n(points[-1][0])} {n(points[-1][1])}"])


def _towards(corner: Point, other: Point) -> Point:
    wide, high = other[0] - corner[0], other[1] - corner[1]
    length = abs(wide) + abs(high)  # lines are upright or level
    share = min(_CORNER, length / 2) / length if length else 0.0
    return corner[0] + share * wide, corner[1] + share * high


def _short_of_goal(points: Sequence[Point]) -> list[Point]:
    """The line without its last few pixels, which lie under the head."""
    (_, y1), (x2, y2) = points[-2:]
    back = _HEAD - 1.0
    end = (x2 - back, y2) if y1 == y2 else (x2, y2 - back if y2 > y1 else y2 + back)
    return [*points[:-1], end]


def _head(points: Sequence[Point], size: float) -> str:
    (_, y1), (x, y) = points[-2:]
    half = size / 2
    if y1 == y:
        return f"M{n(x)} {n(y)} L{n(x - size)} {n(y - half)} V{n(y + half)} Z"
    back = y - size if y > y1 else y + size
    return f"M{n(x)} {n(y)} L{n(x - half)} {n(back)} H{n(x + half)} Z"
