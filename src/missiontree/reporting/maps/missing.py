"""The box beside the map of those whose position is not known."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.reporting.escape import one_line, xml_safe
from missiontree.reporting.maps.marks import mark, pill, pill_width
from missiontree.reporting.maps.routes import Route
from missiontree.reporting.maps.things import Missing
from missiontree.reporting.palette import INK, MUTED, PAPER, VIOLET
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.text_box import wrapped

SIDE = 190.0
"""Its width."""
SIZE = 11.0
LINE = 15.0
ROW = 20.0
MOST_MISSING = 12


def side_box(missing: Sequence[Missing], robots: Sequence[Route], x: float, y: float) -> tuple[list[str], float]:
    """
    The box of those whose position is not known, and its height.

    Parameters
    ----------
    missing
        Entities.
    robots
        Routes of robots that start nobody knows where.
    x, y
        Its upper left corner.
    """
    body: list[str] = []
    top = y + 26
    for one in missing[:MOST_MISSING]:
        body += mark(one.kind, x + 18, top + 9, sure=False, scale=0.85)
        top = _words(body, one_line(one.label) or one.id, one.note, x + 34, top)
    if len(missing) > MOST_MISSING:
        body.append(
            f'<text class="mt-muted" x="{n(x + 34)}" y="{n(top + 11)}" fill="{MUTED}">and {len(missing) - MOST_MISSING} more</text>'
        )
        top += ROW
    for route in robots[:MOST_MISSING]:
        body += pill(route.letter, x + 10, top + 9, route.livery, f"where {route.robot} starts is not known")
        top = _words(body, one_line(route.robot), "start not known", x + 18 + pill_width(route.letter), top)
    if len(robots) > MOST_MISSING:
        words = f"and {len(robots) - MOST_MISSING} robots more"
        body.append(f'<text class="mt-muted" x="{n(x + 34)}" y="{n(top + 11)}" fill="{MUTED}">{words}</text>')
        top += ROW
    height = top - y + 4
    head = [
        f'<rect class="mt-map-side" x="{n(x)}" y="{n(y)}" width="{n(SIDE)}" height="{n(height)}" rx="6" fill="{PAPER}" '
        f'stroke="{VIOLET}" stroke-dasharray="4 3"/>',
        f'<text class="mt-map-unsure" x="{n(x + 10)}" y="{n(y + 17)}" font-weight="bold" fill="{VIOLET}">position unknown</text>',
    ]
    return head + body, height


def _words(body: list[str], name: str, note: str, x: float, top: float) -> float:
    lines = wrapped(name, SIZE, SIDE - 42, 2)
    for number, line in enumerate(lines):
        body.append(
            f'<text class="mt-ink" x="{n(x)}" y="{n(top + 12 + number * LINE)}" fill="{INK}">{xml_safe(line)}</text>'
        )
    top += 12 + (len(lines) - 1) * LINE
    if note:
        top += 13
        body.append(
            f'<text class="mt-muted" x="{n(x)}" y="{n(top)}" font-size="9.5" fill="{MUTED}">{xml_safe(note)}</text>'
        )
    return top + 10
