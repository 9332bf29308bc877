"""The schedule as a table: what a chart cannot tell those who do not see it, and what hands want to have exact."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass

from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule
from missiontree.reporting.html.times import at, lasts
from missiontree.reporting.timeline.view import timeline_rows

MOST_ROWS = 250


@dataclass(frozen=True, slots=True)
class Line:
    """
    A stretch of a robot's time.

    Parameters
    ----------
    start, end, lasts
        From when to when, and how long.
    text
        What is done.
    moving
        Whether it is travel.
    """

    start: str
    end: str
    lasts: str
    text: str
    moving: bool


@dataclass(frozen=True, slots=True)
class Timetable:
    """
    Robots with their lines, and how many lines are left out.

    Parameters
    ----------
    robots
        Name and lines, in the order of the fleet, as in the chart; strangers to it come last, by name.
    more
        How many lines are not listed.
    """

    robots: tuple[tuple[str, tuple[Line, ...]], ...]
    more: int


def timetable(plan: Plan, schedule: Schedule) -> Timetable:
    """The lines of a schedule, robot by robot, each in order of time."""
    places = {robot: place for place, robot in enumerate(plan.brief.fleet.robots)}
    rows = sorted(
        timeline_rows(schedule, plan),
        key=lambda row: (places.get(row.robot, len(places)), row.robot, row.start_s, row.end_s),
    )
    end = schedule.makespan_s
    by_robot: dict[str, list[Line]] = defaultdict(list)
    for row in rows[:MOST_ROWS]:
        by_robot[row.robot].append(
            Line(at(row.start_s, end), at(row.end_s, end), lasts(row.end_s - row.start_s), row.text, row.moving)
        )
    return Timetable(tuple((robot, tuple(lines)) for robot, lines in by_robot.items()), max(0, len(rows) - MOST_ROWS))
