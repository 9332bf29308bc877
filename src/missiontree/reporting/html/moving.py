"""What the page's script is told: where everybody is when, and what they do, for every alternative that can be chosen."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule
from missiontree.reporting.escape import one_line
from missiontree.reporting.maps.motion import motion


def moving(plan: Plan, ranks: Sequence[int]) -> dict[str, Any]:
    """Motion by rank, as :meth:`missiontree.reporting.maps.motion.Motion.plain` has it; without a map, only who does what when."""
    told: dict[str, Any] = {}
    for rank in ranks:
        schedule = next((one for one in plan.schedules if one.rank == rank and one.makespan_s > 0), None)
        if schedule is not None:
            on_map = motion(plan, rank)
            told[str(rank)] = on_map.plain() if on_map is not None else _doings(plan, schedule)
    return told


def _doings(plan: Plan, schedule: Schedule) -> dict[str, Any]:
    """Every robot with what it does, in the form of a motion in which nobody has a place."""
    assert plan.grounding is not None
    doings: dict[str, list[list[Any]]] = {}
    for entry in sorted(schedule.actions, key=lambda one: (one.start_s, one.end_s, one.leaf)):
        text = one_line(plan.grounding.tree.action(entry.leaf).text)
        doings.setdefault(entry.robot, []).append([_ms(entry.start_s), _ms(entry.end_s), text])
    return {
        "rank": schedule.rank,
        "end": _ms(schedule.makespan_s),
        "movers": [{"id": robot, "frames": [], "doings": done} for robot, done in doings.items()],
    }


def _ms(time_s: float) -> int:
    return round(time_s * 1000)
