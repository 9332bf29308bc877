"""Points in time of a schedule of ten minutes and more, as a clock shows them."""

from __future__ import annotations

LONG_S = 600.0
"""From this length on, a schedule is told by the clock; a shorter one in seconds."""


def clock(time_s: float) -> str:
    """Hours, minutes and whole seconds: ``0:15:12``."""
    whole = round(time_s)
    return f"{whole // 3600}:{whole // 60 % 60:02d}:{whole % 60:02d}"
