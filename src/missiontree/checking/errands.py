"""What robots travel for their own sake, not for an action, told from where they are: to chargers, and home."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from missiontree.checking.case import Case
from missiontree.checking.clock import tick
from missiontree.checking.journeys import Spot, final_stands, start_spot, visits
from missiontree.checking.timetable import Timetable
from missiontree.mission.fleet import RobotType
from missiontree.mission.schedule import OwnLeg


class Errand(NamedTuple):
    """
    A robot's travel for its own sake, as it must be.

    ``origins`` are the spots where it may be before; they and ``goal`` are None where they are not known. ``free_from`` is when what it
    did before ended, in ticks, and ``until`` when it must be there; None if it need not be at any time. ``leg`` is what the schedule has
    for it.
    """

    robot: str
    what: str
    origins: tuple[Spot, ...]
    goal: Spot
    free_from: int
    until: int | None
    leg: OwnLeg | None


class Run(NamedTuple):
    """An errand whose leg stands in the schedule of a timetable, by a robot of a type."""

    timetable: Timetable
    errand: Errand
    leg: OwnLeg
    robot_type: RobotType


def errands(case: Case, timetable: Timetable) -> Iterator[Errand]:
    """Every errand of a schedule."""
    for step in visits(case, timetable):
        visit = step.visit
        what = f"its way to the charger {visit.charger}"
        yield Errand(visit.robot, what, step.origins, step.goal, step.free_from, tick(visit.start_s), visit.leg)
    if case.plan.brief.return_home:
        yield from returns(case, timetable)


def returns(case: Case, timetable: Timetable) -> Iterator[Errand]:
    """The way home of every robot that does something."""
    legs: dict[str, OwnLeg] = {}
    for leg in timetable.schedule.returns:
        legs.setdefault(leg.robot, leg)
    for robot, (spots, free_from) in final_stands(case, timetable).items():
        home = start_spot(case, case.fleet.robots.get(robot))
        yield Errand(robot, "its way home", spots, home, free_from, None, legs.get(robot))


def runs(case: Case) -> Iterator[Run]:
    """Errands that are made, by robots that there are."""
    for timetable in case.timetables:
        for errand in errands(case, timetable):
            kind = case.fleet.type_of.get(errand.robot)
            if errand.leg is not None and kind is not None:
                yield Run(timetable, errand, errand.leg, kind)


def home_at(case: Case, timetable: Timetable) -> dict[str, int]:
    """When robots that return are home, in ticks, by robot."""
    return {
        errand.robot: errand.free_from if errand.leg is None else tick(errand.leg.end_s)
        for errand in (returns(case, timetable) if case.plan.brief.return_home else ())
    }
