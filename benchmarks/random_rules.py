"""Rules for the mission as a whole, drawn over a random tree: totals, stocks, robots in use, who is left out and who is required."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from random import Random

from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.terms import Terms

Ruled = tuple[Fleet, Terms]
Rule = Callable[[Random, GroundedTree, Fleet, Terms], Ruled]


def used_of(tree: GroundedTree) -> dict[str, float]:
    """What all actions of the tree together use, by name."""
    used: dict[str, float] = {}
    for node in tree.nodes:
        for name, amount in (node.action.uses_at_least if node.action is not None else {}).items():
            used[name] = used.get(name, 0.0) + amount
    return used


def mission_totals(rng: Random, tree: GroundedTree, fleet: Fleet, terms: Terms) -> Ruled:
    """A total for all robots, from nothing to all that the tree could use."""
    return replace(fleet, total_limits=_some(rng, tree)), terms


def stock(rng: Random, tree: GroundedTree, fleet: Fleet, terms: Terms) -> Ruled:
    """The same as a stock of the scene."""
    return fleet, replace(terms, stock=_some(rng, tree))


def max_in_use(rng: Random, tree: GroundedTree, fleet: Fleet, terms: Terms) -> Ruled:
    """One robot fewer than there are, or one, of every type."""
    types = (replace(kind, max_in_use=rng.choice((1, max(1, len(kind.members) - 1)))) for kind in fleet.types)
    return replace(fleet, types=tuple(types)), terms


def without(rng: Random, tree: GroundedTree, fleet: Fleet, terms: Terms) -> Ruled:
    """Robots left out; every type keeps at least one, and those that are required stay."""
    out = [
        robot.id
        for kind in fleet.types
        for robot in rng.sample(kind.members, rng.randint(0, len(kind.members) - 1))
        if robot.id not in terms.require
    ]
    return fleet, replace(terms, without=tuple(out))


def require(rng: Random, tree: GroundedTree, fleet: Fleet, terms: Terms) -> Ruled:
    """A type or one or two robots, which are not left out, and no more of them than may be in use."""
    names: list[str] = []
    for kind in rng.sample(fleet.types, rng.randint(1, min(2, len(fleet.types)))):
        names += _required(rng, kind, terms)
    return fleet, replace(terms, require=tuple(names))


def _required(rng: Random, kind: RobotType, terms: Terms) -> Iterable[str]:
    left = [robot.id for robot in kind.members if robot.id not in terms.without]
    if not left or rng.random() < 0.4:
        return (kind.id,)
    return rng.sample(left, min(rng.randint(1, 2), len(left), kind.max_in_use or len(left)))


def _some(rng: Random, tree: GroundedTree) -> dict[str, float]:
    used = used_of(tree)
    return {name: round(used[name] * rng.choice((0, 0.1, 0.2, 0.3, 0.4, 0.6, 1)), 1) for name in sorted(used)}


RULES: dict[str, Rule] = {
    "totals of the mission": mission_totals,
    "stock of the scene": stock,
    "robots in use": max_in_use,
    "robots left out": without,
    "robots required": require,
}
"""Every rule by name; each may be drawn on top of the others, in this order."""
