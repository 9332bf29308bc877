"""Labels of the map: the names of what stands at a point, a line each, and the stops that routes make there."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from missiontree.reporting.escape import one_line, xml_safe
from missiontree.reporting.maps.clusters import Cluster
from missiontree.reporting.maps.labels import Placed
from missiontree.reporting.maps.marks import PILL_HEIGHT, pill, pill_width, sign
from missiontree.reporting.maps.routes import Route, Stop
from missiontree.reporting.maps.things import Thing, ThingKind
from missiontree.reporting.palette import INK, MUTED, PAPER, VIOLET
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.text_box import text_width, wrapped

SIZE = 11.0
LINE = 14.0
MOST_WIDTH = 156.0
MOST_NAMES = 8
MOST_PILLS = 18
_SIGN = 15.0
_EDGE = 3.0


@dataclass(frozen=True, slots=True)
class _Row:
    """A line of a label: a sign or pills in front, then words."""

    text: str = ""
    sign: ThingKind | None = None
    pills: tuple[tuple[str, Route, str], ...] = ()
    strong: bool = False
    quiet: bool = False
    unsure: bool = False
    indent: bool = False

    @property
    def lead(self) -> float:
        """Room in front of the words."""
        return sum(pill_width(text) + 2 for text, _, _ in self.pills) + (
            _SIGN if self.sign is not None or self.indent else 0.0
        )

    @property
    def width(self) -> float:
        """Room for all of it."""
        bold = 1.06 if self.strong else 1.0
        return self.lead + (text_width(self.text, SIZE) * bold + (2 if self.pills else 0) if self.text else 0.0)


@dataclass(frozen=True, slots=True)
class Card:
    """
    A label, ready to be placed.

    Parameters
    ----------
    rows
        Its lines.
    """

    rows: tuple[_Row, ...]

    @property
    def width(self) -> float:
        """Width with its edge."""
        return max(row.width for row in self.rows) + 2 * _EDGE

    @property
    def height(self) -> float:
        """Height with its edge."""
        return sum(_height(row) for row in self.rows) + 2


def card_of(cluster: Cluster, *, short: bool = False) -> Card | None:
    """
    The label of a cluster; None if it has nothing to say.

    Parameters
    ----------
    cluster
        What stands at a point.
    short
        Whether only the first name and the stops are given, for want of room.
    """
    rows = list(_names(cluster, short)) + list(_starts(cluster, short)) + list(_stops(cluster))
    return Card(tuple(rows)) if rows else None


def name_of(thing: Thing) -> str:
    """What people read of a thing: its label, and how many there are."""
    label = one_line(thing.label) or thing.id
    return label if thing.count == 1 else f"{label} ×{thing.count}"


def _names(cluster: Cluster, short: bool) -> Iterator[_Row]:
    shown = cluster.things[:1] if short else cluster.things[:MOST_NAMES]
    for place, thing in enumerate(shown):
        kind = None if place == 0 or thing.kind == "place" else thing.kind
        room = MOST_WIDTH - (_SIGN if kind is not None else 0.0)
        unsure = not thing.sure and place > 0
        lines = wrapped(name_of(thing) + (" ?" if unsure else ""), SIZE, room, 2 if place == 0 or kind == "lift" else 1)
        for number, line in enumerate(lines):
            lead = kind if number == 0 else None
            indent = kind is not None and number > 0
            yield _Row(
                line, lead, strong=thing.kind == "place", quiet=thing.kind == "node", unsure=unsure, indent=indent
            )
    if len(cluster.things) > len(shown) and not short:
        yield _Row(f"and {len(cluster.things) - len(shown)} more", quiet=True)


def _starts(cluster: Cluster, short: bool) -> Iterator[_Row]:
    shown = cluster.starts[:MOST_NAMES]
    if short and len(shown) > 1:
        yield _Row(pills=tuple((route.letter, route, f"{route.robot} starts here") for route in shown))
    else:
        for route in shown:
            name = wrapped(one_line(route.robot), SIZE, MOST_WIDTH - 24, 1)[0]
            yield _Row(name, pills=((route.letter, route, f"{route.robot} starts here"),))
    if len(cluster.starts) > len(shown):
        yield _Row(f"and {len(cluster.starts) - len(shown)} robots more", quiet=True)


def _stops(cluster: Cluster) -> Iterator[_Row]:
    if len(cluster.stops) > MOST_PILLS:
        robots = len({route.robot for route, _ in cluster.stops})
        yield _Row(f"{len(cluster.stops)} stops of {robots} {'robot' if robots == 1 else 'robots'}", quiet=True)
        return
    pills = [(f"{route.letter}{stop.number}", route, stop_title(route, stop)) for route, stop in cluster.stops]
    row: list[tuple[str, Route, str]] = []
    room = MOST_WIDTH
    for one in pills:
        width = pill_width(one[0]) + 2
        if row and width > room:
            yield _Row(pills=tuple(row))
            row, room = [], MOST_WIDTH
        row.append(one)
        room -= width
    if row:
        yield _Row(pills=tuple(row))


def stop_title(route: Route, stop: Stop) -> str:
    """A stop in words: who, from when to when, what."""
    when = f"{stop.start_s:.1f} s" if stop.end_s <= stop.start_s else f"{stop.start_s:.1f} to {stop.end_s:.1f} s"
    return f"{route.robot}, stop {stop.number}, {when}: {'; '.join(stop.texts)}"


def draw_card(card: Card, placed: Placed) -> Iterator[str]:
    """A label where it has found room."""
    box = placed.box
    yield '<g class="mt-map-label">'
    if placed.leader is not None:
        (ax, ay), (bx, by) = placed.leader
        line = f'd="M{n(ax)} {n(ay)} L{n(bx)} {n(by)}" fill="none"'
        yield f'<path {line} stroke="{PAPER}" stroke-width="3.5"/>'  # so that it is seen where it crosses routes
        yield f'<path class="mt-map-leader" {line} stroke="{INK}" stroke-width="0.9"/>'
    yield (
        f'<rect class="mt-map-card" x="{n(box.left)}" y="{n(box.top)}" width="{n(box.right - box.left)}" '
        f'height="{n(box.bottom - box.top)}" rx="3" fill="{PAPER}" fill-opacity="0.82"/>'
    )
    y = box.top + 1
    for row in card.rows:
        middle = y + _height(row) / 2
        x = box.left + _EDGE
        if row.sign is not None:
            yield from sign(row.sign, x + 6, middle)
        x += _SIGN if row.sign is not None or row.indent else 0.0
        for text, route, title in row.pills:
            yield from pill(text, x, middle, route.livery, title)
            x += pill_width(text) + 2
        if row.text:
            name, colour = (
                ("mt-map-unsure", VIOLET) if row.unsure else ("mt-muted", MUTED) if row.quiet else ("mt-ink", INK)
            )
            style = f'fill="{colour}"' + (' font-weight="bold"' if row.strong else "")
            at = x + (2 if row.pills else 0)
            yield f'<text class="{name}" x="{n(at)}" y="{n(middle + 3.9)}" {style}>{xml_safe(row.text)}</text>'
        y += _height(row)
    yield "</g>"


def _height(row: _Row) -> float:
    return PILL_HEIGHT + 2 if row.pills else LINE
