"""Names of zones and keep-outs, inside them where there is room."""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence

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
_RULE_WIDTHS = (240.0, 150.0, 100.0)
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
    for lines in _wordings(shown):
        width, height = max(text_width(line, SIZE) for line in lines) + 6, HEIGHT * len(lines)
        box = _inside(labels, Polygon(corners), width, height)
        if box is not None:
            labels.take(box)
            break
    else:
        placed = labels.place(_bounds(corners), width, height, 0.0)
        if placed is None:
            return False
        box = placed.box
    name, colour = ("mt-map-zone-name", BLUE)
    if shown.role == "keep_out":
        name, colour = ("mt-map-keep-out-name", RED)
        yield (
            f'<rect class="mt-map-card" x="{n(box.left)}" y="{n(box.top)}" width="{n(width)}" height="{n(height)}" rx="3" '
            f'fill="{PAPER}" fill-opacity="0.82"/>'
        )
    for place, line in enumerate(lines):
        y = box.top + HEIGHT * (place + 1) - 3.5
        yield (
            f'<text class="{name}" x="{n(box.left + 3)}" y="{n(y)}" font-style="italic" fill="{colour}">'
            f"{xml_safe(line)}</text>"
        )
    return True


def _wordings(shown: ShownArea) -> Iterator[list[str]]:
    """Lines that may be written, the fullest first: last comes the name alone."""
    name = wrapped(one_line(shown.label), SIZE, MOST_WIDTH, 1)
    if shown.closed_words:
        whole = f"{name[0]}: {shown.closed_words}"
        if text_width(whole, SIZE) <= _RULE_WIDTHS[0]:
            yield [whole]
        for room in _RULE_WIDTHS:
            yield [*name, *wrapped(shown.closed_words, SIZE, room, 3)]
    yield name


def _bounds(corners: Sequence[Point]) -> Box:
    across, down = [x for x, _ in corners], [y for _, y in corners]
    return Box(min(across), min(down), max(across), max(down))


def _inside(labels: Ground, polygon: Polygon, width: float, height: float) -> Box | None:
    """The first free place inside a polygon, from the top, in from the left."""
    bounds = _bounds(polygon.corners)
    for down in range(_STEPS + 1):
        for across in range(_STEPS + 1):
            left = bounds.left + 4 + (bounds.right - bounds.left - width - 8) * across / _STEPS
            top = bounds.top + 3 + (bounds.bottom - bounds.top - height - 6) * down / _STEPS
            box = Box(left, top, left + width, top + height)
            ends = [(x, y) for x in (box.left, (box.left + box.right) / 2, box.right) for y in (box.top, box.bottom)]
            if all(polygon.covers(end) for end in ends) and labels.free(box):
                return box
    return None
