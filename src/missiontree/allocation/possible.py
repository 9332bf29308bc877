"""
Which nodes can be done at all, by one sweep from the leaves up.

An XOR needs a possible child, an AND needs all of them. On top of that, what a node uses *at least*, whatever is chosen below
it, must not exceed what there is: a sum at an AND, a minimum over the possible children at an XOR. The least use is kept per
type, per role (which one robot fills), over all types that are limited, and for the mission; it never refuses a node that some
feasible alternative selects. Neither does what refuses nodes that cannot meet their deadline (:mod:`soonest`). And where a type that
must take part finds too few roles whatever is chosen, the mission is impossible.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import islice

from missiontree.allocation.flat import AMOUNT_SCALE, Flat
from missiontree.allocation.soonest import TooLate, reasons_of_lateness, strike_late
from missiontree.allocation.turnout import turnouts
from missiontree.allocation.wording import Holder, of_all_robots, of_one_robot, of_the_mission, of_types, type_idle
from missiontree.mission.reason import Reason, Severity

MISSION = "*"  # stands for all robots in a purse that the mission limits, as "" does in the sum of what types have
Purse = tuple[
    str, int, str
]  # robot type ("" or MISSION for all of them), role (-1 for all of them), name of the budget

_NOTHING: dict[
    Purse, int
] = {}  # stands for parts that use nothing; nobody writes into it, for it is never the largest of unequal ones


@dataclass(frozen=True, slots=True)
class Excess:
    """A node that uses more than there is, whatever is chosen below it."""

    node: int
    purse: Purse
    needed: int
    found: int


@dataclass(frozen=True, slots=True)
class Possibility:
    """
    What the sweep found.

    Parameters
    ----------
    possible
        Per node, whether some alternative could select it.
    excesses
        Nodes refused because of budgets, children before parents.
    idle
        Types that must take part and find too few roles, with how many they find at most.
    late
        Nodes refused because of deadlines, children before parents.
    """

    possible: Sequence[bool]
    excesses: list[Excess] = field(default_factory=list)
    idle: Mapping[str, int] = field(default_factory=dict)
    late: Sequence[TooLate] = ()


def structurally_possible(flat: Flat) -> list[bool]:
    """Which nodes can be done if budgets, teams and links are left aside."""
    possible = [True] * len(flat.kind)
    for node in range(len(flat.kind) - 1, -1, -1):
        if flat.kind[node] == "xor":
            possible[node] = any(possible[child] for child in flat.children[node])
        elif flat.kind[node] == "and":
            possible[node] = all(possible[child] for child in flat.children[node])
    return possible


def possible_nodes(flat: Flat) -> Possibility:
    """Which nodes can be done with what the robots may use, and with everybody who must take part."""
    possible = structurally_possible(flat)
    found = Possibility(possible, late=strike_late(flat, possible))
    if not any(flat.uses):
        return _with_required(flat, found)
    limits = _Limits(flat)
    least: dict[int, dict[Purse, int]] = {}
    for node in range(len(flat.kind) - 1, -1, -1):
        below = [least.pop(child, _NOTHING) for child in flat.children[node] if possible[child]]
        if flat.kind[node] == "action":
            use, touched = limits.charge(node), None
        elif flat.kind[node] == "and":
            possible[node] = len(below) == len(flat.children[node])
            use, touched = _sum(below) if possible[node] else ({}, None)
        else:
            possible[node] = bool(below)
            use, touched = _minimum(below), set[Purse]()  # a minimum is no larger than what passed below
        if not possible[node]:
            continue
        if (excess := limits.excess(node, use, touched)) is not None:
            possible[node] = False
            found.excesses.append(excess)
        elif use:
            least[node] = use
    return _with_required(flat, found)


def _with_required(flat: Flat, found: Possibility) -> Possibility:
    """Nothing is possible if a type that must take part finds too few roles, whatever is chosen."""
    if not flat.required or not found.possible[0]:
        return found
    idle = {turnout.type_id: turnout.most[0] for turnout in turnouts(flat, found.possible) if turnout.spare < 0}
    return replace(found, possible=[False] * len(flat.kind), idle=idle) if idle else found


def _sum(parts: list[dict[Purse, int]]) -> tuple[dict[Purse, int], set[Purse]]:
    """The sum, written into the largest part, and the purses whose sum has more than one term."""
    if not parts:
        return {}, set()
    largest = max(range(len(parts)), key=lambda index: len(parts[index]))
    total, touched = parts[largest], set()
    for index, part in enumerate(parts):
        if index != largest:
            for purse, used in part.items():
                if purse in total:
                    touched.add(purse)
                total[purse] = total.get(purse, 0) + used
    return total, touched


def _minimum(parts: list[dict[Purse, int]]) -> dict[Purse, int]:
    if len(parts) == 1:
        return parts[0]
    smallest = min(parts, key=len, default={})
    return {purse: min(part[purse] for part in parts) for purse in smallest if all(purse in part for part in parts)}


class _Limits:
    """How much each purse holds."""

    def __init__(self, flat: Flat) -> None:
        self.flat = flat
        self.pooled: dict[tuple[str, str], int | None] = {}
        self.largest: dict[tuple[str, str], int | None] = {}
        self.everywhere: dict[str, int] = {}
        self._known: dict[Purse, int | None] = {}
        self._leaves_of = Counter(role for role, uses in zip(flat.role, flat.uses, strict=True) if uses)
        used = {(flat.robot_type[leaf], name) for leaf, uses in enumerate(flat.uses) for name in uses}
        for type_id, name in sorted(used):
            stock = flat.stocks[type_id]
            self.pooled[type_id, name] = stock.pooled(name)
            self.largest[type_id, name] = stock.largest(name)
            self.everywhere[name] = self.everywhere.get(name, 0) + (self.pooled[type_id, name] or 0)
        self._of_all = {key: self._purses_of_all(*key) for key in used}

    def charge(self, leaf: int) -> dict[Purse, int]:
        """
        What a leaf takes from whom.

        Of one robot in its role it is told only if other leaves share the role, or if it is too much already: else it adds up with
        nothing.
        """
        type_id, role = self.flat.robot_type[leaf], self.flat.role[leaf]
        charged: dict[Purse, int] = {}
        for name, used in self.flat.uses[leaf].items():
            largest = self.largest[type_id, name]
            if largest is not None and (used > largest or self._leaves_of[role] > 1):
                charged[type_id, role, name] = used
            for purse in self._of_all[type_id, name]:
                charged[purse] = used
        return charged

    def _purses_of_all(self, type_id: str, name: str) -> tuple[Purse, ...]:
        """Those that robots of the type fill together, with others or without."""
        of_types: tuple[Purse, ...] = ((type_id, -1, name), ("", -1, name))
        of_mission: tuple[Purse, ...] = ((MISSION, -1, name),)
        pooled = self.pooled[type_id, name] is not None
        return (of_types if pooled else ()) + (of_mission if name in self.flat.shared else ())

    def excess(self, node: int, use: Mapping[Purse, int], touched: set[Purse] | None) -> Excess | None:
        over = [
            purse
            for purse in (use if touched is None else touched)
            if (limit := self._held(purse)) is not None and use[purse] > limit
        ]
        if not over:
            return None
        # One type's purse first: what a single type lacks is not to be told of all types together.
        first = min(over, key=lambda purse: (purse[0] in {"", MISSION}, purse))
        return Excess(node, first, use[first], self._known[first] or 0)

    def _held(self, purse: Purse) -> int | None:
        if purse not in self._known:
            type_id, role, name = purse
            if not type_id:
                self._known[purse] = self.everywhere[name]
            elif type_id == MISSION:
                self._known[purse] = self.flat.shared[name].limit
            else:
                self._known[purse] = (self.pooled if role < 0 else self.largest)[type_id, name]
        return self._known[purse]


def reasons_of(flat: Flat, possibility: Possibility, severity: Severity, limit: int = 8) -> tuple[Reason, ...]:
    """Who must take part in vain, and the refusals nearest to the root in words: one per budget and type, one per deadline."""
    said: dict[tuple[str, str], Reason] = {
        (type_id, ""): type_idle(type_id, flat.required[type_id], severity, roles)
        for type_id, roles in possibility.idle.items()
    }
    for excess in reversed(possibility.excesses):
        type_id, _, name = excess.purse
        if (type_id, name) in said or len(said) == limit:
            continue
        holder = _holder(flat, excess.purse)
        needed, there = excess.needed / AMOUNT_SCALE, excess.found / AMOUNT_SCALE
        said[type_id, name] = Reason(
            rule="budget_exceeded",
            severity=severity,
            message=f'Whatever is chosen, "{flat.label[excess.node]}" uses {needed:g} of {name}, and {holder.whose} may use {there:g}.',
            node=flat.label[excess.node],
            robot="" if type_id == MISSION else type_id,
            found=f"{name} {there:g}",
            needed=f"{name} {needed:g}",
            hint=holder.remedy,
        )
    return (*said.values(), *islice(reasons_of_lateness(flat, possibility.late, severity), limit))


def _holder(flat: Flat, purse: Purse) -> Holder:
    type_id, role, name = purse
    if type_id == MISSION:
        return of_the_mission(name, flat.shared[name])
    if type_id:
        return (of_one_robot if role >= 0 else of_all_robots)(type_id, flat.stocks[type_id], name)
    users = {flat.robot_type[leaf] for leaf, uses in enumerate(flat.uses) if name in uses}
    return of_types(sorted(user for user in users if flat.stocks[user].pooled(name) is not None), name)
