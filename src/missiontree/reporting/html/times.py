"""Times as one page writes them: alike in all of its parts, whatever their size."""

from __future__ import annotations

from missiontree.reporting.clock import LONG_S, clock
from missiontree.reporting.gantt.time import in_words


def at(time_s: float, makespan_s: float) -> str:
    """A point in time of a schedule: ``95.5 s``; ``1:02:03`` in one of ten minutes or more."""
    return f"{time_s:.1f} s" if makespan_s < LONG_S else clock(time_s)


def between(start_s: float, end_s: float, makespan_s: float) -> str:
    """From when to when: ``5.0 – 95.5 s``, ``0:00:05 – 1:02:03``."""
    return f"{at(start_s, makespan_s).removesuffix(' s')} – {at(end_s, makespan_s)}"


def lasts(duration_s: float) -> str:
    """How long something takes: ``95.5 s``, ``20 min 46 s``, ``5 h 12 min``."""
    return in_words(duration_s)
