"""The ground of the map: zones, keep-outs, walls, search areas, roads."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

from missiontree.mission.ways import OccupancyGrid
from missiontree.reporting.escape import xml_safe
from missiontree.reporting.maps.boxes import Box
from missiontree.reporting.maps.layout import MapLayout
from missiontree.reporting.maps.things import MapContent, ShownArea, ShownRoad
from missiontree.reporting.maps.walls import walls
from missiontree.reporting.palette import BLUE, INK, PAPER, QUIET, RED, VIOLET
from missiontree.reporting.svg_numbers import n

Point = tuple[float, float]

ROAD = 7.0
WALL = "#9aa1ab"
ROAD_FILL = "#e3e6ea"
CLOSED_TO_SOME = f'fill="{RED}" fill-opacity="0.04" stroke="{RED}" stroke-width="1.2" stroke-dasharray="9 3 2 3"'
"""A keep-out that some robots cross has no hatches: those say that nobody is ever in there."""
_HATCH = 8.0
_MOST_HATCH = 400
_ARROW_EVERY = 110.0
_CROSS_EVERY = 200.0


def ground(content: MapContent, layout: MapLayout, floor: str) -> Iterator[str]:
    """Everything of one floor that lies below marks and routes, from back to front."""
    if content.scene.grid is not None and content.scene.grid.floor == floor:
        yield from _walls(content.scene.grid, layout)
    for role in ("zone", "keep_out"):
        for shown in content.areas:
            if shown.role == role and shown.area.floor == floor:
                yield from _area(shown, layout)
    roads = [road for road in content.roads if road.start.floor == floor]
    if roads:
        yield f'<g fill="none" stroke="{ROAD_FILL}" stroke-width="{n(ROAD)}" stroke-linecap="round">'
        for road in roads:
            yield from _road(road, layout)
        yield "</g>"
    for road in roads:
        yield from _rules(road, layout)
    for shown in content.areas:
        if shown.role == "search_area" and shown.area.floor == floor:
            yield from _area(shown, layout)


def corners_of(shown: ShownArea, layout: MapLayout) -> list[Point]:
    """Corners of an area in the picture."""
    points = (layout.at(x_m, y_m, shown.area.floor) for x_m, y_m in shown.area.corners)
    return [point for point in points if point is not None]


def _area(shown: ShownArea, layout: MapLayout) -> Iterator[str]:
    corners = corners_of(shown, layout)
    outline = f"M{' L'.join(f'{n(x)} {n(y)}' for x, y in corners)} z"
    yield f'<g class="mt-map-{shown.role.replace("_", "-")}"><title>{xml_safe(shown.note)}</title>'
    if shown.role == "zone":
        yield f'<path d="{outline}" fill="{BLUE}" fill-opacity="0.05" stroke="{BLUE}" stroke-opacity="0.45" stroke-dasharray="7 4"/>'
    elif shown.role == "search_area":
        yield f'<path d="{outline}" fill="{VIOLET}" fill-opacity="0.05" stroke="{VIOLET}" stroke-width="1.3" stroke-dasharray="4 3"/>'
    elif shown.closed_to is not None:
        yield f'<path d="{outline}" {CLOSED_TO_SOME}/>'
    else:
        yield f'<path d="{outline}" fill="{RED}" fill-opacity="0.06" stroke="{RED}" stroke-width="1.2"/>'
        strokes = " ".join(f"M{n(ax)} {n(ay)} L{n(bx)} {n(by)}" for (ax, ay), (bx, by) in hatch(corners))
        if strokes:
            yield f'<path d="{strokes}" fill="none" stroke="{RED}" stroke-opacity="0.55" stroke-width="0.9"/>'
    yield "</g>"


def hatch(corners: Sequence[Point]) -> list[tuple[Point, Point]]:
    """
    Rising lines that fill a polygon, told apart from what is outside by the even-odd rule.

    They are lines and no pattern, since a pattern needs an id, and a picture's ids may meet others of the page it stands on.
    """
    heights = [x + y for x, y in corners]
    span = max(heights) - min(heights)
    gap = max(_HATCH * math.sqrt(2), span / _MOST_HATCH)
    edges = list(pairwise([*corners, corners[0]]))
    lines = []
    height = (math.floor(min(heights) / gap) + 1) * gap
    while height < max(heights):
        cuts = []
        for (ax, ay), (bx, by) in edges:
            low, high = ax + ay - height, bx + by - height
            if (low <= 0.0) != (high <= 0.0):
                share = low / (low - high)
                cuts.append((ax + share * (bx - ax), ay + share * (by - ay)))
        cuts.sort()
        lines += list(zip(cuts[::2], cuts[1::2], strict=True))
        height += gap
    return lines


def wall_boxes(grid: OccupancyGrid, layout: MapLayout) -> list[Box]:
    """The walls of a grid as rectangles of the picture."""
    drawn, free = walls(grid, layout.scale), _extent(grid, layout)
    size = drawn.cell_m * layout.scale
    corners = ((free.left + rect.column * size, free.top + rect.row * size, rect) for rect in drawn.rects)
    return [
        Box(x, y, min(x + rect.columns * size, free.right), min(y + rect.rows * size, free.bottom))
        for x, y, rect in corners
    ]


def _extent(grid: OccupancyGrid, layout: MapLayout) -> Box:
    left, top = layout.at(grid.x_m, grid.y_m + len(grid.rows) * grid.cell_m, grid.floor) or (0.0, 0.0)
    width, height = (side * grid.cell_m * layout.scale for side in (len(grid.rows[0]), len(grid.rows)))
    return Box(left, top, left + width, top + height)


def _walls(grid: OccupancyGrid, layout: MapLayout) -> Iterator[str]:
    free = _extent(grid, layout)
    yield (
        f'<rect class="mt-map-free" x="{n(free.left)}" y="{n(free.top)}" width="{n(free.right - free.left)}" '
        f'height="{n(free.bottom - free.top)}" fill="{PAPER}" stroke="{QUIET}" stroke-width="0.8"/>'
    )
    path = [
        f"M{n(wall.left)} {n(wall.top)}H{n(wall.right)}V{n(wall.bottom)}H{n(wall.left)}z"
        for wall in wall_boxes(grid, layout)
    ]
    if path:
        yield f'<path class="mt-map-wall" d="{"".join(path)}" fill="{WALL}"><title>walls</title></path>'


def _road(road: ShownRoad, layout: MapLayout) -> Iterator[str]:
    start, end = layout.point(road.start), layout.point(road.end)
    if start is None or end is None:
        return
    line = f"M{n(start[0])} {n(start[1])} L{n(end[0])} {n(end[1])}"
    yield f'<path class="mt-map-road" d="{line}"><title>{xml_safe(road.note)}</title></path>'


def _rules(road: ShownRoad, layout: MapLayout) -> Iterator[str]:
    """What holds on a road: arrows if it is one-way, dots if it is for some only, crosses if it is blocked."""
    start, end = layout.point(road.start), layout.point(road.end)
    if start is None or end is None:
        return
    length = math.dist(start, end)
    if road.limited:
        yield (
            f'<path class="mt-map-limited" d="M{n(start[0])} {n(start[1])} L{n(end[0])} {n(end[1])}" fill="none" stroke="{QUIET}" '
            'stroke-width="1.6" stroke-dasharray="1.6 5" stroke-linecap="round"/>'
        )
    if length < 16:
        return
    ux, uy = (end[0] - start[0]) / length, (end[1] - start[1]) / length
    count = max(1, round(length / (_CROSS_EVERY if road.blocked else _ARROW_EVERY)))
    for index in range(count):
        share = (index + 0.5) / count
        x, y = start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1])
        if road.one_way and not road.blocked:
            yield chevron(x, y, ux, uy)
        if road.blocked:
            yield (
                f'<path class="mt-map-blocked" d="M{n(x - 4)} {n(y - 4)} l8 8 M{n(x + 4)} {n(y - 4)} l-8 8" fill="none" '
                f'stroke="{RED}" stroke-width="2"/>'
            )


def chevron(x: float, y: float, ux: float, uy: float) -> str:
    """An open arrow head in the middle of a one-way road."""
    back, side = 2.2, 3.0
    left = (x - back * ux - side * uy, y - back * uy + side * ux)
    right = (x - back * ux + side * uy, y - back * uy - side * ux)
    tip = (x + back * ux, y + back * uy)
    points = " L".join(f"{n(px)} {n(py)}" for px, py in (left, tip, right))
    return f'<path class="mt-map-one-way" d="M{points}" fill="none" stroke="{INK}" stroke-opacity="0.7" stroke-width="1.4"/>'
