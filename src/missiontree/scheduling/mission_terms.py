"""What holds for a mission as a whole: what all its robots share, how many of a type are in use, and who must take part."""

from __future__ import annotations

from collections.abc import Mapping

from missiontree.mission.fleet import Fleet
from missiontree.mission.reason import Reason
from missiontree.mission.terms import Terms
from missiontree.scheduling.impossible import TOLERANCE
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.staffing import Staffing

Shared = Mapping[str, float]
"""What all robots together may use, by name of the budget."""


def shared_by_all(fleet: Fleet, terms: Terms) -> dict[str, float]:
    """The tighter of the fleet's total and the scene's stock, by name."""
    names = dict.fromkeys((*fleet.total_limits, *terms.stock))
    return {name: min(limits[name] for limits in (fleet.total_limits, terms.stock) if name in limits) for name in names}


def shared_exceeded(needs: Mapping[int, Mapping[str, float]], shared: Shared) -> list[Reason]:
    """What all robots share and is too little even if every approach costs nothing."""
    reasons = []
    for name, there in shared.items():
        needed = sum(need.get(name, 0.0) for need in needs.values())
        if needed > there + TOLERANCE:
            reasons.append(
                Reason(
                    rule="budget_exceeded",
                    message=f"The mission needs at least {needed:g} of {name}; all robots together may use {there:g}.",
                    found=f"{name} {there:g}",
                    needed=f"{name} {needed:g}",
                )
            )
    return reasons


def required_in_vain(staffing: Staffing, fleet: Fleet, terms: Terms) -> list[Reason]:
    """Types that must take part and have fewer groups of roles than robots of them must."""
    robots = terms.required_robots(fleet)
    reasons = []
    for type_id in terms.required_by_type(fleet):
        asked = max(1, len({robot for robot in robots if fleet.type_of[robot].id == type_id}))
        groups = {staffing.group_of[role] for role, kind in staffing.type_of.items() if kind == type_id}
        if len(groups) < asked:
            reasons.append(_idle(type_id, f"{len(groups)} roles", f"{asked} roles"))
    return reasons


def terms_broken(problem: Problem, robots: Mapping[int, str]) -> tuple[Reason, ...]:
    """Why these robots, by role, do not keep the terms; empty if they do."""
    busy = set(robots.values())
    reasons = [_idle(robot, "no role", "at least one role") for robot in problem.required if robot not in busy]
    for kind in problem.fleet.types:
        used = sum(robot.id in busy for robot in kind.members) if kind.max_in_use is not None else 0
        if used > kind.usable:
            reasons.append(
                Reason(
                    rule="max_in_use_exceeded",
                    message=f"{used} robots of type {kind.label!r} would be in use, and at most {kind.usable} may be.",
                    robot=kind.id,
                    found=f"{used} robots",
                    needed=f"at most {kind.usable}",
                )
            )
    return tuple(reasons)


def _idle(name: str, found: str, needed: str) -> Reason:
    return Reason(
        rule="required_idle",
        message=f"{name} must take part, and finds too little to do: {found} instead of {needed}.",
        robot=name,
        found=found,
        needed=needed,
    )
