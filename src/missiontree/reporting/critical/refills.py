"""Detours to chargers, as stretches between two things that a robot does."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from missiontree.mission.schedule import Schedule
from missiontree.reporting.critical.spans import ms

Stretches = Mapping[str, Sequence[tuple[int, int]]]
"""By robot: from when to when, in milliseconds, each up to the end of the last visit in a row."""


def refills_of(schedule: Schedule) -> dict[str, list[tuple[int, int]]]:
    """
    The detours of a schedule, visits with nothing but waits between them as one.

    A wait for room on the way to a charger belongs to the detour: it begins with the end of what the robot did before, if it did anything.
    """
    ends: dict[str, list[int]] = {}
    for done in schedule.actions:
        ends.setdefault(done.robot, []).append(ms(done.end_s))
    found: dict[str, list[tuple[int, int]]] = {}
    for visit in sorted(schedule.recharges, key=lambda one: (one.robot, one.start_s)):
        own = found.setdefault(visit.robot, [])
        leaves = ms(visit.leg.start_s if visit.leg is not None else visit.start_s)
        over = max((end for end in ends.get(visit.robot, ()) if end <= leaves), default=None)
        if own and (over is None or over <= own[-1][0]):
            own[-1] = (own[-1][0], ms(visit.end_s))
        else:
            own.append((leaves if over is None else over, ms(visit.end_s)))
    return found
