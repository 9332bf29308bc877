"""Two plans side by side in words: what one is worth, when it ends, and who does what otherwise."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from missiontree.mission.alternative import Alternative
from missiontree.mission.objective import Objective
from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule
from missiontree.mission.why_not import Moved, Verdict

WORKING = ("optimal", "feasible")
TICK_S = 0.001
MILLIONTH = 1e-6
MOST_MOVED = 12


def best_of(plan: Plan) -> tuple[Alternative, Schedule] | None:
    """What the objective of the mission chooses, else the best alternative that has a schedule, with it."""
    if plan.chosen is not None:
        return plan.chosen.option.alternative, plan.chosen.option.schedule
    if plan.ranking is None:
        return None
    for alternative, schedule in zip(plan.ranking.alternatives, plan.schedules, strict=False):
        if schedule.status in WORKING:
            return alternative, schedule
    return None


def named(plan: Plan, alternative: Alternative) -> str:
    """What an alternative is called that stands for the plan."""
    return "what is chosen" if plan.chosen is not None else f"alternative {alternative.rank}"


def verdict_of(
    utility: float, other: float, ends_s: float, other_ends_s: float, objective: Objective = "utility"
) -> Verdict:
    """How another plan stands to the plan: by utility and then by makespan, or the other way round if the objective is makespan."""
    if objective == "makespan" and abs(other_ends_s - ends_s) > TICK_S:
        return "later" if other_ends_s > ends_s else "sooner"
    if other < utility - MILLIONTH:
        return "worse"
    if other > utility + MILLIONTH:
        return "better"
    if other_ends_s > ends_s + TICK_S:
        return "later"
    return "sooner" if other_ends_s < ends_s - TICK_S else "as_good"


def side_by_side(utility: float, other: float, ends_s: float, other_ends_s: float, worth: str = "utility") -> str:
    """Utility and makespan of another plan beside those of the plan, as a part of a sentence."""
    change, later = other - utility, other_ends_s - ends_s
    valued = f"{worth} {other:g}" + (
        f" instead of {utility:g} ({abs(change):g} {'less' if change < 0 else 'more'})"
        if abs(change) > MILLIONTH
        else " as before"
    )
    ends = f"it ends after {other_ends_s:.1f} s" + (
        f" instead of {ends_s:.1f} s ({abs(later):.1f} s {'later' if later > 0 else 'sooner'})"
        if abs(later) > TICK_S
        else " as before"
    )
    return f"{valued}; {ends}"


def moved_in_words(moved: Sequence[Moved]) -> Iterator[str]:
    """A line for each task that is done otherwise."""
    for one in moved[:MOST_MOVED]:
        yield f"{one.task}: {_change(one)}{_worth(one.utility_change)}."
    if len(moved) > MOST_MOVED:
        yield f"{len(moved) - MOST_MOVED} more tasks are done otherwise."


def _change(one: Moved) -> str:
    if not one.before:
        return f"done as well, by {one.after}"
    if not one.after:
        return f"not done ({one.before} did it)"
    return f"{one.after} instead of {one.before}"


def _worth(change: float) -> str:
    return "" if abs(change) < MILLIONTH else f", utility {'+' if change > 0 else '−'}{abs(change):g}"
