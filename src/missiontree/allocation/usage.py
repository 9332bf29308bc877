"""What an alternative uses of every limit that binds its robots, beside what is allowed."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import NamedTuple

from missiontree.allocation.flat import AMOUNT_SCALE, EVERYBODY, Flat
from missiontree.mission.alternative import Alternative

_Amounts = Counter[tuple[str, str]]  # billionths, by robot or robot type and name of the budget


class Use(NamedTuple):
    """
    A limit beside what is used of it, both in the limit's own unit.

    Parameters
    ----------
    who
        The robot, or the robot type where all its robots are meant; empty where all robots of the mission are.
    together
        Whether all robots of the type, or of the mission, are meant.
    name
        Name of the budget.
    used, allowed
        Amounts, at least 0.
    """

    who: str
    together: bool
    name: str
    used: float
    allowed: float

    @property
    def share(self) -> float:
        """Used of allowed; 1 for something of nothing."""
        return self.used / self.allowed if self.allowed else float(self.used > 0)


def uses_of(flat: Flat, alternative: Alternative) -> tuple[Use, ...]:
    """
    Every limit of the robots in the tree, the unused ones too, type by type, and at last those of the mission.

    Robots are those of the witness. An alternative without one, since nobody could say who does what, is told of by type: all
    robots together, against the sum of what they have.
    """
    robots = {filled.role: filled.robot for filled in alternative.witness}
    by_robot, by_type = _Amounts(), _Amounts()
    for leaf in _leaves(flat, alternative) if any(flat.uses) else ():
        for name, amount in flat.uses[leaf].items():
            by_type[flat.robot_type[leaf], name] += amount
            if robots:
                by_robot[robots[flat.role[leaf]], name] += amount
    who_is_known = bool(robots) or not by_type
    told = _one_by_one(flat, by_robot, by_type) if who_is_known else _all_together(flat, by_type)
    return (*told, *_of_the_mission(flat, by_type))


def _leaves(flat: Flat, alternative: Alternative) -> Iterator[int]:
    taken = {choice.xor: choice.child for choice in alternative.choices}
    stack = [0]
    while stack:
        node = stack.pop()
        if flat.kind[node] == "action":
            yield node
        elif flat.kind[node] == "and":
            stack.extend(flat.children[node])
        else:
            stack.append(taken[node])


def _one_by_one(flat: Flat, by_robot: _Amounts, by_type: _Amounts) -> Iterator[Use]:
    for type_id, stock in flat.stocks.items():
        for robot, budget in zip(stock.robots, stock.budgets, strict=True):
            for name, allowed in budget.items():
                yield _use(robot, False, name, by_robot[robot, name], allowed)
        for name, allowed in stock.totals.items():
            yield _use(type_id, True, name, by_type[type_id, name], allowed)


def _all_together(flat: Flat, by_type: _Amounts) -> Iterator[Use]:
    for type_id, stock in flat.stocks.items():
        for name in dict.fromkeys(name for limited in (*stock.budgets, stock.totals) for name in limited):
            allowed = stock.pooled(name)
            if allowed is not None:
                yield _use(type_id, True, name, by_type[type_id, name], allowed)


def _of_the_mission(flat: Flat, by_type: _Amounts) -> Iterator[Use]:
    for name, shared in flat.shared.items():
        used = sum(by_type[type_id, name] for type_id in flat.stocks)
        yield _use(EVERYBODY, True, name, used, shared.limit)


def _use(who: str, together: bool, name: str, used: int, allowed: int) -> Use:
    return Use(who, together, name, used / AMOUNT_SCALE, allowed / AMOUNT_SCALE)
