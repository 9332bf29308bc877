"""Names of zones and keep-outs, inside them where there is room."""

from __future__ import annotations

from collections.abc import Generator, Sequence

from missiontree.estimation.polygon import Point, Polygon
from missiontree.reporting.escape import one_line, xml_safe
from missiontree.reporting.maps.boxes import Box
from missiontree.reporting.maps.labels import Ground
from missiontree.reporting.maps.things import ShownArea
from missiontree.reporting.palette import BLUE, PAPER, RED
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.text_box import text_width, wrapped

SIZE = 11.0
HEIGHT = 14.0
MOST_WIDTH = 150.0
_STEPS = 8


def area_name(labels: Ground, shown: ShownArea, corners: Sequence[Point]) -> Generator[str, None, bool]:
    """
    The name of an area; whether there was room.

    Parameters
    ----------
    labels
        What there is already.
    shown
        The area.
    corners
        Its corners in the picture.
    """
    text = wrapped(one_line(shown.label), SIZE, MOST_WIDTH, 1)[0]
    width = text_width(text, SIZE) + 6
    box = _inside(labels, Polygon(corners), width)
    if box is not None:
        labels.take(box)
    else:
        placed = labels.place(_bounds(corners), width, HEIGHT, 0.0)
        if placed is None:
            return False
        box = placed.box
    name, colour = ("mt-map-zone-name", BLUE)
    if shown.role == "keep_out":
        name, colour = ("mt-map-keep-out-name", RED)
        yield (
            f'<rect class="mt-map-card" x="{n(box.left)}" y="{n(box.top)}" width="{n(width)}" height="{n(HEIGHT)}" rx="3" '
            f'fill="{PAPER}" fill-opacity="0.82"/>'
        )
    yield (
        f'<text class="{name}" x="{n(box.left + 3)}" y="{n(box.bottom - 3.5)}" font-style="italic" fill="{colour}">'
        f"{xml_safe(text)}</text>"
    )
    return True


def _bounds(corners: Sequence[Point]) -> Box:
    across, down = [x for x, _ in corners], [y for _, y in corners]
    return Box(min(across), min(down), max(across), max(down))


def _inside(labels: Ground, polygon: Polygon, width: float) -> Box | None:
    """The first free place inside a polygon, from the top, in from the left."""
    bounds = _bounds(polygon.corners)
    for down in range(_STEPS + 1):
        for across in range(_STEPS + 1):
            left = bounds.left + 4 + (bounds.right - bounds.left - width - 8) * across / _STEPS
            top = bounds.top + 3 + (bounds.bottom - bounds.top - HEIGHT - 6) * down / _STEPS
            box = Box(left, top, left + width, top + HEIGHT)
            ends = [(x, y) for x in (box.left, (box.left + box.right) / 2, box.right) for y in (box.top, box.bottom)]
            if all(polygon.covers(end) for end in ends) and labels.free(box):
                return box
    return None
