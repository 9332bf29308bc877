"""Does every robot, every robot type, and the mission keep within its budgets by what is truly used?"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping

from missiontree.checking.case import Case
from missiontree.checking.fault import Fault
from missiontree.checking.levels import allowance
from missiontree.checking.timetable import Timetable

Use = dict[tuple[str, str], float]
"""Amount used by robot, or robot type, and name of the budget."""


def budget_exceeded(case: Case) -> Iterator[Fault]:
    """A robot uses more of a budget than it has: for its actions and for every metre that it travels."""
    for timetable in case.timetables:
        for (robot, name), used in sorted(used_by_robot(case, timetable).items()):
            left = allowance(case, robot, name)
            if left is not None and beyond(used, left):
                yield Fault(
                    f"schedule {timetable.schedule.rank}: {robot} uses {used:g} of {name} and has {left:g}.",
                    robot=robot,
                    found=f"{name} {used:g}",
                    needed=f"{name} at most {left:g}",
                )


def total_budget_exceeded(case: Case) -> Iterator[Fault]:
    """The robots of a type together use more of a budget than the type has."""
    for timetable in case.timetables:
        totals: Use = defaultdict(float)
        for (robot, name), used in used_by_robot(case, timetable).items():
            totals[case.fleet.type_of[robot].id, name] += used
        for (type_id, name), used in sorted(totals.items()):
            left = case.fleet.by_id[type_id].total_limits.get(name)
            if left is not None and beyond(used, left):
                yield Fault(
                    f"schedule {timetable.schedule.rank}: the robots of type {type_id} use {used:g} of {name} and have {left:g}.",
                    robot=type_id,
                    found=f"{name} {used:g}",
                    needed=f"{name} at most {left:g}",
                )


def mission_budget_exceeded(case: Case) -> Iterator[Fault]:
    """All robots together use more of a budget than the fleet may for the whole mission."""
    yield from _beyond_shared(case, case.fleet.total_limits, "all robots of the fleet")


def stock_exceeded(case: Case) -> Iterator[Fault]:
    """All robots together take more of something than the scene has in stock."""
    yield from _beyond_shared(case, case.scene.stock, "all robots, from the stock of the scene,")


def _beyond_shared(case: Case, limits: Mapping[str, float], who: str) -> Iterator[Fault]:
    for timetable in case.timetables if limits else ():
        used: dict[str, float] = defaultdict(float)
        for (_, name), amount in used_by_robot(case, timetable).items():
            used[name] += amount
        for name, left in sorted(limits.items()):
            if beyond(used[name], left):
                yield Fault(
                    f"schedule {timetable.schedule.rank}: {who} use {used[name]:g} of {name} and may use {left:g}.",
                    found=f"{name} {used[name]:g}",
                    needed=f"{name} at most {left:g}",
                )


def used_by_robot(case: Case, timetable: Timetable) -> Use:
    """What every robot of the fleet uses of every budget in a schedule."""
    used: Use = defaultdict(float)
    for deed in timetable.deeds.values():
        for name, amount in deed.action.uses.items():
            used[deed.robot, name] += amount
    for leg in timetable.schedule.ways:
        kind = case.fleet.type_of.get(leg.robot)
        for name, per_m in kind.uses_per_m.items() if kind is not None else ():
            used[leg.robot, name] += per_m * leg.distance_m
    return {key: amount for key, amount in used.items() if key[0] in case.fleet.robots}


def beyond(used: float, left: float) -> bool:
    """Whether an amount is above a budget by more than what sums of decimals carry."""
    return used > left + 1e-6 + 1e-9 * abs(left)
