"""Seconds and the integers that allocators and schedulers count in. The only place where time is rounded."""

from __future__ import annotations

import math

TICKS_PER_S = 1000
_NOISE = 1e-6  # of a tick: what sums such as 0.1 + 0.2 carry beyond the number meant


def ticks(duration_s: float) -> int:
    """
    A duration in ticks of 1 ms, rounded up.

    Parameters
    ----------
    duration_s
        Seconds, at least 0. Float noise above a whole tick (0.1 + 0.2 is meant as 0.3) does not cost a tick more.
    """
    exact = duration_s * TICKS_PER_S
    return math.ceil(exact - max(_NOISE, exact * 1e-12))


def ticks_within(deadline_s: float) -> int:
    """
    The last tick that is no later than a deadline: rounded down.

    Parameters
    ----------
    deadline_s
        Seconds, at least 0. Float noise below a whole tick does not cost a tick.
    """
    exact = deadline_s * TICKS_PER_S
    return math.floor(exact + max(_NOISE, exact * 1e-12))


def seconds(count: int) -> float:
    """Ticks as seconds."""
    return count / TICKS_PER_S
