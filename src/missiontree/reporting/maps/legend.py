"""What stands below the map: a scale bar, and who goes where."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence

from missiontree.reporting.escape import one_line, xml_safe
from missiontree.reporting.maps.lines import route_line
from missiontree.reporting.maps.marks import pill, pill_width
from missiontree.reporting.maps.routes import Route
from missiontree.reporting.palette import INK, MUTED
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.text_box import text_width, wrapped

SIZE = 11.0
ROW = 20.0
LINE = 15.0
MOST_ROUTES = 12
MOST_LINES = 3


def scale_bar(scale: float, x: float, y: float) -> Iterator[str]:
    """
    A bar of a round number of metres, some hundred units long.

    Parameters
    ----------
    scale
        Units of the picture for a metre, above 0.
    x, y
        Its left end; the words stand above.
    """
    length_m = round_length(110.0 / scale)
    length = length_m * scale
    yield f'<g class="mt-map-scale"><title>scale: {metres(length_m)}</title>'
    yield (
        f'<path d="M{n(x)} {n(y - 4)} V{n(y)} H{n(x + length)} V{n(y - 4)} M{n(x + length / 2)} {n(y - 2.5)} V{n(y)}" fill="none" '
        f'stroke="{INK}" stroke-width="1.4"/>'
    )
    yield (
        f'<text class="mt-ink" x="{n(x + length / 2)}" y="{n(y - 7)}" text-anchor="middle" font-size="10.5" '
        f'fill="{INK}">{metres(length_m)}</text></g>'
    )


def round_length(most_m: float) -> float:
    """The largest of 1, 2 and 5 times a power of ten that is not above a length."""
    power = 10.0 ** math.floor(math.log10(most_m))
    return max((step * power for step in (1, 2, 5) if step * power <= most_m * (1 + 1e-9)), default=power)


def metres(length_m: float) -> str:
    """A round length for people."""
    return f"{length_m:g} m" if length_m < 1000 else f"{length_m / 1000:g} km"


def routes_key(
    routes: Sequence[Route], where: Callable[[Route], Sequence[str]], x: float, y: float, width: float
) -> tuple[list[str], float]:
    """
    Who goes where: a line for every robot, and the height of all.

    Parameters
    ----------
    routes
        Routes in order; after twelve, the rest is counted.
    where
        The stops of a route, each in words.
    x, y, width
        Upper left corner, and room for words.
    """
    lines: list[str] = []
    top = y
    lead = 44 + max((pill_width(route.letter) for route in routes), default=0.0)
    for route in routes[:MOST_ROUTES]:
        middle = top + ROW / 2
        lines += route_line([(x, middle), (x + 34, middle)], route, f"route of {route.robot}")
        lines += pill(route.letter, x + 38, middle, route.livery, route.robot)
        length = f", {metres_walked(route.distance_m)}" if route.distance_m else ""
        head = wrapped(f"{one_line(route.robot)} ({one_line(route.label)}{length}):", SIZE, width - lead, 1)[0]
        for number, line in enumerate(_packed(head, where(route), width - lead)):
            at = middle + 4 + number * LINE
            lines.append(f'<text class="mt-ink" x="{n(x + lead)}" y="{n(at)}" fill="{INK}">{xml_safe(line)}</text>')
            top += LINE if number else ROW
    if len(routes) > MOST_ROUTES:
        words = f"and {len(routes) - MOST_ROUTES} robots more"
        lines.append(f'<text class="mt-muted" x="{n(x + lead)}" y="{n(top + 14)}" fill="{MUTED}">{words}</text>')
        top += ROW
    return lines, top - y


def _packed(head: str, parts: Sequence[str], width: float) -> list[str]:
    """Parts in lines of that width, none torn unless it is wider than a line; what does not fit into three lines is counted."""
    lines = [head]
    counted = text_width(f" and {len(parts)} more", SIZE)
    for number, part in enumerate(parts):
        text = part + ("," if number + 1 < len(parts) else "")
        longer = f"{lines[-1]} {text}"
        if text_width(longer, SIZE) <= width - (counted if len(lines) == MOST_LINES else 0.0):
            lines[-1] = longer
        elif len(lines) < MOST_LINES:
            lines.append(wrapped(text, SIZE, width - counted, 1)[0])
        else:
            lines[-1] += f" and {len(parts) - number} more"
            break
    return lines


def metres_walked(length_m: float) -> str:
    """A length as it is travelled: whole metres, or kilometres."""
    if length_m < 100:
        return f"{length_m:.1f} m"
    return f"{length_m:.0f} m" if length_m < 10_000 else f"{length_m / 1000:.1f} km"
