"""Metres to picture: a panel for every floor, all at one scale and showing one and the same stretch of ground."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.reporting.maps.things import MapContent

MARGIN = 16.0
TITLE = 26.0
GAP = 16.0
PAD_X, PAD_Y = 92.0, 54.0
"""Room for labels round what is shown."""
MOST_WIDTH, MOST_HEIGHT = 900.0, 600.0
"""Of all panels together, as long as that leaves each of them ``LEAST_SIDE``."""
LEAST_SIDE = 150.0
_NEARLY = 0.75
"""Of the largest scale there could be; for that, floors stand side by side."""
LEAST_EXTENT_M = 2.0
"""A scene that is one point is shown as that many metres."""
LARGEST_SCALE = 200.0
FARTHEST_M = 1e9


@dataclass(frozen=True, slots=True)
class Panel:
    """
    The part of the picture that shows a floor.

    Parameters
    ----------
    floor
        Which floor.
    x, y, width, height
        Where it is in the picture.
    """

    floor: str
    x: float
    y: float
    width: float
    height: float


@dataclass(frozen=True, slots=True)
class MapLayout:
    """
    Where what is.

    Parameters
    ----------
    panels
        One for every floor.
    scale
        Units of the picture for a metre.
    x_m, y_m
        The point in the middle of every panel.
    titled
        Whether panels carry the name of their floor.
    width, height
        Of all panels with the margin round them.
    """

    panels: tuple[Panel, ...]
    scale: float
    x_m: float
    y_m: float
    titled: bool
    width: float
    height: float

    def panel(self, floor: str) -> Panel | None:
        """The panel of a floor; None if it is not shown."""
        return next((panel for panel in self.panels if panel.floor == floor), None)

    def point(self, spot: Position) -> tuple[float, float] | None:
        """Where in the picture a position is; None if its floor is not shown."""
        return self.at(spot.x_m, spot.y_m, spot.floor)

    def at(self, x_m: float, y_m: float, floor: str) -> tuple[float, float] | None:
        """The same for coordinates in frame ``map``."""
        panel = self.panel(floor)
        if panel is None:
            return None
        return (
            panel.x + panel.width / 2 + (_on_earth(x_m) - self.x_m) * self.scale,
            panel.y + panel.height / 2 - (_on_earth(y_m) - self.y_m) * self.scale,
        )


def layout_of(content: MapContent, plan: Plan, floor: str | None = None) -> MapLayout | None:
    """
    Lay out a map; the same for every alternative of a plan. None if nothing has a position on the floors to be shown.

    Parameters
    ----------
    content
        What is shown.
    plan
        Its schedules say where robots go.
    floor
        The only floor to be shown; None means all.
    """
    points = [(_on_earth(x), _on_earth(y), one) for x, y, one in _points(content, plan)]
    floors = [one for one in dict.fromkeys([*content.floors, *(one for _, _, one in points)]) if floor in {None, one}]
    points = [point for point in points if point[2] in floors]
    if not points:
        return None
    low_x, high_x = min(x for x, _, _ in points), max(x for x, _, _ in points)
    low_y, high_y = min(y for _, y, _ in points), max(y for _, y, _ in points)
    wide, high = max(high_x - low_x, 0.0), max(high_y - low_y, 0.0)
    if max(wide, high) == 0.0:
        wide, high = LEAST_EXTENT_M, LEAST_EXTENT_M / 4
    titled = len(content.floors) > 1
    head = TITLE if titled else 0.0
    scales = {columns: _scale(wide, high, columns, len(floors), head) for columns in range(1, len(floors) + 1)}
    columns = max(columns for columns, scale in scales.items() if scale >= _NEARLY * max(scales.values()))
    scale = scales[columns]
    width = max(wide * scale, LEAST_SIDE) + 2 * PAD_X
    height = max(high * scale, LEAST_SIDE * 0.6) + 2 * PAD_Y
    panels = tuple(
        Panel(
            one,
            MARGIN + place % columns * (width + GAP),
            MARGIN + head + place // columns * (height + head + GAP),
            width,
            height,
        )
        for place, one in enumerate(floors)
    )
    rows = math.ceil(len(floors) / columns)
    return MapLayout(
        panels,
        scale,
        (low_x + high_x) / 2,
        (low_y + high_y) / 2,
        titled,
        2 * MARGIN + columns * (width + GAP) - GAP,
        2 * MARGIN + rows * (height + head + GAP) - GAP,
    )


def _on_earth(number_m: float) -> float:
    """A coordinate that no arithmetic breaks on: at most a million kilometres."""
    return max(-FARTHEST_M, min(FARTHEST_M, number_m))


def _scale(wide_m: float, high_m: float, columns: int, count: int, head: float) -> float:
    """The largest scale at which panels in so many columns fit."""
    rows = math.ceil(count / columns)
    width = max((MOST_WIDTH + GAP) / columns - GAP - 2 * PAD_X, LEAST_SIDE)
    height = max((MOST_HEIGHT + GAP) / rows - GAP - head - 2 * PAD_Y, LEAST_SIDE)
    return min(width / wide_m if wide_m else math.inf, height / high_m if high_m else math.inf, LARGEST_SCALE)


def _points(content: MapContent, plan: Plan) -> Iterator[tuple[float, float, str]]:
    """Everything that has to be inside."""
    for thing in content.things:
        yield thing.spot.x_m, thing.spot.y_m, thing.spot.floor
    for shown in content.areas:
        for x_m, y_m in shown.area.corners:
            yield x_m, y_m, shown.area.floor
    if (grid := content.scene.grid) is not None:
        yield grid.x_m, grid.y_m, grid.floor
        yield grid.x_m + len(grid.rows[0]) * grid.cell_m, grid.y_m + len(grid.rows) * grid.cell_m, grid.floor
    for schedule in plan.schedules:
        for leg in schedule.ways:
            for spot in (leg.origin, leg.destination):
                yield spot.x_m, spot.y_m, spot.floor
