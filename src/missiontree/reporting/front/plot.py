"""The front as a picture: makespan to the right, utility up, a point per option, and a step from each to the next."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from missiontree.mission.plan import Plan
from missiontree.reporting.front.rows import front_in_words, listed_rank, rows_of
from missiontree.reporting.gantt.time import in_words
from missiontree.reporting.palette import HAIR, HUES, INK, MUTED, PAPER, QUIET
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.svg_page import opening, text
from missiontree.reporting.text_box import text_width

SIZE = 11.0
LEFT, RIGHT, TOP, BOTTOM = 70.0, 570.0, 44.0, 284.0
WIDTH, HEIGHT = 600.0, 372.0
MARK = 6.0
_KEYS = 338.0
_STEPS = (1.0, 2.0, 5.0)


@dataclass(frozen=True, slots=True)
class Scale:
    """
    A scale from numbers to pixels.

    Parameters
    ----------
    low, high
        Numbers at its ends.
    start, end
        Where these stand.
    """

    low: float
    high: float
    start: float
    end: float

    def at(self, number: float) -> float:
        """Place of a number."""
        return self.start + (number - self.low) / (self.high - self.low) * (self.end - self.start)

    def marks(self, most: int) -> list[float]:
        """Round numbers on the scale, at most so many steps apart."""
        least = (self.high - self.low) / most
        power = 10.0 ** math.floor(math.log10(least))
        step = next(one * power for one in (*_STEPS, 10.0) if one * power >= least * (1 - 1e-9))
        first, last = math.ceil(self.low / step - 1e-9), math.floor(self.high / step + 1e-9)
        return [number * step for number in range(first, last + 1)]


def front_svg(plan: Plan) -> str | None:
    """
    The picture; None if the plan has no front.

    A filled point is proven: nothing is better in both. A hollow one was found. Crosses are listed alternatives that are not on the front.
    """
    rows = rows_of(plan)
    if plan.front is None or not rows:
        return None
    points = [(option.schedule.makespan_s, option.alternative.utility) for option in plan.front.options]
    others = list(_others(plan))
    times = _scale([time for time, _ in points + others], LEFT, RIGHT)
    worths = _scale([worth for _, worth in points + others], BOTTOM, TOP)
    words = "; ".join(f"{row.number}: utility {row.utility}, {in_words(row.makespan_s)}, {row.known}" for row in rows)
    parts = [
        opening(
            WIDTH,
            HEIGHT,
            "From the best staffed to the fastest plan",
            f"{front_in_words(plan.front)}. {words}.",
            "front",
        )
    ]
    parts += _axes(plan, times, worths)
    parts += (_cross(times.at(time), worths.at(worth)) for time, worth in others)
    parts.append(_stairs(points, times, worths))
    for row, (time, worth) in zip(rows, points, strict=True):
        parts += _point(times.at(time), worths.at(worth), str(row.number), row.known == "proven", row.chosen)
    parts += _keys(rows_known={row.known for row in rows}, crosses=bool(others), chosen=any(row.chosen for row in rows))
    parts.append("</svg>\n")
    return "\n".join(parts)


def _others(plan: Plan) -> Iterator[tuple[float, float]]:
    """Makespan and utility of listed alternatives that are not on the front."""
    assert plan.front is not None
    on_it = {listed_rank(plan, option.alternative) for option in plan.front.options}
    lasts = {one.rank: one.makespan_s for one in plan.schedules if one.status in {"optimal", "feasible"}}
    for alternative in plan.ranking.alternatives if plan.ranking is not None else ():
        if alternative.rank not in on_it and alternative.rank in lasts:
            yield lasts[alternative.rank], alternative.utility


def _scale(numbers: Sequence[float], start: float, end: float) -> Scale:
    low, high = min(numbers), max(numbers)
    room = 0.1 * (high - low) or 0.1 * abs(high) or 1.0
    return Scale(low - room, high + room, start, end)


def _axes(plan: Plan, times: Scale, worths: Scale) -> Iterator[str]:
    for worth in worths.marks(6):
        y = worths.at(worth)
        yield f'<path class="mt-hair" d="M{n(LEFT)} {n(y)} H{n(RIGHT)}" stroke="{HAIR}" stroke-width="1"/>'
        yield text(LEFT - 8, y + 4, f"{worth:.9g}", size=SIZE, fill=MUTED, kind="mt-muted", anchor="end")
    beyond = LEFT
    for time in times.marks(7):
        x, label = times.at(time), in_words(round(time, 6))
        yield f'<path class="mt-hair" d="M{n(x)} {n(TOP)} V{n(BOTTOM)}" stroke="{HAIR}" stroke-width="1"/>'
        half = text_width(label, SIZE) / 2
        if x - half > beyond - half and time >= 0:
            yield text(x, BOTTOM + 17, label, size=SIZE, fill=MUTED, kind="mt-muted", anchor="middle")
            beyond = x + half + 14
    d = f"M{n(LEFT)} {n(TOP)} V{n(BOTTOM)} H{n(RIGHT)}"
    yield f'<path class="mt-line" d="{d}" stroke="{INK}" stroke-width="1.5" fill="none"/>'
    yield text(LEFT, TOP - 16, f"{plan.brief.aim.worth}, higher is better staffed", size=SIZE, bold=True)
    yield text(RIGHT, BOTTOM + 36, "makespan, shorter to the left", size=SIZE, anchor="end", bold=True)


def _stairs(points: Sequence[tuple[float, float]], times: Scale, worths: Scale) -> str:
    """What can be had: from an option, less utility alone gains nothing until the next, which is faster."""
    places = [(times.at(time), worths.at(worth)) for time, worth in points]
    (x, y), *rest = places
    d = f"M{n(RIGHT)} {n(y)} H{n(x)}" + "".join(f" V{n(below)} H{n(left)}" for left, below in rest)
    return f'<path d="{d} V{n(BOTTOM)}" stroke="{HUES[0].fill}" stroke-width="1.5" stroke-dasharray="4 3" fill="none"/>'


def _point(x: float, y: float, number: str, proven: bool, chosen: bool) -> Iterator[str]:
    hue = HUES[0]
    if chosen:
        yield _ring(x, y)
    yield (
        f'<circle cx="{n(x)}" cy="{n(y)}" r="{n(MARK)}" fill="{hue.fill if proven else PAPER}" '
        f'stroke="{hue.fill}" stroke-width="2"/>'
    )
    yield text(x + MARK + 5, y - MARK - 1, number, size=SIZE + 1, fill=hue.deep, bold=True, halo=PAPER)


def _ring(x: float, y: float) -> str:
    return f'<circle cx="{n(x)}" cy="{n(y)}" r="{n(MARK + 4.5)}" stroke="{INK}" stroke-width="1.5" fill="none" class="mt-line"/>'


def _cross(x: float, y: float) -> str:
    d = f"M{n(x - 4)} {n(y - 4)} L{n(x + 4)} {n(y + 4)} M{n(x - 4)} {n(y + 4)} L{n(x + 4)} {n(y - 4)}"
    return f'<path d="{d}" stroke="{QUIET}" stroke-width="1.5" fill="none"/>'


def _keys(rows_known: set[str], crosses: bool, chosen: bool) -> Iterator[str]:
    x, y, hue = LEFT, _KEYS + 14, HUES[0]
    for known, fill, words in (
        ("proven", hue.fill, "proven: nothing is better in both"),
        ("found", PAPER, "found, not proven"),
    ):
        if known in rows_known:
            yield f'<circle cx="{n(x)}" cy="{n(y - 4)}" r="5" fill="{fill}" stroke="{hue.fill}" stroke-width="2"/>'
            yield text(x + 11, y, words, size=SIZE, fill=MUTED, kind="mt-muted")
            x += text_width(words, SIZE) + 30
    if chosen:
        yield f'<circle cx="{n(x)}" cy="{n(y - 4)}" r="6" stroke="{INK}" stroke-width="1.5" fill="none" class="mt-line"/>'
        yield text(x + 11, y, "chosen", size=SIZE, fill=MUTED, kind="mt-muted")
        x += text_width("chosen", SIZE) + 30
    if crosses:
        yield _cross(x, y - 4)
        yield text(x + 11, y, "other listed alternatives", size=SIZE, fill=MUTED, kind="mt-muted")
