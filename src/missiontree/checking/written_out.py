"""Do all alternatives of a small tree, written out, bear out that nothing beats a front or a choice?"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from missiontree.checking.case import Case
from missiontree.checking.clock import tick
from missiontree.checking.enumeration import best_first
from missiontree.checking.merits import (
    NO_END,
    Merit,
    listed,
    may_beat,
    merit_of,
    of_a_tick,
    timeless_worth,
    weighted_worth,
)
from missiontree.checking.ranking import MILLION, utility_of
from missiontree.checking.soonest import soonest_end
from missiontree.mission.front import Option
from missiontree.mission.plan import Plan

Covers = Callable[[Plan, Sequence[Merit], Merit], bool]
"""Whether another alternative cannot beat these, whatever its schedule is."""


def written_out(case: Case, options: Sequence[Option], covers: Covers) -> bool:
    """
    Whether the checker itself sees that nothing beats the options.

    Of alternatives that the plan lists it takes what their schedules claim; of all others it takes its own bound, by which nobody is
    short of robots and approaches take no time.
    """
    anyone = replace(case.plan, brief=replace(case.plan.brief, diverse=False))
    merits = [merit_of(option.alternative, option.schedule) for option in options]
    known = {frozenset((c.xor, c.child) for c in one.alternative.choices): one for one in (*merits, *listed(case.plan))}
    truth = Case(anyone)
    for staffing in best_first(truth):
        if staffing is None:
            return False
        one = known.get(frozenset(staffing.taken.items()))
        if one is None:
            utility = round(utility_of(staffing, case.plan.brief))
            bare = replace(merits[0].alternative, choices=staffing.alternative.choices, utility=utility / MILLION)
            one = Merit(bare, merits[0].schedule, utility, None, soonest_end(truth, staffing))
        if not covers(case.plan, merits, one):
            return False
    return True


def covers_front(plan: Plan, options: Sequence[Merit], one: Merit) -> bool:
    """Some option is at least as good in both; or nothing is scheduled."""
    return one.least >= NO_END or any(
        option.utility >= one.utility and (option.makespan or 0) <= one.least for option in options
    )


def covers_choice(plan: Plan, options: Sequence[Merit], one: Merit) -> bool:
    """The choice is at least as good by the objective."""
    chosen = options[0]
    if one.least >= NO_END:
        return True
    if plan.brief.objective == "makespan":
        return one.least >= tick(chosen.schedule.makespan_s) and not may_beat(one, chosen)
    if plan.brief.objective == "utility-makespan":
        return one.utility <= chosen.utility and not may_beat(one, chosen)
    timeless, worth = timeless_worth(plan, one.alternative), weighted_worth(plan, chosen)
    if plan.brief.objective == "weighted-sum" or timeless is None or worth is None:
        return False
    return timeless - of_a_tick(plan) * one.least <= worth
