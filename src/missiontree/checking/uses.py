"""Is what alternatives use of limits what their actions use whatever happens, and is no limit passed over?"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping

from missiontree.checking.budgets import beyond
from missiontree.checking.case import Case
from missiontree.checking.fault import Fault
from missiontree.checking.levels import allowance
from missiontree.checking.staffing import Staffing
from missiontree.mission.limit_use import LimitUse

NEGLIGIBLE = 1e-6

_Limit = tuple[str, str, str]  # whose, who, name


def limit_use_missing(case: Case) -> Iterator[Fault]:
    """An alternative uses something of a limit and does not say so."""
    for staffing in case.staffings:
        said = {_limit(use) for use in staffing.alternative.uses}
        for limit, (used, most) in _uses(case, staffing).items():
            if used > NEGLIGIBLE and limit not in said:
                yield Fault(
                    f"alternative {staffing.alternative.rank} uses {used:g} of {most:g} {limit[2]} {_named(limit)}, and does not say so.",
                    robot=limit[1],
                    found="nothing said",
                    needed=f"{limit[2]} {used:g} of {most:g}",
                )


def limit_use_wrong(case: Case) -> Iterator[Fault]:
    """An alternative says that something is used of a limit that is not there, or twice, or other amounts than its actions give."""
    for staffing in case.staffings:
        uses = _uses(case, staffing)
        times = Counter(_limit(use) for use in staffing.alternative.uses)
        for use in staffing.alternative.uses:
            limit = _limit(use)
            used, most = uses.get(limit, (0.0, 0.0))
            if limit in uses and times[limit] == 1 and _equal(use.used, used) and _equal(use.limit, most):
                continue
            needed = f"{use.name} {used:g} of {most:g}, once" if limit in uses else "no such limit"
            yield Fault(
                f"alternative {staffing.alternative.rank} says that it uses {use.used:g} of {use.limit:g} {use.name} "
                f"{_named(limit)}; there it is {needed}.",
                robot=use.who,
                found=f"{use.name} {use.used:g} of {use.limit:g}",
                needed=needed,
            )


def _limit(use: LimitUse) -> _Limit:
    return use.whose, use.who, use.name


def _named(limit: _Limit) -> str:
    whose, who, _ = limit
    return {"mission": "of the whole mission", "stock": "in stock"}.get(whose, f"of {who}")


def _equal(one: float, other: float) -> bool:
    return not beyond(one, other) and not beyond(other, one)


def _uses(case: Case, staffing: Staffing) -> dict[_Limit, tuple[float, float]]:
    """What is used, above nothing, and what may be, by limit; damaged references are left to the rules on them."""
    robots = {entry.role: entry.robot for entry in staffing.alternative.witness if entry.robot in case.fleet.robots}
    by_type: dict[tuple[str, str], float] = defaultdict(float)
    by_robot: dict[tuple[str, str], float] = defaultdict(float)
    for action in staffing.actions.values():
        if action.robot_type in case.fleet.by_id:
            for name, amount in action.uses_at_least.items():
                by_type[action.robot_type, name] += amount
                if action.role in robots:
                    by_robot[robots[action.role], name] += amount
    found = dict(_of_robots(case, by_robot) if staffing.alternative.witness else _added_up(case, by_type))
    for (type_id, name), used in by_type.items():
        if name in case.fleet.by_id[type_id].total_limits:
            found["type", type_id, name] = used, case.fleet.by_id[type_id].total_limits[name]
    found.update(_of_the_mission(case, by_type))
    return {limit: (used, most) for limit, (used, most) in found.items() if used > 0}


def _of_robots(case: Case, by_robot: Mapping[tuple[str, str], float]) -> Iterator[tuple[_Limit, tuple[float, float]]]:
    for (robot, name), used in by_robot.items():
        most = allowance(case, robot, name)
        if most is not None:
            yield ("robot", robot, name), (used, most)


def _added_up(case: Case, by_type: Mapping[tuple[str, str], float]) -> Iterator[tuple[_Limit, tuple[float, float]]]:
    """What robots have each, of as many as may be in use, those that have most."""
    for (type_id, name), used in by_type.items():
        each = [allowance(case, robot.id, name) for robot in case.at_hand(type_id)]
        known = sorted((most for most in each if most is not None), reverse=True)
        if len(known) == len(each):
            yield ("robots", type_id, name), (used, sum(known[: case.most_in_use(type_id)]))


def _of_the_mission(
    case: Case, by_type: Mapping[tuple[str, str], float]
) -> Iterator[tuple[_Limit, tuple[float, float]]]:
    """The total of the fleet, or else the stock of the scene where it is tighter."""
    used: dict[str, float] = defaultdict(float)
    for (_, name), amount in by_type.items():
        used[name] += amount
    totals, stock = case.fleet.total_limits, case.scene.stock
    for name, amount in used.items():
        if name in totals and not (name in stock and stock[name] < totals[name]):
            yield ("mission", "", name), (amount, totals[name])
        elif name in stock:
            yield ("stock", "", name), (amount, stock[name])
