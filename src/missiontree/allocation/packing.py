"""
Deal roles out to the robots of one type so that every robot stays within its budgets, no more robots are in use than may be, and
those that must take part do: exact backtracking.

The strongest demand goes first, to the robot that has least to do so far, which also spreads work for the scheduler. Robots
in the same state are tried once, and states that failed are remembered, robots unordered.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

from missiontree.allocation.flat import Stock, unlimited

Amounts = dict[str, int]
"""Billionths by name of the budget."""
State = tuple[tuple[tuple[str, int], ...], tuple[int, ...], int]
Because = Literal["budget", "apart", "in_use", "required"]


@dataclass(frozen=True, slots=True)
class Load:
    """
    Roles that one robot fills together.

    Parameters
    ----------
    group
        Name of the group: its smallest role.
    uses
        What they use together, in billionths.
    apart
        Groups that another robot must fill.
    """

    group: int
    uses: Mapping[str, int]
    apart: frozenset[int]


@dataclass(frozen=True, slots=True)
class Packed:
    """
    What came of it.

    Parameters
    ----------
    answer
        ``yes``, ``no`` or ``undecided``.
    robots
        Index of the robot by group, if the answer is yes.
    name
        A budget without which the answer might not be no; empty if budgets have no part in it.
    because
        What stands against it, if the answer is no: budgets, who must stay apart, how many may be in use, or who must take part.
    """

    answer: Literal["yes", "no", "undecided"]
    robots: Mapping[int, int] = field(default_factory=dict)
    name: str = ""
    because: Because = "budget"


def add_up(sum_: Amounts, more: Mapping[str, int]) -> None:
    """Add amounts to a sum; a Counter would do the same, and takes several times as long for the few names there are."""
    for name, amount in more.items():
        sum_[name] = sum_.get(name, 0) + amount


def pack(stock: Stock, loads: Sequence[Load], steps: int) -> Packed:
    """Find a robot for every load, or prove that there is no way, or give up after so many steps."""
    packed = _packed(stock, loads, steps)
    if packed.answer != "no":
        return packed
    if stock.required and _packed(replace(stock, required=()), loads, steps).answer == "yes":
        return Packed("no", because="required")
    if stock.usable < len(stock.robots):
        freed = replace(stock, required=(), max_in_use=None)
        if _packed(freed, loads, steps).answer == "yes":
            return Packed("no", because="in_use")
    bare = replace(unlimited(stock), required=(), max_in_use=None)
    if any(load.apart for load in loads) and (not packed.name or _packed(bare, loads, steps).answer == "no"):
        return Packed("no", because="apart")
    return packed


def _packed(stock: Stock, loads: Sequence[Load], steps: int) -> Packed:
    packer = _Packer(stock, loads, steps)
    if packer.names or any(load.apart for load in loads):
        return packer.run()
    # Nothing but numbers counts: the required ones first, then as many others as may be in use, in turn.
    others = (robot for robot in range(len(stock.robots)) if robot not in stock.required)
    taken = [*stock.required, *others][: stock.usable]
    if len(stock.required) > min(len(taken), len(loads)):
        return Packed("no")
    return Packed("yes", {load.group: taken[index % len(taken)] for index, load in enumerate(loads)})


def _scarce(stock: Stock, loads: Sequence[Load]) -> list[str]:
    """Budgets that some robot could overdraw if it took everything; others need not be looked at."""
    wanted: Amounts = {}
    for load in loads:
        add_up(wanted, load.uses)
    return sorted(
        name for name, used in wanted.items() if any(used > left[name] for left in stock.budgets if name in left)
    )


class _Packer:
    def __init__(self, stock: Stock, loads: Sequence[Load], steps: int) -> None:
        self.names = _scarce(stock, loads)
        largest = {name: max(left.get(name, 0) for left in stock.budgets) for name in self.names}

        def strength(load: Load) -> tuple[float, int, int]:
            shares = [load.uses.get(name, 0) / max(1, largest[name]) for name in self.names]
            return (-max(shares, default=0.0), -len(load.apart), load.group)

        self.loads = sorted(loads, key=strength)
        self.order = {load.group: depth for depth, load in enumerate(self.loads)}
        self.left = [{name: left[name] for name in self.names if name in left} for left in stock.budgets]
        self.held: list[list[Load]] = [[] for _ in stock.robots]
        self.required, self.most = frozenset(stock.required), stock.usable
        self.counting = bool(stock.required) or stock.usable < len(stock.robots)
        self.steps = steps
        self.failed: set[tuple[int, tuple[State, ...]]] = set()
        # Beyond these depths nobody can have to stay apart from the group any more.
        self.matters = {
            load.group: max((self.order[g] for g in load.apart if g in self.order), default=-1) for load in loads
        }

    def run(self) -> Packed:
        trail: list[list[int]] = []  # per load dealt out: robots still to try, the last one being tried now
        keys: list[tuple[int, tuple[State, ...]]] = []
        while len(trail) < len(self.loads):
            depth = len(trail)
            states = [self._state(robot, depth) for robot in range(len(self.held))]
            key = (depth, tuple(sorted(states)))
            trail.append([] if key in self.failed else self._robots_for(depth, states))
            keys.append(key)
            while not trail[-1]:
                trail.pop()
                self.failed.add(keys.pop())
                if not trail:
                    return Packed("no", name=self._blamed())
                self._take_back(self.loads[len(trail) - 1], trail[-1].pop())
            self.steps -= 1
            if self.steps < 0:
                return Packed("undecided")
            self._hand_out(self.loads[len(trail) - 1], trail[-1][-1])
        return Packed("yes", {load.group: tried[-1] for load, tried in zip(self.loads, trail, strict=True)})

    def _state(self, robot: int, depth: int) -> State:
        lasting = tuple(sorted(load.group for load in self.held[robot] if self.matters[load.group] >= depth))
        # Who does nothing yet is told from who does something only where it is counted.
        standing = (2 if robot in self.required else 1) if self.counting and not self.held[robot] else 0
        return tuple(sorted(self.left[robot].items())), lasting, standing

    def _idle_required(self) -> int:
        return sum(not self.held[robot] for robot in self.required)

    def _may_begin(self, robot: int) -> bool:
        """Whether a robot that does nothing yet may do something: places are kept for those that are required."""
        busy = sum(map(bool, self.held))
        return busy + self._idle_required() + (robot not in self.required) <= self.most

    def _robots_for(self, depth: int, states: Sequence[State]) -> list[int]:
        """Robots that can take the load at a depth, one per state, the first to try at the end."""
        load, spare = self.loads[depth], len(self.loads) - depth - self._idle_required()
        if spare < 0:
            return []
        idlest_first = sorted(range(len(self.held)), key=lambda robot: (len(self.held[robot]), robot))
        one_per_state: dict[State, int] = {}
        for robot in idlest_first:
            if not spare and (self.held[robot] or robot not in self.required):
                continue  # as many loads are left as required robots that do nothing yet
            if states[robot] not in one_per_state and self._fits(load, robot):
                one_per_state[states[robot]] = robot
        return list(one_per_state.values())[::-1]

    def _fits(self, load: Load, robot: int) -> bool:
        if self.counting and not self.held[robot] and not self._may_begin(robot):
            return False
        left = self.left[robot]
        return all(used <= left[name] for name, used in load.uses.items() if name in left) and not any(
            held.group in load.apart for held in self.held[robot]
        )

    def _hand_out(self, load: Load, robot: int) -> None:
        self.held[robot].append(load)
        for name in self.left[robot]:
            self.left[robot][name] -= load.uses.get(name, 0)

    def _take_back(self, load: Load, robot: int) -> None:
        self.held[robot].pop()
        for name in self.left[robot]:
            self.left[robot][name] += load.uses.get(name, 0)

    def _blamed(self) -> str:
        """The budget that is scarcest, by the share of it that is wanted."""
        wanted = {name: sum(load.uses.get(name, 0) for load in self.loads) for name in self.names}
        there = {name: sum(left.get(name, 0) for left in self.left) for name in self.names}
        return max(self.names, key=lambda name: (wanted[name] / max(1, there[name]), name), default="")
