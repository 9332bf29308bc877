"""Routes as lines with arrows, side by side where they share a way."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

from missiontree.reporting.escape import xml_safe
from missiontree.reporting.maps.lanes import Line, Point, side_by_side
from missiontree.reporting.maps.layout import MapLayout
from missiontree.reporting.maps.routes import Passage, Route
from missiontree.reporting.palette import HATCHES, PAPER
from missiontree.reporting.svg_numbers import n

WIDTH = 2.8
_DASHES = dict(zip(HATCHES, ("", "9 4", "3 3", "14 4 3 4", "1 5"), strict=True))
"""A dash for every pattern that liveries have, so that robots of one hue are told apart on the map, too."""
_EVERY = 130.0
_SHORTEST = 34.0
_PAST = 8.0
_STAGGER, _STAGGERED = 9.0, 5
"""Heads of routes side by side stand one past the other."""
_HEAD = 5.5


class DrawnRoutes:
    """
    The lines of all routes of a picture.

    Parameters
    ----------
    routes
        Routes in order.
    layout
        Where what is.
    """

    def __init__(self, routes: Sequence[Route], layout: MapLayout) -> None:
        self._routes = routes
        self._parts: list[tuple[int, Passage, str]] = []
        lines = []
        for owner, route in enumerate(routes):
            for passage in route.passages:
                for floor, points in _by_floor(passage, layout):
                    self._parts.append((owner, passage, floor))
                    lines.append(Line(owner, tuple(points)))
        self._lines: list[list[Point]] = [[] for _ in lines]
        for panel in layout.panels:  # lanes are a matter of one panel
            here = [index for index, (_, _, floor) in enumerate(self._parts) if floor == panel.floor]
            for index, moved in zip(here, side_by_side([lines[index] for index in here]), strict=True):
                self._lines[index] = moved

    def on(self, floor: str) -> Iterator[list[Point]]:
        """Lines of one floor, for labels to keep off."""
        for (_, _, other), line in zip(self._parts, self._lines, strict=True):
            if other == floor:
                yield line

    def draw(self, floor: str) -> Iterator[str]:
        """All routes of one floor, each in a group of its own."""
        arrows: set[tuple[int, int, int, int]] = set()
        for owner, route in enumerate(self._routes):
            parts = [index for index, (other, _, on) in enumerate(self._parts) if other == owner and on == floor]
            if not parts:
                continue
            yield f'<g class="mt-map-route mt-hue-{route.livery.number}" data-letter="{route.letter}">'
            for index in parts:
                yield from route_line(self._lines[index], route, _title(route, self._parts[index][1]))
            heads = "".join(head for index in parts for head in _arrows(owner, self._lines[index], arrows))
            if heads:
                colours = f'fill="{route.livery.hue.fill}" stroke="{PAPER}"'
                yield f'<path class="mt-fill" d="{heads}" {colours} stroke-width="0.9"/>'
            yield "</g>"


def route_line(points: Sequence[Point], route: Route, title: str) -> Iterator[str]:
    """One line in the colour of its robot."""
    path = f"M{' L'.join(f'{n(x)} {n(y)}' for x, y in points)}"
    dashes = _DASHES[route.livery.hatch]
    style = f' stroke-dasharray="{dashes}"' if dashes else ""
    yield (
        f'<path class="mt-line" d="{path}" fill="none" stroke="{route.livery.hue.fill}" stroke-width="{n(WIDTH)}" '
        f'stroke-linejoin="round" stroke-linecap="round"{style}><title>{xml_safe(title)}</title></path>'
    )


def _title(route: Route, passage: Passage) -> str:
    first, last = passage.line[0], passage.line[-1]
    return f"{route.robot}, {first.t_s:.1f} to {last.t_s:.1f} s, {passage.distance_m:.1f} m"


def _by_floor(passage: Passage, layout: MapLayout) -> Iterator[tuple[str, list[Point]]]:
    """The parts of a passage that are on one floor each, as far as they go anywhere."""
    floor, points = "", list[Point]()
    for waypoint in passage.line:
        if waypoint.floor != floor:
            if len(points) > 1:
                yield floor, points
            floor, points = waypoint.floor, []
        point = layout.at(waypoint.x_m, waypoint.y_m, waypoint.floor)
        if point is not None and (not points or math.dist(points[-1], point) > 0.05):
            points.append(point)
    if len(points) > 1:
        yield floor, points


def _arrows(owner: int, line: Sequence[Point], drawn: set[tuple[int, int, int, int]]) -> Iterator[str]:
    """Heads along a line, past the middle of a stretch, so that those of the way back stand elsewhere."""
    for x, y, ux, uy in _heads(line, owner % _STAGGERED * _STAGGER):
        key = (owner, round(x / 5), round(y / 5), round(math.atan2(uy, ux)))
        if key in drawn:
            continue
        drawn.add(key)
        back, side = (-2 * _HEAD * ux, -2 * _HEAD * uy), (-uy * _HEAD * 0.85, ux * _HEAD * 0.85)
        yield (
            f"M{n(x + _HEAD * ux)} {n(y + _HEAD * uy)}l{n(back[0] + side[0])} {n(back[1] + side[1])} "
            f"{n(-2 * side[0])} {n(-2 * side[1])}z"
        )


def _heads(line: Sequence[Point], further: float) -> Iterator[tuple[float, float, float, float]]:
    """Points and directions for arrow heads: on every straight stretch that has room, else on the line as a whole."""
    straight = [(start, end) for start, end in pairwise(line) if math.dist(start, end) >= _SHORTEST]
    for start, end in straight:
        length = math.dist(start, end)
        count = max(1, round(length / _EVERY))
        for index in range(count):
            yield _at((start, end), length * (index + 0.5) / count + min(_PAST + further, length / count / 2 - 8))
    length = math.fsum(math.dist(start, end) for start, end in pairwise(line))
    if not straight and length >= _SHORTEST:
        count = max(1, round(length / _EVERY))
        for index in range(count):
            yield _at(line, length * (index + 0.5) / count + _PAST / 2)


def _at(line: Sequence[Point], along: float) -> tuple[float, float, float, float]:
    """Point and direction at a distance along a line."""
    last = (line[-1][0], line[-1][1], 1.0, 0.0)
    for start, end in pairwise(line):
        length = math.dist(start, end)
        if length == 0:
            continue
        ux, uy = (end[0] - start[0]) / length, (end[1] - start[1]) / length
        if along <= length:
            return start[0] + ux * along, start[1] + uy * along, ux, uy
        along -= length
        last = (end[0], end[1], ux, uy)
    return last
