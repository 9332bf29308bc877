"""Signs of the map: what stands there, told by its shape, and letters for robots."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.reporting.escape import xml_safe
from missiontree.reporting.maps.things import ThingKind
from missiontree.reporting.palette import HAIR, INK, PAPER, QUIET, VIOLET, Livery
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.text_box import text_width

RADIUS = 9.0
SMALL = 4.0
"""Radius of a place's mark, which needs no disc."""
PILL_HEIGHT = 14.0
PILL_SIZE = 10.0


def mark_radius(kind: ThingKind) -> float:
    """How much room a mark takes, from its middle."""
    return {"place": SMALL + 1.5, "node": 2.5}.get(kind, RADIUS)


def mark(kind: ThingKind, x: float, y: float, *, sure: bool = True, scale: float = 1.0) -> Iterator[str]:
    """
    A sign on the map; everything but places and road nodes on a disc, dashed and with a question mark if its position is not known.

    Parameters
    ----------
    kind
        What it is.
    x, y
        Its middle.
    sure
        Whether it is known to be there.
    scale
        Its size, default 1.
    """
    if kind == "node":
        yield f'<circle class="mt-map-node" cx="{n(x)}" cy="{n(y)}" r="2.2" fill="{QUIET}"/>'
        return
    if kind == "place" and sure:
        yield (
            f'<rect class="mt-map-place" x="{n(x - SMALL)}" y="{n(y - SMALL)}" width="{n(2 * SMALL)}" height="{n(2 * SMALL)}" '
            f'rx="1.5" fill="{INK}" stroke="{PAPER}" stroke-width="1.5"/>'
        )
        return
    edge = f'stroke="{INK}"' if sure else f'stroke="{VIOLET}" stroke-dasharray="3 2"'
    size = RADIUS * scale
    yield f'<circle class="mt-map-disc" cx="{n(x)}" cy="{n(y)}" r="{n(size)}" fill="{PAPER}" {edge}/>'
    yield from sign(kind, x, y, scale=0.95 * scale)
    if not sure:
        yield (
            f'<text class="mt-map-unsure" x="{n(x + size + 3.5)}" y="{n(y - size * 0.3)}" text-anchor="middle" font-size="11" '
            f'font-weight="bold" fill="{VIOLET}">?</text>'
        )


def sign(kind: ThingKind, x: float, y: float, *, scale: float = 1.0) -> Iterator[str]:
    """The shape alone, as it stands in front of a name; some ten units wide at scale 1."""
    place = f'transform="translate({n(x)} {n(y)}) scale({scale:.3g})"'
    yield f'<path class="mt-map-sign" {place} d="{_SHAPES[kind]}" fill="{INK}" fill-rule="evenodd"/>'


_SHAPES: dict[ThingKind, str] = {
    "place": "M-4 -4 h8 v8 h-8 z",
    "node": "M-2 -2 h4 v4 h-4 z",
    # a head and shoulders
    "person": "M-2.5 -2.9 a2.5 2.5 0 1 0 5 0 a2.5 2.5 0 1 0 -5 0 z M-5 5.2 a5 4.9 0 0 1 10 0 z",
    # a paw: a pad and four toes
    "animal": (
        "M0 -0.4 c1.9 0 4 2 4 3.7 c0 1.6 -1.5 1.9 -2.4 1.7 c-0.7 -0.2 -1 -0.4 -1.6 -0.4 c-0.6 0 -0.9 0.2 -1.6 0.4 c-0.9 0.2 -2.4 -0.1 "
        "-2.4 -1.7 c0 -1.7 2.1 -3.7 4 -3.7 z M-5.4 -0.9 a1.2 1.6 0 1 0 2.4 0 a1.2 1.6 0 1 0 -2.4 0 z M3 -0.9 a1.2 1.6 0 1 0 2.4 0 "
        "a1.2 1.6 0 1 0 -2.4 0 z M-3 -3.6 a1.2 1.6 0 1 0 2.4 0 a1.2 1.6 0 1 0 -2.4 0 z M0.6 -3.6 a1.2 1.6 0 1 0 2.4 0 a1.2 1.6 0 1 0 "
        "-2.4 0 z"
    ),
    # a cube
    "object": (
        "M0 -5.4 L4.5 -3.1 L0 -0.8 L-4.5 -3.1 z M-4.9 -2.2 L-0.5 0 V5.2 L-4.9 2.9 z M4.9 -2.2 L0.5 0 V5.2 L4.9 2.9 z"
    ),
    # a head with two eyes and an antenna
    "robot": (
        "M-0.6 -5.6 h1.2 v2 h3.2 a1 1 0 0 1 1 1 v6 a1 1 0 0 1 -1 1 h-7.6 a1 1 0 0 1 -1 -1 v-6 a1 1 0 0 1 1 -1 h3.2 z "
        "M-3.1 0.1 a1.2 1.2 0 1 0 2.4 0 a1.2 1.2 0 1 0 -2.4 0 z M0.7 0.1 a1.2 1.2 0 1 0 2.4 0 a1.2 1.2 0 1 0 -2.4 0 z"
    ),
    # up and down
    "lift": "M0 -5.2 L3.8 -0.9 H-3.8 z M0 5.2 L-3.8 0.9 H3.8 z",
}


def pill_width(text: str) -> float:
    """Width of a pill with that text."""
    return max(PILL_HEIGHT, text_width(text, PILL_SIZE) + 7)


def pill(text: str, x: float, y: float, livery: Livery, title: str) -> Iterator[str]:
    """
    Letter, or letter and number of a stop, on the colour of its robot.

    Parameters
    ----------
    text
        ``A`` or ``A1``.
    x, y
        Left end, and middle of its height.
    livery
        Colour of the robot.
    title
        What is said when it is pointed at.
    """
    width = pill_width(text)
    yield f'<g class="mt-map-pill mt-hue-{livery.number}"><title>{xml_safe(title)}</title>'
    yield (
        f'<rect class="mt-fill" x="{n(x)}" y="{n(y - PILL_HEIGHT / 2)}" width="{n(width)}" height="{n(PILL_HEIGHT)}" '
        f'rx="{n(PILL_HEIGHT / 2)}" fill="{livery.hue.fill}"/>'
    )
    yield (
        f'<text class="mt-on" x="{n(x + width / 2)}" y="{n(y + 3.6)}" text-anchor="middle" font-size="{n(PILL_SIZE)}" '
        f'font-weight="bold" fill="{livery.hue.on}">{xml_safe(text)}</text></g>'
    )


def dot(x: float, y: float, title: str = "") -> str:
    """Something that has no mark of its own, since others are too near; the title is said when it is pointed at."""
    said = f"><title>{xml_safe(title)}</title></circle>" if title else "/>"
    return f'<circle class="mt-map-dot" cx="{n(x)}" cy="{n(y)}" r="2.2" fill="{INK}" stroke="{HAIR}" stroke-width="0.8"{said}'
