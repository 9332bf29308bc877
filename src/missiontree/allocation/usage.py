"""What an alternative uses of every limit, beside what is allowed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from heapq import nlargest

from missiontree.allocation.flat import AMOUNT_SCALE, Flat, Stock
from missiontree.mission.limit_use import LimitUse, Whose

_Amounts = dict[tuple[str, str], int]  # billionths, by robot or robot type and name of the budget


class Usage:
    """
    Tells what alternatives of one problem use.

    Alternatives of one ranking differ in few leaves, so what a type uses is counted on from the alternative before.

    Parameters
    ----------
    flat
        The problem.
    """

    def __init__(self, flat: Flat) -> None:
        self._flat = flat
        self._limited = bool(flat.shared) or any(stock.totals or any(stock.budgets) for stock in flat.stocks.values())
        self._several = frozenset(who for who, stock in flat.stocks.items() if len(stock.robots) > 1)
        self._leaves: set[int] = set()
        self._by_type: _Amounts = {}

    def of(self, leaves: Iterable[int], robots: Mapping[int, str]) -> tuple[LimitUse, ...]:
        """
        Every limit of which something is used, type by type, and at last those of the mission.

        Parameters
        ----------
        leaves
            The selected leaves.
        robots
            Robot by role. Without any, since nobody could say who does what, the robots of a type are told of together.
        """
        if not self._limited:
            return ()
        now, before = set(leaves), self._leaves
        self._count(now - before, 1)
        self._count(before - now, -1)
        self._leaves = now
        by_robot = self._by_robot(now, robots) if robots else None
        return (*self._of_types(by_robot), *self._of_the_mission(self._by_type))

    def _count(self, leaves: Iterable[int], sign: int) -> None:
        uses, robot_type, by_type = self._flat.uses, self._flat.robot_type, self._by_type
        for leaf in leaves:
            for name, amount in uses[leaf].items():
                key = robot_type[leaf], name
                by_type[key] = by_type.get(key, 0) + sign * amount

    def _by_robot(self, leaves: Iterable[int], robots: Mapping[int, str]) -> _Amounts:
        """What each robot uses; the only robot of a type uses what its type does."""
        flat, several, found = self._flat, self._several, _Amounts()
        for leaf in leaves if several else ():
            if flat.robot_type[leaf] in several:
                for name, amount in flat.uses[leaf].items():
                    key = robots[flat.role[leaf]], name
                    found[key] = found.get(key, 0) + amount
        for (type_id, name), amount in self._by_type.items():
            if type_id not in several:
                found[flat.stocks[type_id].robots[0], name] = amount
        return found

    def _of_types(self, by_robot: _Amounts | None) -> Iterator[LimitUse]:
        used_of: dict[str, list[str]] = {}
        for (type_id, name), used in sorted(self._by_type.items()):
            if used:
                used_of.setdefault(type_id, []).append(name)
        for type_id, stock in self._flat.stocks.items():
            names = used_of.get(type_id, ())
            if by_robot is not None:
                yield from _of_robots(stock, names, by_robot)
            for name in names:
                allowed = _added_up(stock, name) if by_robot is None else None
                if allowed is not None:
                    yield _use("robots", type_id, name, self._by_type[type_id, name], allowed)
            for name in names:
                if name in stock.totals:
                    yield _use("type", type_id, name, self._by_type[type_id, name], stock.totals[name])

    def _of_the_mission(self, by_type: _Amounts) -> Iterator[LimitUse]:
        for name, shared in self._flat.shared.items():
            used = sum(by_type.get((type_id, name), 0) for type_id in self._flat.stocks)
            if used:
                yield _use("stock" if shared.source == "scene" else "mission", "", name, used, shared.limit)


def _of_robots(stock: Stock, names: Iterable[str], by_robot: _Amounts) -> Iterator[LimitUse]:
    for robot, budget in zip(stock.robots, stock.budgets, strict=True) if names else ():
        for name in names:
            if name in budget and (used := by_robot.get((robot, name), 0)):
                yield _use("robot", robot, name, used, budget[name])


def _added_up(stock: Stock, name: str) -> int | None:
    """What as many robots as may take part have of a budget together; None if some robot is not limited."""
    if not all(name in budget for budget in stock.budgets):
        return None
    return sum(nlargest(stock.usable, (budget[name] for budget in stock.budgets)))


def _use(whose: Whose, who: str, name: str, used: int, limit: int) -> LimitUse:
    return LimitUse(whose, who, name, used / AMOUNT_SCALE, limit / AMOUNT_SCALE)
