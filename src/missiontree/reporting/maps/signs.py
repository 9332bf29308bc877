"""What the signs of a map mean, those that it has."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from missiontree.reporting.escape import xml_safe
from missiontree.reporting.maps.ground import CLOSED_TO_SOME, ROAD, ROAD_FILL, WALL, chevron, hatch
from missiontree.reporting.maps.marks import mark
from missiontree.reporting.maps.things import KINDS, MapContent, ThingKind
from missiontree.reporting.palette import BLUE, INK, PAPER, QUIET, RED, VIOLET
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.text_box import text_width

SIZE = 11.0
ROW = 20.0
_ICON = 30.0


@dataclass(frozen=True, slots=True)
class Entry:
    """A sign and what it means; the sign is drawn from its left end and the middle of its height, 22 units wide."""

    draw: Callable[[float, float], Iterator[str]]
    words: str

    @property
    def width(self) -> float:
        """Room for both and a gap."""
        return _ICON + text_width(self.words, SIZE) + 18


def entries_of(content: MapContent, floors: Sequence[str]) -> list[Entry]:
    """The signs that the floors shown have, in a fixed order."""
    things = [thing for thing in content.things if thing.spot.floor in floors]
    kinds = {thing.kind for thing in things if thing.sure}
    areas = {shown.role for shown in content.areas if shown.area.floor in floors}
    roads = [road for road in content.roads if road.start.floor in floors]
    words = {
        "person": "person",
        "animal": "animal",
        "object": "thing",
        "robot": "robot, at its start",
        "lift": content.floor_words,
        "place": "place",
    }
    found = [Entry(_mark_sign(kind), words[kind]) for kind in KINDS if kind in kinds and kind in words]
    if any(not thing.sure for thing in things):
        found.append(Entry(_unsure, "position unknown, planned here"))
    if "search_area" in areas:
        found.append(Entry(_frame(VIOLET, "4 3"), "search area"))
    if "zone" in areas:
        found.append(Entry(_frame(BLUE, "7 4"), "zone"))
    closed = [shown for shown in content.areas if shown.role == "keep_out" and shown.area.floor in floors]
    if any(shown.closed_to is None for shown in closed):
        found.append(Entry(_keep_out, "keep-out"))
    if any(shown.closed_to is not None for shown in closed):
        found.append(Entry(_closed_to_some, "closed to some robot types"))
    if content.scene.grid is not None and content.scene.grid.floor in floors:
        found.append(Entry(_wall, "wall"))
    if any(road.one_way and not road.blocked for road in roads):
        found.append(Entry(_one_way, "one-way"))
    if any(road.limited for road in roads):
        found.append(Entry(_limited, "only for some robot types"))
    if any(road.blocked for road in roads):
        found.append(Entry(_blocked, "blocked"))
    return found


def entries(found: Sequence[Entry], x: float, y: float, width: float) -> tuple[list[str], float]:
    """The signs and their meanings in lines of that width, and the height they take."""
    lines: list[str] = []
    left, top = x, y
    for entry in found:
        if left > x and left + entry.width > x + width:
            left, top = x, top + ROW
        middle = top + ROW / 2
        lines += entry.draw(left, middle)
        lines.append(
            f'<text class="mt-ink" x="{n(left + _ICON)}" y="{n(middle + 4)}" fill="{INK}">{xml_safe(entry.words)}</text>'
        )
        left += entry.width
    return lines, (top - y + ROW if found else 0.0)


def _mark_sign(kind: ThingKind) -> Callable[[float, float], Iterator[str]]:
    return lambda x, y: mark(kind, x + 11, y, scale=0.9)


def _unsure(x: float, y: float) -> Iterator[str]:
    yield f'<circle cx="{n(x + 10)}" cy="{n(y)}" r="8" fill="{PAPER}" stroke="{VIOLET}" stroke-dasharray="3 2"/>'
    yield f'<text x="{n(x + 10)}" y="{n(y + 4)}" text-anchor="middle" font-weight="bold" fill="{VIOLET}">?</text>'


def _frame(colour: str, dashes: str) -> Callable[[float, float], Iterator[str]]:
    def draw(x: float, y: float) -> Iterator[str]:
        yield (
            f'<rect x="{n(x)}" y="{n(y - 6)}" width="22" height="12" fill="{colour}" fill-opacity="0.05" stroke="{colour}" '
            f'stroke-dasharray="{dashes}"/>'
        )

    return draw


def _keep_out(x: float, y: float) -> Iterator[str]:
    corners = [(x, y - 6), (x + 22, y - 6), (x + 22, y + 6), (x, y + 6)]
    strokes = " ".join(f"M{n(ax)} {n(ay)} L{n(bx)} {n(by)}" for (ax, ay), (bx, by) in hatch(corners))
    yield f'<rect x="{n(x)}" y="{n(y - 6)}" width="22" height="12" fill="{RED}" fill-opacity="0.06" stroke="{RED}" stroke-width="1.2"/>'
    yield f'<path d="{strokes}" fill="none" stroke="{RED}" stroke-opacity="0.55" stroke-width="0.9"/>'


def _closed_to_some(x: float, y: float) -> Iterator[str]:
    yield f'<rect x="{n(x)}" y="{n(y - 6)}" width="22" height="12" {CLOSED_TO_SOME}/>'


def _wall(x: float, y: float) -> Iterator[str]:
    yield f'<rect x="{n(x)}" y="{n(y - 5)}" width="22" height="10" fill="{WALL}"/>'


def _band(x: float, y: float) -> str:
    return f'<path d="M{n(x)} {n(y)} h22" fill="none" stroke="{ROAD_FILL}" stroke-width="{n(ROAD)}" stroke-linecap="round"/>'


def _one_way(x: float, y: float) -> Iterator[str]:
    yield _band(x, y)
    yield chevron(x + 11, y, 1.0, 0.0)


def _limited(x: float, y: float) -> Iterator[str]:
    yield _band(x, y)
    yield f'<path d="M{n(x)} {n(y)} h22" fill="none" stroke="{QUIET}" stroke-width="1.6" stroke-dasharray="1.6 5" stroke-linecap="round"/>'


def _blocked(x: float, y: float) -> Iterator[str]:
    yield _band(x, y)
    yield f'<path d="M{n(x + 7)} {n(y - 4)} l8 8 M{n(x + 15)} {n(y - 4)} l-8 8" fill="none" stroke="{RED}" stroke-width="2"/>'
