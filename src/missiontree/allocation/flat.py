"""
One flat form of the problem for all allocators: columns over nodes, integers for everything that is added up.

Utilities are integer millionths, amounts of budgets integer billionths (:data:`AMOUNT_SCALE`). Both are rounded once, at each
leaf, so that every sum is exact and no rank or refusal hangs on the order of additions.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from heapq import nlargest
from typing import Literal, NamedTuple

from missiontree.allocation.timing import Timing, timing_of
from missiontree.errors import InputError
from missiontree.mission.estimate import Estimate, Weights
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.grounded import GroundedTree, NodeKind
from missiontree.mission.terms import NO_TERMS, Terms
from missiontree.mission.tree import APART

AMOUNT_SCALE = 10**9
EVERYBODY = ""
"""Stands in a purse for all robots of the mission, where other purses name a robot type."""

Purse = tuple[str, str]
"""Robot type, or :data:`EVERYBODY`, and name of the budget."""

Uses = tuple[tuple[int, int], ...]
"""Number of a purse with an amount above 0, in the order in which a leaf names its budgets."""


@dataclass(frozen=True, slots=True)
class Stock:
    """
    What the robots of one type may use; names without a limit do not appear.

    Parameters
    ----------
    robots
        Names of the robots, in fleet order.
    budgets
        Per robot, what it may use of each budget, in billionths.
    totals
        What all of them together may use, in billionths.
    max_in_use
        How many different robots may take part; None (default) means all.
    required
        Positions of robots each of which must take part. Default none.
    left_out
        Robots that the mission leaves out by name, with what each could use; they are no part of the other fields. Default none.
    """

    robots: tuple[str, ...]
    budgets: tuple[Mapping[str, int], ...]
    totals: Mapping[str, int]
    max_in_use: int | None = None
    required: tuple[int, ...] = ()
    left_out: Mapping[str, Mapping[str, int]] = field(default_factory=dict)

    @property
    def usable(self) -> int:
        """How many different robots may take part."""
        return len(self.robots) if self.max_in_use is None else min(self.max_in_use, len(self.robots))

    def pooled(self, name: str) -> int | None:
        """No selection uses more of a budget than this, whoever does what; None if nothing limits it."""
        bounds = [self.totals[name]] if name in self.totals else []
        if all(name in budget for budget in self.budgets):
            bounds.append(sum(nlargest(self.usable, (budget[name] for budget in self.budgets))))
        return min(bounds, default=None)

    def largest(self, name: str) -> int | None:
        """No single robot uses more of a budget than this; None if nothing limits it."""
        bounds = [self.totals[name]] if name in self.totals else []
        if all(name in budget for budget in self.budgets):
            bounds.append(max(budget[name] for budget in self.budgets))
        return min(bounds, default=None)


@dataclass(frozen=True, slots=True)
class Shared:
    """
    What all robots of the mission together may use of one budget.

    Parameters
    ----------
    limit
        How much, in billionths.
    source
        Where the limit stands: in the ``fleet`` (total_limits), or in the ``scene`` (stock).
    """

    limit: int
    source: Literal["fleet", "scene"]


class Charges(NamedTuple):
    """
    What leaves take from purses.

    Parameters
    ----------
    purses
        All that some leaf takes from.
    of_leaf
        By node: numbers of purses with what it takes, in billionths; nothing for nodes that are no leaves.
    """

    purses: tuple[Purse, ...]
    of_leaf: Sequence[Uses]


@dataclass(frozen=True)
class Flat:
    """
    A grounded tree over a fleet, as columns indexed by node.

    Parameters
    ----------
    kind, parent, children, label
        As in the grounded tree: parents before children, siblings in order.
    utility
        Of each leaf, in millionths; 0 elsewhere.
    role, robot_type
        Of each leaf; -1 and "" elsewhere.
    uses
        What each leaf uses at least of the budgets that its type or the mission limits, in billionths.
    team
        Team number per role.
    same_robot, different_robot
        Links, as pairs of nodes.
    stocks
        What the robots of each type in the tree may use.
    shared
        What all robots together may use, by name of the budget. Default: no such limit.
    required
        Types that must fill a role each, with what the operator named: the type, robots of it, or both. Default none.
    timing
        What is known of time, if there is a deadline. Default: there is none.
    hand_overs
        Those pairs of ``different_robot`` that are hand-overs, for whose sake robots differ. Default: none is.
    """

    kind: tuple[NodeKind, ...]
    parent: tuple[int, ...]
    children: tuple[tuple[int, ...], ...]
    label: Sequence[str]
    utility: tuple[int, ...]
    role: tuple[int, ...]
    robot_type: tuple[str, ...]
    uses: tuple[Mapping[str, int], ...]
    team: tuple[int | None, ...]
    same_robot: tuple[tuple[int, int], ...]
    different_robot: tuple[tuple[int, int], ...]
    stocks: Mapping[str, Stock]
    shared: Mapping[str, Shared] = field(default_factory=dict)
    required: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    timing: Timing | None = None
    hand_overs: frozenset[tuple[int, int]] = frozenset()

    @cached_property
    def charges(self) -> Charges:
        """What leaves take from their types' purses and from the mission's."""
        purses: dict[Purse, int] = {}
        known: dict[Purse, tuple[int, ...]] = {}
        of_leaf: list[Uses] = []
        for type_id, uses in zip(self.robot_type, self.uses, strict=True):
            taken = []
            for name, used in uses.items():
                own = (type_id, name)
                if own not in known:
                    there = (own, (EVERYBODY, name)) if name in self.shared else (own,)
                    known[own] = tuple(purses.setdefault(purse, len(purses)) for purse in there)
                taken += [(purse, used) for purse in known[own]]
            of_leaf.append(tuple(taken))
        return Charges(tuple(purses), of_leaf)

    def held(self, purse: Purse) -> int | None:
        """No selection takes more from a purse than this; None if nothing limits it."""
        type_id, name = purse
        return self.shared[name].limit if type_id == EVERYBODY else self.stocks[type_id].pooled(name)

    @property
    def links(self) -> tuple[tuple[int, int], ...]:
        """All links about robots; those about time count only where there is a deadline, see :class:`Timing`."""
        return self.same_robot + self.different_robot

    @cached_property
    def leaves_under(self) -> dict[int, frozenset[int]]:
        """Leaves below each end of a link."""
        return {end: frozenset(self._leaves(end)) for link in self.links for end in link}

    def _leaves(self, top: int) -> Iterable[int]:
        stack = [top]
        while stack:
            node = stack.pop()
            if self.kind[node] == "action":
                yield node
            stack.extend(self.children[node])


def amount(value: float) -> int:
    """A budget or a use in billionths, rounded half to even."""
    return round(Fraction(value) * AMOUNT_SCALE)


def flatten(tree: GroundedTree | Flat, fleet: Fleet, weights: Weights, terms: Terms = NO_TERMS) -> Flat:
    """
    Put a grounded tree, a fleet and weights into the form that allocators work on; what is in it already is taken as it is.

    Parameters
    ----------
    tree, fleet, weights
        As an allocator takes them.
    terms
        Who is left out or required, and what the scene holds for the whole mission. Default: nothing of all this.

    Raises
    ------
    InputError
        If an action names a robot type that the fleet does not have, or that is left out.
    """
    if isinstance(tree, Flat):
        return tree
    stocks = _stocks(tree, fleet, terms)
    used_names = {name for node in tree.nodes if node.action is not None for name in node.action.uses_at_least}
    shared = _shared(used_names, fleet, terms)
    limited = {name: frozenset(stock.totals).union(shared, *stock.budgets) for name, stock in stocks.items()}
    utilities: dict[Estimate, int] = {}
    utility, role, robot_type, uses = [], [], [], []
    for node in tree.nodes:
        action = node.action
        if action is None:
            micro, role_index, type_id, used = 0, -1, "", _NOTHING
        else:
            if action.estimate not in utilities:
                utilities[action.estimate] = weights.utility_micro(action.estimate)
            micro, role_index, type_id = utilities[action.estimate], action.role, action.robot_type
            used = _limited_uses(action.uses_at_least, limited[type_id])
        utility.append(micro)
        role.append(role_index)
        robot_type.append(type_id)
        uses.append(used)
    return Flat(
        kind=tuple(node.kind for node in tree.nodes),
        parent=tuple(node.parent for node in tree.nodes),
        children=tree.children,
        label=tuple(node.label for node in tree.nodes),
        utility=tuple(utility),
        role=tuple(role),
        robot_type=tuple(robot_type),
        uses=tuple(uses),
        team=tuple(role.team for role in tree.roles),
        same_robot=tuple((link.first, link.second) for link in tree.links if link.kind == "same_robot"),
        different_robot=tuple((link.first, link.second) for link in tree.links if link.kind in APART),
        stocks=stocks,
        shared=shared,
        required=terms.required_by_type(fleet),
        timing=timing_of(tree),
        hand_overs=frozenset((link.first, link.second) for link in tree.links if link.kind == "hand_over"),
    )


def without_budgets(flat: Flat) -> Flat:
    """The same problem, with robots that no budget limits."""
    stocks = {name: unlimited(stock) for name, stock in flat.stocks.items()}
    return replace(flat, uses=(_NOTHING,) * len(flat.uses), stocks=stocks, shared={})


def unlimited(stock: Stock) -> Stock:
    """The same robots without budgets."""
    return replace(stock, budgets=(_NOTHING,) * len(stock.robots), totals=_NOTHING)


_NOTHING: Mapping[str, int] = {}


def _limited_uses(uses: Mapping[str, float], limited: frozenset[str]) -> Mapping[str, int]:
    if not uses or not limited:
        return _NOTHING
    exact = {name: amount(used) for name, used in sorted(uses.items()) if name in limited}
    return {name: used for name, used in exact.items() if used}


def _shared(used: Iterable[str], fleet: Fleet, terms: Terms) -> dict[str, Shared]:
    """The tighter of the fleet's total and the scene's stock, for every budget that is used."""
    found: dict[str, Shared] = {}
    for name in sorted(used):
        limits = [Shared(amount(fleet.total_limits[name]), "fleet")] if name in fleet.total_limits else []
        limits += [Shared(amount(terms.stock[name]), "scene")] if name in terms.stock else []
        if limits:
            found[name] = min(limits, key=lambda shared: shared.limit)
    return found


def _stocks(tree: GroundedTree, fleet: Fleet, terms: Terms) -> dict[str, Stock]:
    team, required = terms.team_of(fleet), terms.required_robots(fleet)
    named = dict.fromkeys(node.action.robot_type for node in tree.nodes if node.action is not None)
    used: dict[str, set[str]] = {name: set() for name in named}
    for node in tree.nodes:
        if node.action is not None:
            used[node.action.robot_type].update(node.action.uses_at_least)
    for name in named:
        if name not in team.by_id:
            raise InputError(
                f"the tree has actions of robot type {name!r}, which the fleet does not have",
                accepted=", ".join(team.by_id),
            )
    return {
        name: _stock(
            team.by_id[name], fleet.by_id[name], sorted(used[name]), required, terms.refilled(fleet.by_id[name])
        )
        for name in named
    }


def _stock(
    robot_type: RobotType, whole: RobotType, names: list[str], required: tuple[str, ...], refilled: frozenset[str]
) -> Stock:
    """What is there of a type, and of the whole of it what is left out; what robots refill is no budget of theirs."""

    def budget_of(robot: Robot) -> dict[str, int]:
        found = {name: robot_type.budget(robot, name) for name in names if name not in refilled}
        return {name: amount(limit) for name, limit in found.items() if limit is not None}

    members = robot_type.members
    there = {robot.id for robot in members} if whole is not robot_type else set()
    totals = {name: amount(robot_type.total_limits[name]) for name in names if name in robot_type.total_limits}
    return Stock(
        robots=tuple(robot.id for robot in members),
        budgets=tuple(budget_of(robot) for robot in members),
        totals=totals,
        max_in_use=robot_type.max_in_use if whole.usable < len(whole.members) else None,
        required=tuple(place for place, robot in enumerate(members) if robot.id in required),
        left_out={robot.id: budget_of(robot) for robot in whole.members if there and robot.id not in there},
    )
