"""Seconds and ticks of one millisecond, as the checker reads them."""

from __future__ import annotations

import math

TICKS_PER_S = 1000
TOLERANCE = 1
"""Ticks by which two times may differ and still count as equal."""

_END_OF_TIME_S = 1e12


def tick(seconds: float) -> int:
    """The nearest tick; times beyond 30,000 years count as that, so that nothing overflows."""
    return round(min(seconds, _END_OF_TIME_S) * TICKS_PER_S)


def ticks_needed(seconds: float) -> int:
    """Whole ticks that a duration takes, rounded up; a millionth of a tick is taken as rounding noise."""
    return math.ceil(min(seconds, _END_OF_TIME_S) * TICKS_PER_S - 1e-6)


def on_grid(seconds: float) -> bool:
    """Whether a time is a whole number of ticks."""
    return seconds > _END_OF_TIME_S or abs(seconds - tick(seconds) / TICKS_PER_S) <= 1e-9 * max(1.0, seconds)


def shown(ticks: int) -> str:
    """A time for people: ``12.5 s``."""
    return f"{ticks / TICKS_PER_S:g} s"
