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
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import islice

from missiontree.allocation.flat import AMOUNT_SCALE, Flat, Uses
from missiontree.allocation.soonest import TooLate, reasons_of_lateness, strike_late
from missiontree.allocation.turnout import turnouts
from missiontree.allocation.wording import Holder, of_all_robots, of_one_robot, of_the_mission, of_types, type_idle
from missiontree.mission.reason import Reason, Severity

MISSION = "*"  # stands for all robots in a purse that the mission limits, as "" does in the sum of what types have
Purse = tuple[
    str, int, str
]  # robot type ("" or MISSION for all of them), role (-1 for all of them), name of the budget


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
        if flat.kind[node] != "action":
            judge = any if flat.kind[node] == "xor" else all
            possible[node] = judge(map(possible.__getitem__, flat.children[node]))
    return possible


def possible_nodes(flat: Flat) -> Possibility:
    """Which nodes can be done with what the robots may use, and with everybody who must take part."""
    possible = structurally_possible(flat)
    found = Possibility(possible, late=strike_late(flat, possible))
    if not any(flat.uses):
        return _with_required(flat, found)
    limits, kind = _Limits(flat), flat.kind
    least: dict[int, dict[int, int]] = {}  # of inner nodes
    charged: dict[int, Uses] = {}  # of leaves
    for node in range(len(kind) - 1, -1, -1):
        use: dict[int, int] = {}
        over: list[int] = []
        if kind[node] == "action":
            if flat.uses[node] and possible[node]:
                charged[node] = limits.charge(node)
                over = [purse for purse, used in charged[node] if used > limits.held[purse]]
                use = dict(charged.pop(node)) if over else use
        elif kind[node] == "xor":
            below = [child for child in flat.children[node] if possible[child]]
            possible[node] = bool(below)
            # A minimum is no larger than what passed below.
            use = _minimum([least.pop(child) if child in least else dict(charged.pop(child, ())) for child in below])
        elif all(map(possible.__getitem__, flat.children[node])):
            parts = [least.pop(child) for child in flat.children[node] if child in least]
            leaves = [charged.pop(child) for child in flat.children[node] if child in charged]
            use, over = _sum(parts, leaves, limits.held)
        else:
            possible[node] = False
        if over:
            possible[node] = False
            found.excesses.append(limits.excess(node, use, over))
        elif use:
            least[node] = use
    return _with_required(flat, found)


def _with_required(flat: Flat, found: Possibility) -> Possibility:
    """Nothing is possible if a type that must take part finds too few roles, whatever is chosen."""
    if not flat.required or not found.possible[0]:
        return found
    idle = {turnout.type_id: turnout.most[0] for turnout in turnouts(flat, found.possible) if turnout.spare < 0}
    return replace(found, possible=[False] * len(flat.kind), idle=idle) if idle else found


def _sum(parts: list[dict[int, int]], leaves: list[Uses], held: Sequence[int]) -> tuple[dict[int, int], list[int]]:
    """The sum, written into the largest part, and the purses that hold each term and not the sum."""
    total, over = max(parts, key=len, default={}), list[int]()
    for uses in (*[part.items() for part in parts if part is not total], *leaves):
        for purse, used in uses:
            if purse in total:
                total[purse] += used
                if total[purse] > held[purse]:
                    over.append(purse)
            else:
                total[purse] = used
    return total, over


def _minimum(parts: list[dict[int, int]]) -> dict[int, int]:
    if len(parts) == 1:
        return parts[0]
    smallest = min(parts, key=len, default={})
    found: dict[int, int] = {}
    for purse in smallest:
        uses = [part[purse] for part in parts if purse in part]
        if len(uses) == len(parts):
            found[purse] = min(uses)
    return found


class _Limits:
    """The purses by number, and how much each holds."""

    def __init__(self, flat: Flat) -> None:
        self.flat = flat
        self.purses: list[Purse] = []
        self.held: list[int] = []
        self._numbers: dict[Purse, int] = {}
        self._leaves_of = Counter(role for role, uses in zip(flat.role, flat.uses, strict=True) if uses)
        used = sorted({(flat.robot_type[leaf], name) for leaf, uses in enumerate(flat.uses) for name in uses})
        pooled = {(type_id, name): flat.stocks[type_id].pooled(name) for type_id, name in used}
        self._largest = {(type_id, name): flat.stocks[type_id].largest(name) for type_id, name in used}
        everywhere: dict[str, int] = {}
        for (_, name), limit in pooled.items():
            everywhere[name] = everywhere.get(name, 0) + (limit or 0)
        self._of_all: dict[tuple[str, str], tuple[int, ...]] = {}
        for (type_id, name), limit in pooled.items():
            filled = [((type_id, -1, name), limit), (("", -1, name), everywhere[name])] if limit is not None else []
            filled += [((MISSION, -1, name), flat.shared[name].limit)] if name in flat.shared else []
            self._of_all[type_id, name] = tuple(self._number(purse, held) for purse, held in filled)

    def _number(self, purse: Purse, held: int) -> int:
        number = self._numbers.setdefault(purse, len(self.purses))
        if number == len(self.purses):
            self.purses.append(purse)
            self.held.append(held)
        return number

    def charge(self, leaf: int) -> Uses:
        """
        What a leaf takes from whom.

        Of one robot in its role it is told only if other leaves share the role, or if it is too much already: else it adds up with
        nothing.
        """
        type_id, role = self.flat.robot_type[leaf], self.flat.role[leaf]
        charged: list[tuple[int, int]] = []
        for name, used in self.flat.uses[leaf].items():
            largest = self._largest[type_id, name]
            if largest is not None and (used > largest or self._leaves_of[role] > 1):
                charged.append((self._number((type_id, role, name), largest), used))
            for purse in self._of_all[type_id, name]:
                charged.append((purse, used))
        return tuple(charged)

    def excess(self, node: int, use: Mapping[int, int], over: Iterable[int]) -> Excess:
        """The first of the overdrawn purses: one type's, since what a single type lacks is not to be told of all types together."""
        first = min(over, key=lambda purse: (self.purses[purse][0] in {"", MISSION}, self.purses[purse]))
        return Excess(node, self.purses[first], use[first], self.held[first])


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
