"""What alternatives with their schedules come to by each objective, as the checker counts it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

from missiontree.checking.case import WORKING
from missiontree.checking.clock import TICKS_PER_S, tick
from missiontree.checking.ranking import MILLION, millionths
from missiontree.checking.staffing import Staffing
from missiontree.mission.alternative import Alternative
from missiontree.mission.estimate import Weights
from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule

NO_END = 1 << 60
"""A tick that no schedule has."""


@dataclass(frozen=True, slots=True)
class Merit:
    """
    An alternative with what is known of its schedules.

    Parameters
    ----------
    alternative, schedule
        The two.
    utility
        In millionths.
    makespan
        In ticks; None if nothing is scheduled.
    least
        Ticks below which its certificate says that no schedule is; more than any time if it is called infeasible.
    """

    alternative: Alternative
    schedule: Schedule
    utility: int
    makespan: int | None
    least: int

    @property
    def tidiness(self) -> tuple[int, int]:
        """Millimetres of travel, and the sum of all ends."""
        metres = sum(leg.distance_m for leg in self.schedule.ways)
        return round(metres * 1000), sum(tick(done.end_s) for done in self.schedule.actions)


def merit_of(alternative: Alternative, schedule: Schedule) -> Merit:
    """An alternative and its schedule, read."""
    works = schedule.status in WORKING
    bound = schedule.certificate.bound
    least = 0 if bound is None else tick(bound)
    if schedule.status == "infeasible":
        least = NO_END
    elif schedule.status == "optimal":
        least = tick(schedule.makespan_s)
    makespan = tick(schedule.makespan_s) if works else None
    return Merit(alternative, schedule, round(alternative.utility * MILLION), makespan, least)


def listed(plan: Plan) -> list[Merit]:
    """The alternatives of the ranking, with their schedules."""
    by_rank = {schedule.rank: schedule for schedule in plan.schedules}
    alternatives = plan.ranking.alternatives if plan.ranking is not None else ()
    return [merit_of(one, by_rank[one.rank]) for one in alternatives if one.rank in by_rank]


def known(plan: Plan) -> list[Merit]:
    """The alternatives of the ranking and the options of the front that have a schedule."""
    options = plan.front.options if plan.front is not None else ()
    everything = listed(plan) + [merit_of(option.alternative, option.schedule) for option in options]
    return [one for one in everything if one.makespan is not None]


def timeless_worth(plan: Plan, alternative: Alternative) -> Fraction | None:
    """What quality and cost of the selected actions come to, in millionths; None if there is no tree, or that is no number."""
    if plan.grounding is None:
        return None
    weights = plan.brief.weights
    timeless = Weights(weights.alpha, 0.0, weights.gamma)
    actions = Staffing(plan.grounding.tree, plan.tree, alternative).actions.values()
    counted = [millionths(timeless, action.estimate) for action in actions]
    return sum(map(Fraction, counted), Fraction(0)) if all(map(math.isfinite, counted)) else None


def of_a_tick(plan: Plan) -> Fraction:
    """What a tick takes away, in millionths."""
    return Fraction(plan.brief.weights.beta) * MILLION / TICKS_PER_S


def weighted_worth(plan: Plan, merit: Merit) -> Fraction | None:
    """Alpha * q - beta * d - gamma * c in millionths, d being the time that the objective of the mission counts; None as above."""
    timeless = timeless_worth(plan, merit.alternative)
    if timeless is None or plan.grounding is None:
        return None
    time = merit.makespan or 0
    if plan.brief.objective == "weighted-sum":
        nodes = plan.grounding.tree.nodes
        actions = {done.leaf: nodes[done.leaf].action for done in merit.schedule.actions if done.leaf < len(nodes)}
        time = sum(tick(done.end_s) - tick(done.start_s) for done in merit.schedule.actions)
        errands = [leg for leg in merit.schedule.ways if leg not in merit.schedule.legs]
        time += sum(tick(leg.end_s) - tick(leg.start_s) for leg in errands)
        for leg in merit.schedule.legs:
            action = actions.get(leg.leaf)
            if action is not None and not action.moves:  # the leg of a move is the move
                time += tick(leg.end_s) - tick(leg.start_s)
    return timeless - of_a_tick(plan) * time


def may_beat(one: Merit, other: Merit) -> bool:
    """Whether what is known leaves room for a schedule of one that beats the other in utility or makespan, and is no worse in both."""
    makespan = other.makespan or 0
    better = one.utility > other.utility and one.least <= makespan
    return better or (one.utility >= other.utility and one.least < makespan)
