"""Strokes of a drawn tree: how lit and quiet things look, lines with rounded corners, and what stands at the ends of links."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from missiontree.mission.tree import LinkKind
from missiontree.reporting.palette import BLUE, INK, MUTED, PAPER, QUIET, RED, VIOLET
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.tree.links import Point
from missiontree.reporting.tree.shape import State

CORNER = 6.0
HEAD, HALF_HEAD, STOP, DOT = 9.0, 4.5, 3.0, 3.6
GLOW = "#ffe7a3"
"""A marker's stroke under the way that is chosen."""
SOFT_RED = "#fdeeec"
EDGE_WIDTH: dict[State, float] = {"plain": 1.3, "lit": 2.4, "quiet": 0.9}
NODE_WIDTH: dict[State, float] = {"plain": 1.5, "lit": 2.6, "quiet": 0.9}
LINK_WIDTH: dict[State, float] = {"plain": 1.6, "lit": 2.0, "quiet": 1.0}
XOR_DASHES = "6 4"


@dataclass(frozen=True, slots=True)
class LinkStyle:
    """
    How a kind of link is told from the others, without its colour too.

    Parameters
    ----------
    name
        Name of its class.
    colour
        Colour of line, marks and word.
    dashes
        Pattern of the line; empty if it is unbroken.
    start, end
        What stands at its ends: ``head``, ``stop`` (a hollow head against a bar), ``dot``, ``ring``, or nothing.
    meaning
        What it says, in words.
    """

    name: str
    colour: str
    dashes: str
    start: str
    end: str
    meaning: str


LINK_STYLES: dict[LinkKind, LinkStyle] = {
    "precedence": LinkStyle("precedence", BLUE, "", "", "head", "ends before the other starts"),
    "until": LinkStyle("until", VIOLET, "9 4", "", "stop", "goes on until the other ends"),
    "hand_over": LinkStyle("hand-over", BLUE, "6 3", "ring", "head", "hands over: ends when the other starts"),
    "same_robot": LinkStyle("same-robot", VIOLET, "1.6 3.4", "dot", "dot", "done by one and the same robot"),
    "different_robot": LinkStyle("different-robot", VIOLET, "8 3 2 3", "ring", "ring", "done by different robots"),
}


def words_colour(state: State) -> str:
    """Colour of words."""
    return MUTED if state == "quiet" else INK


def line_colour(state: State, usual: str = INK) -> str:
    """Colour of lines."""
    return QUIET if state == "quiet" else usual


def box_colours(kind: str, state: State) -> tuple[str, str]:
    """Fill and stroke of a box."""
    if kind in {"task", "more"}:
        return PAPER, line_colour(state)
    return (PAPER if state == "quiet" or kind == "impossible" else SOFT_RED), line_colour(state, RED)


def link_line(kind: LinkKind, points: Sequence[Point], state: State) -> Iterator[str]:
    """A link: its line, then what stands at its ends."""
    style = LINK_STYLES[kind]
    colour = line_colour(state, style.colour)
    inner = [*points]
    if style.end in {"head", "stop"}:
        inner[-1] = towards(points[-1], points[-2], HEAD - 1 + (STOP if style.end == "stop" else 0))
    dashes = f' stroke-dasharray="{style.dashes}"' if style.dashes else ""
    yield (
        f'<path class="mt-line" d="{rounded(inner)}" fill="none" stroke="{colour}" '
        f'stroke-width="{n(LINK_WIDTH[state])}"{dashes}/>'
    )
    for sign, tip, before in ((style.start, points[0], points[1]), (style.end, points[-1], points[-2])):
        if sign:
            yield _end(sign, tip, before, colour)


def _end(sign: str, tip: Point, before: Point, colour: str) -> str:
    if sign in {"dot", "ring"}:
        fill = colour if sign == "dot" else PAPER
        return (
            f'<circle class="mt-{sign}" cx="{n(tip[0])}" cy="{n(tip[1])}" r="{DOT}" fill="{fill}" '
            f'stroke="{colour}" stroke-width="1.4"/>'
        )
    if sign == "stop":
        tip = towards(tip, before, STOP)
    back = towards(tip, before, HEAD)
    length = math.dist(tip, back) or 1.0
    aside = (HALF_HEAD * (back[1] - tip[1]) / length, -HALF_HEAD * (back[0] - tip[0]) / length)
    left, right = (back[0] + aside[0], back[1] + aside[1]), (back[0] - aside[0], back[1] - aside[1])
    head = f"M{_at(left)} L{_at(tip)} L{_at(right)} Z"
    if sign == "head":
        return f'<path class="mt-head" d="{head}" fill="{colour}"/>'
    bar = f"M{_at((tip[0] + aside[0], tip[1] + aside[1]))} L{_at((tip[0] - aside[0], tip[1] - aside[1]))}"
    return f'<path class="mt-stop" d="{head} {bar}" fill="{PAPER}" stroke="{colour}" stroke-width="1.6"/>'


def rounded(points: Sequence[Point]) -> str:
    """A path through points, its corners rounded."""
    parts = [f"M{_at(points[0])}"]
    for before, corner, after in zip(points, points[1:], points[2:], strict=False):
        near = towards(corner, before, min(CORNER, math.dist(corner, before) / 2))
        far = towards(corner, after, min(CORNER, math.dist(corner, after) / 2))
        parts.append(f"L{_at(near)} Q{_at(corner)} {_at(far)}")
    parts.append(f"L{_at(points[-1])}")
    return " ".join(parts)


def towards(start: Point, goal: Point, way: float) -> Point:
    """The point so far from the start, on the way to the goal."""
    length = math.dist(start, goal)
    share = way / length if length else 0.0
    return (start[0] + share * (goal[0] - start[0]), start[1] + share * (goal[1] - start[1]))


def _at(point: Point) -> str:
    return f"{n(point[0])} {n(point[1])}"
