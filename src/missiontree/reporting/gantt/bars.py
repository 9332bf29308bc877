"""The inside of a row of a Gantt chart: roles as soft bands, actions as bars, ways striped, waits dotted, and their words."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from missiontree.reporting.escape import xml_safe
from missiontree.reporting.gantt.content import Bar, Row
from missiontree.reporting.gantt.labels import Word
from missiontree.reporting.gantt.layout import FOOT, Place, Scale
from missiontree.reporting.palette import INK, MUTED, PAPER, Livery
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.svg_page import text

WAY = 9.0
"""Height of a way."""
PLUS = 5.0
"""Half the size of the sign of a visit to a charger."""
DIAMOND = 4.5
LIT = 2.4
"""Width of the outline of what is on the critical chain."""
_THIN = 9.0
"""A bar narrower than this is lit above and below only, so that its own colour is still seen."""


def bands(row: Row, scale: Scale, place: Place) -> Iterator[str]:
    """The times in which roles hold the robot."""
    yield f'<g class="mt-tint" fill="{row.livery.hue.tint}">'
    for role in row.roles:
        left, right = scale.span(role.start_s, role.end_s)
        yield (
            f'<rect x="{n(left)}" y="{n(place.top + 2)}" width="{n(right - left)}" '
            f'height="{n(place.bottom - place.top - 4)}" rx="4"><title>{xml_safe(role.title)}</title></rect>'
        )
    yield "</g>"


def strokes(row: Row, scale: Scale, place: Place, prefix: str) -> Iterator[str]:
    """Waits, ways and actions of a row, from back to front."""
    hue = row.livery.hue
    if row.waits:
        yield f'<g class="mt-line" fill="none" stroke="{hue.deep}" stroke-width="2" stroke-dasharray="0.1 5" stroke-linecap="round">'
        for wait in row.waits:
            span = f"M{n(scale.x(wait.start_s))} {n(place.middle)} H{n(scale.x(wait.end_s))}"
            yield f'<path d="{span}"><title>{xml_safe(wait.title)}</title></path>'
        yield "</g>"
    if row.ways:
        height = min(WAY, place.bar_bottom - place.bar_top)
        yield f'<g fill="url(#{stripes(prefix, row.livery)})" stroke="{hue.deep}">'
        for way in row.ways:
            left, right = scale.span(way.start_s, way.end_s)
            yield (
                f'<rect x="{n(left)}" y="{n(place.middle - height / 2)}" width="{n(right - left)}" height="{n(height)}">'
                f"<title>{xml_safe(way.title)}</title></rect>"
            )
        yield "</g>"
    if row.refills:
        yield f'<g class="mt-paper" fill="{PAPER}" stroke="{hue.deep}" stroke-width="1.4" stroke-dasharray="3 1.6">'
        for refill in row.refills:
            left, right = scale.span(refill.start_s, refill.end_s)
            yield (
                f'<rect x="{n(left)}" y="{n(place.bar_top)}" width="{n(right - left)}" '
                f'height="{n(place.bar_bottom - place.bar_top)}" rx="2"><title>{xml_safe(refill.title)}</title></rect>'
            )
        yield "</g>"
        yield _pluses(row, scale, place)
    for thin in (False, True):  # thin ones in front
        for moves in (False, True):
            chosen = [bar for bar in row.bars if bar.moves == moves and (_width(bar, scale) < _THIN) == thin]
            yield from _bars(chosen, row, scale, place, prefix)
    yield from _lit(row, scale, place)


def _pluses(row: Row, scale: Scale, place: Place) -> str:
    """A plus in the middle of each visit to a charger, as large as there is room for."""
    marks = []
    for refill in row.refills:
        left, right = scale.span(refill.start_s, refill.end_s)
        arm = min(PLUS, (right - left) / 2 - 1.5)
        if arm > 1:
            x = (left + right) / 2
            marks.append(
                f"M{n(x - arm)} {n(place.middle)} H{n(x + arm)} M{n(x)} {n(place.middle - arm)} V{n(place.middle + arm)}"
            )
    stroke = f'stroke="{row.livery.hue.deep}" stroke-width="2"'
    return f'<path class="mt-line" d="{" ".join(marks)}" fill="none" {stroke} pointer-events="none"/>' if marks else ""


def words_of(words: Sequence[Word], row: Row, place: Place) -> Iterator[str]:
    """The words of a row; halos keep lines that pass under them off the letters."""
    hue = row.livery.hue
    halos = {"tag": hue.tint, "beside": PAPER, "in": "", "number": ""}
    for word in words:
        x, y, size = word.x, place.bar_top + word.y, word.size
        if word.bar is not None and not word.bar.moves:
            ring = hue.fill if row.livery.hatch else ""
            bold = word.spot == "number"
            yield text(x, y, word.text, size=size, fill=hue.on, kind="mt-on", anchor="middle", bold=bold, halo=ring)
        elif word.spot in {"caption", "outside"}:
            ring = hue.tint if word.spot == "caption" else PAPER
            yield text(x, y, word.text, size=size, fill=hue.deep, kind="mt-deep", halo=ring)
        elif word.spot in {"way", "aside", "held", "waiting"}:
            ring = hue.tint if word.spot in {"way", "held"} else PAPER
            yield text(x, y, word.text, size=size, fill=MUTED, kind="mt-muted", anchor="middle", halo=ring)
        else:
            bold = word.spot in {"number", "tag"}
            yield text(x, y, word.text, size=size, anchor=word.anchor, bold=bold, halo=halos[word.spot])


def stripes(prefix: str, livery: Livery) -> str:
    """Id of the pattern that ways of a hue are striped with."""
    return f"{prefix}-way-{livery.number}"


def stripe_lines(rows: Sequence[Row], prefix: str) -> Iterator[str]:
    """The striped patterns of a picture."""
    for number in sorted({row.livery.number for row in rows}):
        livery = Livery(number)
        yield (
            f'<pattern id="{stripes(prefix, livery)}" class="mt-hue-{number}" width="6" height="6" '
            f'patternUnits="userSpaceOnUse"><rect class="mt-tint" width="6" height="6" fill="{livery.hue.tint}"/>'
            f'<path class="mt-line" d="M-1 7 L7 -1 M-1 1 L1 -1 M5 7 L7 5" fill="none" stroke="{livery.hue.fill}" '
            'stroke-width="1.8"/></pattern>'
        )


def diamonds(points: Iterable[tuple[float, float]]) -> str:
    """The mark of the critical chain, at each of some points."""
    d = n(DIAMOND)
    path = " ".join(f"M{n(x)} {n(y - DIAMOND)} l{d} {d} l-{d} {d} l-{d} -{d} Z" for x, y in points)
    return f'<path class="mt-critical mt-fill" d="{path}" fill="{INK}" stroke="{PAPER}" stroke-width="1"/>'


def _width(bar: Bar, scale: Scale) -> float:
    left, right = scale.span(bar.start_s, bar.end_s)
    return right - left


def _bars(bars: Sequence[Bar], row: Row, scale: Scale, place: Place, prefix: str) -> Iterator[str]:
    """Bars of one kind, all thin or none: work in full colour, moves on paper with stripes at their foot."""
    if not bars:
        return
    moves = bars[0].moves
    look = f'class="mt-paper" fill="{PAPER}"' if moves else f'class="mt-fill" fill="{row.livery.paint(prefix)}"'
    wide = _width(bars[0], scale) >= _THIN
    dark = row.livery.hue.on == PAPER  # an edge of its own colour would part nothing
    yield f'<g {look} stroke="{PAPER if dark and wide and not moves else row.livery.hue.deep}">'
    feet = []
    foot = min(FOOT, (place.bar_bottom - place.bar_top) / 2)
    for bar in bars:
        left, right = scale.span(bar.start_s, bar.end_s)
        yield (
            f'<rect data-leaf="{bar.leaf}" x="{n(left)}" y="{n(place.bar_top)}" width="{n(right - left)}" '
            f'height="{n(place.bar_bottom - place.bar_top)}" rx="2"><title>{xml_safe(bar.title)}</title></rect>'
        )
        feet.append(
            f"M{n(left + 0.5)} {n(place.bar_bottom - foot)} H{n(right - 0.5)} v{n(foot - 0.5)} H{n(left + 0.5)} Z"
        )
    yield "</g>"
    if moves:
        yield f'<path d="{" ".join(feet)}" fill="url(#{stripes(prefix, row.livery)})" pointer-events="none"/>'


def _lit(row: Row, scale: Scale, place: Place) -> Iterator[str]:
    """What is on the critical chain: a heavy outline, and a diamond where there is room for one."""
    outlines, rails = [], []
    marks: list[float] = []
    height = min(WAY, place.bar_bottom - place.bar_top)
    spans = [(*scale.span(bar.start_s, bar.end_s), place.bar_top, place.bar_bottom) for bar in row.bars if bar.lit]
    for left, right, top, bottom in spans:
        mark = left + min(DIAMOND + 1.0, (right - left) / 2)
        if not marks or mark - marks[-1] > 2 * DIAMOND + 1.0:
            marks.append(mark)
        if right - left < _THIN:
            rails.append(f"M{n(left)} {n(top)} H{n(right)} M{n(left)} {n(bottom)} H{n(right)}")
        else:
            outlines.append(_box(left, right, top, bottom))
    for refill in row.refills:
        if refill.lit:
            outlines.append(_box(*scale.span(refill.start_s, refill.end_s), place.bar_top, place.bar_bottom))
    for way in row.ways:
        if way.lit:
            outlines.append(
                _box(*scale.span(way.start_s, way.end_s), place.middle - height / 2, place.middle + height / 2)
            )
    for path in (" ".join(outlines), " ".join(rails)):
        if path:
            yield (
                f'<path class="mt-critical mt-line" d="{path}" fill="none" stroke="{INK}" stroke-width="{n(LIT)}" '
                'stroke-linejoin="round" pointer-events="none"/>'
            )
    if marks:
        yield diamonds((x, place.bar_top) for x in marks)


def _box(left: float, right: float, top: float, bottom: float) -> str:
    return f"M{n(left)} {n(top)} H{n(right)} V{n(bottom)} H{n(left)} Z"
