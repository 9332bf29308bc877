"""Times as people read them, and the ticks of an axis."""

from __future__ import annotations

import math
from typing import NamedTuple

_BRIEF = 10.0
"""Below so many seconds, times are told to the millisecond."""
_UNITS = (("d", 86_400), ("h", 3_600), ("min", 60))


class Tick(NamedTuple):
    """A place on the axis, and what is written there."""

    time_s: float
    label: str


class Unit(NamedTuple):
    """What an axis counts in: its sign, its length in seconds, and the steps it may take, in units."""

    sign: str
    length_s: int
    steps: tuple[float, ...]


_SECONDS = Unit("s", 1, (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100))
_MINUTES = Unit("min", 60, (1, 2, 5, 10, 15, 20, 30, 60))
_HOURS = Unit("h", 3_600, (0.5, 1, 2, 3, 6, 12, 24))
_DAYS = Unit("d", 86_400, (0.5, 1))


def exact(time_s: float) -> str:
    """A time to the millisecond, the grid of schedules: ``95.5 s``, ``0.001 s``."""
    return f"{time_s:.3f}".rstrip("0").rstrip(".") + " s"


def in_words(time_s: float, least: float = 600) -> str:
    """A time for the eye: ``95.5 s`` below ten minutes, or another bound; then ``20 min 46 s``, ``5 h 12 min``, ``3 d 4 h``."""
    if time_s < max(60, least):
        return f"{time_s:.3f} s" if 0 < time_s < 0.1 else f"{time_s:.1f}".removesuffix(".0") + " s"
    if time_s > 1e9:
        return f"{time_s / 86_400:,.0f} d" if time_s < 1e12 else f"{time_s / 86_400:.3g} d"
    whole = round(time_s) if time_s < 7_200 else round(time_s / 60) * 60
    parts: list[str] = []
    for sign, length in (*_UNITS, ("s", 1)):
        if whole >= length and len(parts) < 2:
            parts.append(f"{whole // length} {sign}")
            whole %= length
        elif parts:
            break
    return " ".join(parts)


def unit_of(makespan_s: float) -> Unit:
    """What an axis of that length counts in."""
    if makespan_s < 600:
        return _SECONDS
    return _MINUTES if makespan_s < 3 * 3_600 else _HOURS if makespan_s < 3 * 86_400 else _DAYS


def span(start_s: float, end_s: float, makespan_s: float) -> str:
    """From when to when, in the unit of an axis of that length: ``0 to 5 s``, ``2:29.7 to 3:09.7 min``, ``at 1:05:00 h``."""
    unit = unit_of(makespan_s)
    if unit is _SECONDS:
        digits = 3 if makespan_s < _BRIEF else 1
        start, end = (f"{time_s:.{digits}f}".rstrip("0").rstrip(".") for time_s in (start_s, end_s))
    else:
        start, end = (_clock(time_s, hours=unit is not _MINUTES) for time_s in (start_s, end_s))
    sign = "h" if unit is _DAYS else unit.sign
    return f"{start} to {end} {sign}" if end_s > start_s else f"at {start} {sign}"


def _clock(time_s: float, *, hours: bool) -> str:
    """``2:29.7``; with hours, ``51:05:00``."""
    tenths = round(time_s * 10)
    whole, part = divmod(tenths, 10)
    minutes, seconds = divmod(whole, 60)
    tail = f"{seconds:02d}" + (f".{part}" if part else "")
    return f"{minutes // 60}:{minutes % 60:02d}:{tail}" if hours else f"{minutes}:{tail}"


def ticks(makespan_s: float, most: int) -> list[Tick]:
    """
    Ticks from 0 on, none after the makespan.

    Parameters
    ----------
    makespan_s
        Length of the axis, above 0.
    most
        How many steps there may be, at least 1; the finest steps that keep to it are taken.
    """
    unit = unit_of(makespan_s)
    step = _step(unit, makespan_s / unit.length_s / most)
    marks = int(makespan_s / (step * unit.length_s) + 1e-9)
    times = [round(number * step, 6) for number in range(marks + 1)]
    return [Tick(time * unit.length_s, f"{time:.9g} {unit.sign}" if time else "0") for time in times]


def _step(unit: Unit, least: float) -> float:
    """The shortest step of a unit that is long enough; beyond its own ones, 2, 5 and 10 times the longest, and so on."""
    for step in unit.steps:
        if step >= least - 1e-12:
            return step
    decade = unit.steps[-1] * 10.0 ** math.floor(math.log10(least / unit.steps[-1]))
    return next(step for step in (decade, 2 * decade, 5 * decade, 10 * decade, 20 * decade) if step >= least)
