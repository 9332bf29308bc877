"""Rules for the mission as a whole, drawn over a random tree: totals, stocks, robots in use, who is left out and who is required."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from random import Random

from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.grounded import GroundedLink, GroundedNode, GroundedTree
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


def times(rng: Random, tree: GroundedTree) -> GroundedTree:
    """
    Durations, certain travel, joint and open-ended actions; release times and deadlines at up to three nodes; an until link.

    The root has a deadline in two of three trees, from what one action takes to more than most selections do.
    """
    syncs = [None, None, None, None, None, 0, 1]
    timed: list[GroundedNode] = []
    chosen = set(rng.sample(range(len(tree.nodes)), min(len(tree.nodes), rng.randint(0, 3))))
    chosen |= {0} if rng.random() < 0.67 or not chosen else set()
    for index, node in enumerate(tree.nodes):
        action = node.action
        if action is not None:
            action = replace(
                action,
                duration_s=rng.randint(0, 8) / 2,
                travel_at_least_s=rng.choice((0, 0, 0, 1.5)),
                moves=rng.random() < 0.25,
                sync=rng.choice(syncs),
                open_ended=rng.random() < 0.2,
            )
        release = rng.choice((0, 0, 0, 1, 3.5)) if index in chosen else 0.0
        span = rng.choice((None, 1, 2, 3, 4, 6, 8, 11)) if index in chosen else None
        if index == 0 and index in chosen:
            span = rng.choice((3, 4, 5, 6, 8, 10, 14))
        deadline = None if span is None else release + span
        timed.append(replace(node, action=action, release_s=release, deadline_s=deadline))
    links = (*tree.links, *_until(rng, tree))
    return replace(tree, nodes=tuple(timed), links=links)


def _until(rng: Random, tree: GroundedTree) -> Iterable[GroundedLink]:
    first, second = rng.randrange(len(tree.nodes)), rng.randrange(len(tree.nodes))
    for outer, inner in ((first, second), (second, first)):
        node = inner
        while node > outer:
            node = tree.nodes[node].parent
        if node == outer:
            return ()
    return (GroundedLink(first, second, "until"),)


TREE_RULES: dict[str, Callable[[Random, GroundedTree], GroundedTree]] = {"release times and deadlines": times}
"""Rules that stand in the tree itself, drawn after all others."""
