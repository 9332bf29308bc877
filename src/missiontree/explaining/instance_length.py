"""
Why the schedule of an instance from elsewhere is as long as it is, and which robot would shorten it: answered by scheduling it anew.

Like :mod:`missiontree.explaining.shortening`, of trees and coalitions that choose while they are scheduled: with one more robot another
way may be taken.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace

from missiontree.explaining.added import not_tried, verdict_of, worth
from missiontree.instances import Instance, schedule_instance
from missiontree.mission.chain import Addition, WhySoLong
from missiontree.mission.coalitions import MOST_COALITION_ROBOTS, CoalitionMission
from missiontree.mission.control import Control
from missiontree.mission.plan import Plan
from missiontree.reporting.critical.chain import chain_of

MOST_TRIED = 12
"""Robots, or types of equal ones, of which one more is tried: those that the chain names most often first."""

FULL = f"No further robot was tried: a mission of coalitions has {MOST_COALITION_ROBOTS} at most."


def instance_length(plan: Plan, instance: Instance, control: Control, *, solver: bool = True) -> WhySoLong:
    """
    Why a schedule of an instance is as long as it is, and which robot would shorten it.

    Parameters
    ----------
    plan
        The schedule as a plan (:func:`missiontree.instances.plan_of_instance`).
    instance
        What it is a schedule of.
    control
        How long all scheduling may take, and who may stop it.
    solver
        Whether CP-SAT may be asked. Default true.
    """
    schedule = plan.schedules[0]
    why = WhySoLong(chain=chain_of(plan, schedule))
    if not why.chain.steps:
        return why
    asked = list(_larger(plan, instance, why))
    found: list[Addition] = []
    for place, (robot, larger) in enumerate(asked):
        if control.ended():
            break
        anew = schedule_instance(larger, control.part(1 / (len(asked) - place)), solver=solver)
        found.append(
            Addition(
                robots={robot: 1},
                verdict=verdict_of(anew, schedule.makespan_s),
                status=anew.status,
                makespan_s=float(anew.makespan_s),
                certificate=anew.certificate,
            )
        )
    untried = not_tried(len(asked) - len(found)) if asked else FULL
    return replace(why, additions=tuple(sorted(found, key=worth)), untried=untried)


def _larger(plan: Plan, instance: Instance, why: WhySoLong) -> Iterator[tuple[str, Instance]]:
    """The instance with one more robot, and which one that is."""
    named = Counter(plan.brief.fleet.type_of[step.robot].id for step in why.chain.steps)
    kinds = [kind.id for kind in plan.brief.fleet.types]
    for kind in sorted(kinds, key=lambda kind: -named[kind])[:MOST_TRIED]:
        number = kinds.index(kind)
        if not isinstance(instance, CoalitionMission):
            count = [1] * instance.robots if instance.count is None else list(instance.count)
            count[number] += 1
            yield kind, replace(instance, count=count)
        elif len(instance.skills) < MOST_COALITION_ROBOTS:
            yield kind, replace(instance, skills=(*instance.skills, instance.skills[number]))
