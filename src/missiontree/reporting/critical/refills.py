"""Detours to chargers, as stretches between two things that a robot does."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from missiontree.mission.schedule import Schedule
from missiontree.reporting.critical.spans import ms

Stretches = Mapping[str, Sequence[tuple[int, int]]]
"""By robot: from when to when, in milliseconds, each from the departure for a charger to the end of the last visit in a row."""


def refills_of(schedule: Schedule) -> dict[str, list[tuple[int, int]]]:
    """The detours of a schedule, visits with nothing between them as one."""
    found: dict[str, list[tuple[int, int]]] = {}
    for visit in sorted(schedule.recharges, key=lambda one: (one.robot, one.start_s)):
        own = found.setdefault(visit.robot, [])
        since = ms(visit.leg.start_s if visit.leg is not None else visit.start_s)
        if own and own[-1][1] == since:
            own[-1] = (own[-1][0], ms(visit.end_s))
        else:
            own.append((since, ms(visit.end_s)))
    return found
