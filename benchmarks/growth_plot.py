"""How cost grows, as a picture: seconds over leaves and over robots, both axes in powers of ten."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from math import ceil, floor, log10

from benchmarks.growth import Grown, Point, Series, fitted
from missiontree.reporting.palette import HAIR, HUES, INK, MUTED, PAPER
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.svg_page import opening, text

SIZE = 11.0
WIDTH = 770.0
TOP, BOTTOM, LEFT, BETWEEN, PANEL = 40.0, 290.0, 62.0, 66.0, 300.0
KEYS, ROW, NOTE = (
    44.0,
    18.0,
    12.0,
)  # below the panels: to the first line of the key, from one to the next, before the last line
POWERS = "⁰¹²³⁴⁵⁶⁷⁸⁹"
MARK = 3.5
UNPROVEN = "Hollow: the limit was reached before the proof; no exponent is fitted from there on."


@dataclass(frozen=True, slots=True)
class Scale:
    """
    A logarithmic scale.

    Parameters
    ----------
    low, high
        Powers of ten at the ends.
    start, end
        Where these stand, in pixels.
    """

    low: int
    high: int
    start: float
    end: float

    def at(self, number: float) -> float:
        """Place of a number."""
        return self.start + (log10(number) - self.low) / (self.high - self.low) * (self.end - self.start)

    def powers(self) -> range:
        """Powers of ten that are marked."""
        return range(self.low, self.high + 1)


def scale(numbers: Iterable[float], start: float, end: float) -> Scale:
    """The scale from the power of ten below all numbers to the one above; two powers at least."""
    logs = [log10(number) for number in numbers]
    low = floor(min(logs))
    return Scale(low, max(ceil(max(logs)), low + 1), start, end)


def growth_svg(points: Grown) -> str:
    """The picture."""
    seconds = scale((p.seconds for measured in points.values() for p in measured), BOTTOM, TOP)
    title = "Cost of the 10 best alternatives as the work grows"
    words = "; ".join(
        f"over {series.over}, {series.words}: {_exponent(series, measured)}" for series, measured in points.items()
    )
    rows = max(Counter(series.over for series in points).values())
    unproven = not all(p.proven for measured in points.values() for p in measured)
    height = BOTTOM + KEYS + ROW * rows + (NOTE + ROW if unproven else 0.0)
    parts = [opening(WIDTH, height, title, f"Seconds on logarithmic scales. {words}.", "growth")]
    parts.append(text(LEFT - 8, 20, "time", size=SIZE, fill=MUTED, kind="mt-muted", anchor="end"))
    for place, over in enumerate(("leaves", "robots")):
        chosen = {series: measured for series, measured in points.items() if series.over == over}
        if chosen:
            parts += _panel(chosen, over, seconds, LEFT + place * (PANEL + BETWEEN))
    if unproven:
        parts.append(text(LEFT, height - ROW, UNPROVEN, size=SIZE, fill=MUTED, kind="mt-muted"))
    parts.append("</svg>\n")
    return "\n".join(parts)


def _panel(chosen: Grown, over: str, seconds: Scale, left: float) -> Iterator[str]:
    sizes = scale((p.size for measured in chosen.values() for p in measured), left, left + PANEL)
    yield from _axes(sizes, seconds, over)
    for place, (series, measured) in enumerate(chosen.items()):
        hue = HUES[place]
        fit = fitted(series, measured)
        if fit is not None:
            ends = [p.size for p in measured if p.proven and p.size >= series.fitted_from]
            yield _fit_line(fit, min(ends), max(ends), sizes, seconds, hue.fill)
        yield _way(measured, sizes, seconds, hue.fill)
        for p in measured:
            fill = hue.fill if p.proven else PAPER
            yield (
                f'<circle cx="{n(sizes.at(p.size))}" cy="{n(seconds.at(p.seconds))}" r="{n(MARK)}" '
                f'fill="{fill}" stroke="{hue.fill}" stroke-width="1.5"/>'
            )
        yield from _key(
            f"{series.words}: {_exponent(series, measured)}", left, BOTTOM + KEYS + ROW * place, hue.fill, hue.deep
        )


def _axes(sizes: Scale, seconds: Scale, over: str) -> Iterator[str]:
    for power in seconds.powers():
        y = seconds.at(10.0**power)
        yield f'<path class="mt-hair" d="M{n(sizes.start)} {n(y)} H{n(sizes.end)}" stroke="{HAIR}" stroke-width="1"/>'
        yield text(sizes.start - 8, y + 4, _duration(power), size=SIZE, fill=MUTED, kind="mt-muted", anchor="end")
    for power in sizes.powers():
        x = sizes.at(10.0**power)
        yield f'<path class="mt-hair" d="M{n(x)} {n(TOP)} V{n(BOTTOM)}" stroke="{HAIR}" stroke-width="1"/>'
        yield text(x, BOTTOM + 17, _power(power), size=SIZE, fill=MUTED, kind="mt-muted", anchor="middle")
    d = f"M{n(sizes.start)} {n(TOP)} V{n(BOTTOM)} H{n(sizes.end)}"
    yield f'<path class="mt-line" d="{d}" stroke="{INK}" stroke-width="1.5" fill="none"/>'
    yield text((sizes.start + sizes.end) / 2, 20, f"over {over}", size=SIZE, anchor="middle", bold=True)


def _way(measured: Sequence[Point], sizes: Scale, seconds: Scale, colour: str) -> str:
    d = " L".join(f"{n(sizes.at(p.size))} {n(seconds.at(p.seconds))}" for p in measured)
    return f'<path d="M{d}" stroke="{colour}" stroke-width="1" fill="none"/>'


def _fit_line(fit: tuple[float, float], first: int, last: int, sizes: Scale, seconds: Scale, colour: str) -> str:
    exponent, factor = fit
    ends = ((size, factor * size**exponent) for size in (first, last))
    d = " L".join(f"{n(sizes.at(size))} {n(seconds.at(value))}" for size, value in ends)
    return f'<path d="M{d}" stroke="{colour}" stroke-width="4" stroke-opacity="0.25" fill="none"/>'


def _key(words: str, left: float, y: float, colour: str, deep: str) -> Iterator[str]:
    yield f'<circle cx="{n(left + MARK)}" cy="{n(y - 4)}" r="{n(MARK)}" fill="{colour}" stroke="{colour}" stroke-width="1.5"/>'
    yield text(left + 14, y, words, size=SIZE, fill=deep)


def _exponent(series: Series, measured: Sequence[Point]) -> str:
    fit = fitted(series, measured)
    return "no exponent" if fit is None else f"exponent {fit[0]:.2f}"


def _power(power: int) -> str:
    """A power of ten: 1, 10, and above these with the exponent raised."""
    return str(10**power) if power in {0, 1} else "10" + "".join(POWERS[int(digit)] for digit in str(power))


def _duration(power: int) -> str:
    """A power of ten of seconds, as people say it: 10 µs, 0.1 ms, 1 ms, 0.1 s, 1,000 s."""
    if power >= -1:
        return f"{10.0**power:,g} s"
    return f"{10.0 ** (power + 3):,g} ms" if power >= -4 else f"{10.0 ** (power + 6):,g} µs"
