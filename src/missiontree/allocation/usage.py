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

    Parameters
    ----------
    flat
        The problem.
    """

    def __init__(self, flat: Flat) -> None:
        self._flat = flat
        self._limited = bool(flat.shared) or any(stock.totals or any(stock.budgets) for stock in flat.stocks.values())

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
        flat, by_type, by_robot = self._flat, _Amounts(), _Amounts()
        for leaf in leaves:
            for name, amount in flat.uses[leaf].items():
                key = flat.robot_type[leaf], name
                by_type[key] = by_type.get(key, 0) + amount
                if robots:
                    key = robots[flat.role[leaf]], name
                    by_robot[key] = by_robot.get(key, 0) + amount
        return (*self._of_types(by_type, by_robot), *self._of_the_mission(by_type))

    def _of_types(self, by_type: _Amounts, by_robot: _Amounts) -> Iterator[LimitUse]:
        used_of: dict[str, list[str]] = {}
        for type_id, name in sorted(by_type):
            used_of.setdefault(type_id, []).append(name)
        for type_id, stock in self._flat.stocks.items():
            names = used_of.get(type_id, ())
            for robot, budget in zip(stock.robots, stock.budgets, strict=True) if names and by_robot else ():
                for name in names:
                    if name in budget and (robot, name) in by_robot:
                        yield _use("robot", robot, name, by_robot[robot, name], budget[name])
            for name in names:
                allowed = _added_up(stock, name)
                if not by_robot and allowed is not None:
                    yield _use("robots", type_id, name, by_type[type_id, name], allowed)
            for name in names:
                if name in stock.totals:
                    yield _use("type", type_id, name, by_type[type_id, name], stock.totals[name])

    def _of_the_mission(self, by_type: _Amounts) -> Iterator[LimitUse]:
        for name, shared in self._flat.shared.items():
            used = sum(by_type.get((type_id, name), 0) for type_id in self._flat.stocks)
            if used:
                yield _use("stock" if shared.source == "scene" else "mission", "", name, used, shared.limit)


def _added_up(stock: Stock, name: str) -> int | None:
    """What as many robots as may take part have of a budget together; None if some robot is not limited."""
    if not all(name in budget for budget in stock.budgets):
        return None
    return sum(nlargest(stock.usable, (budget[name] for budget in stock.budgets)))


def _use(whose: Whose, who: str, name: str, used: int, limit: int) -> LimitUse:
    return LimitUse(whose, who, name, used / AMOUNT_SCALE, limit / AMOUNT_SCALE)
