"""A limit, and what a schedule makes of it."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.reporting.html.quantity import number, share
from missiontree.reporting.svg_numbers import n
from missiontree.reporting.team.limits import LimitUse


@dataclass(frozen=True, slots=True)
class Used:
    """
    A limit beside what is used or needed of it.

    Parameters
    ----------
    who
        Robot, or robot type if all of its robots count together.
    name
        The limit, its unit in the name.
    used, allowed
        Both in that unit.
    why
        What needs it; empty if it is used up by everything the robot does.
    filled
        Used of allowed, from 0 to 1, for the eye.
    percent
        The same for the reader.
    bar
        The same of a bar 80 units long.
    """

    who: str
    name: str
    used: str
    allowed: str
    why: str
    filled: float
    percent: str
    bar: str


def spent(limit: LimitUse) -> Used:
    """The row of a limit that is spent by all that robots do."""
    return used_of(limit.who, limit.name, limit.used, limit.allowed)


def used_of(who: str, name: str, used: float, allowed: float, why: str = "") -> Used:
    """The row of a limit."""
    filled = min(1.0, used / allowed) if allowed > 0 else float(used > 0)
    return Used(who, name, number(used), number(allowed), why, filled, share(used, allowed), n(80 * filled))
