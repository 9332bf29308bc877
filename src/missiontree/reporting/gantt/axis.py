"""The axis of a Gantt chart: ticks with their units, hairlines down the chart, and where the mission ends."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.reporting.gantt.layout import BOLD, Scale
from missiontree.reporting.gantt.time import Tick, in_words, ticks
from missiontree.reporting.palette import HAIR, INK, MUTED
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.svg_page import text
from missiontree.reporting.text_box import text_width

SIZE = 11.0
HEIGHT = 24.0
_APART = 22.0


def end_width(makespan_s: float) -> float:
    """Width of the words at the end of the axis."""
    return text_width(in_words(makespan_s), SIZE) * BOLD


def hairlines(scale: Scale, top: float, bottom: float) -> Iterator[str]:
    """A hairline down the chart at every tick."""
    for tick in _marks(scale):
        x = n(scale.x(tick.time_s))
        yield f'<path class="mt-hair" d="M{x} {n(top)} V{n(bottom)}" stroke="{HAIR}" stroke-width="1"/>'


def end_line(scale: Scale, top: float, bottom: float) -> str:
    """A line where the mission ends."""
    x = n(scale.right)
    return f'<path class="mt-line" d="M{x} {n(top)} V{n(bottom)}" stroke="{INK}" stroke-width="1.5" fill="none"/>'


def labels(scale: Scale, baseline: float) -> Iterator[str]:
    """Times at the ticks and at the end; what would touch the end is left out."""
    half = end_width(scale.makespan_s) / 2
    yield text(scale.right, baseline, in_words(scale.makespan_s), size=SIZE, anchor="middle", bold=True)
    for tick in _marks(scale):
        x, own = scale.x(tick.time_s), text_width(tick.label, SIZE) / 2
        if x + own + 6 < scale.right - half:
            yield text(x, baseline, tick.label, size=SIZE, fill=MUTED, kind="mt-muted", anchor="middle")


def _marks(scale: Scale) -> list[Tick]:
    wide = scale.right - scale.left
    for most in range(max(1, int(wide / 48)), 1, -1):
        found = ticks(scale.makespan_s, most)
        widest = max(text_width(tick.label, SIZE) for tick in found)
        if len(found) < 2 or scale.x(found[1].time_s) - scale.left >= widest + _APART:
            return found
    return ticks(scale.makespan_s, 1)
