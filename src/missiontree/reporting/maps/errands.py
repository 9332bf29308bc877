"""What robots travel for their own sake, as stops on the map."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.schedule import OwnLeg, Schedule
from missiontree.reporting.visits import visits_of


@dataclass(frozen=True, slots=True)
class Errand:
    """
    A stop of a robot that is no action.

    Parameters
    ----------
    leg
        The way there; None if the robot is there already.
    spot
        Where.
    start_s, end_s
        From when to when it has something to do there.
    text
        What.
    """

    leg: OwnLeg | None
    spot: Position
    start_s: float
    end_s: float
    text: str


def errands_of(plan: Plan, schedule: Schedule) -> dict[str, tuple[Errand, ...]]:
    """Errands of every robot that has some, in order of time."""
    found: dict[str, list[Errand]] = {}
    for visits in visits_of(plan, schedule).values():
        for visit in visits:
            one, spot = visit.recharge, plan.brief.world.charger_spots.get(visit.recharge.charger)
            if spot is not None:
                errand = Errand(one.leg, spot, one.start_s, one.end_s, visit.text)
                found.setdefault(one.robot, []).append(errand)
    for leg in schedule.returns:
        found.setdefault(leg.robot, []).append(Errand(leg, leg.destination, leg.end_s, leg.end_s, "be home"))
    return {robot: tuple(sorted(own, key=lambda one: one.start_s)) for robot, own in found.items()}
