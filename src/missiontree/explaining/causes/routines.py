"""Routines that no robot can do, and for each the rule that refused each robot type."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.explaining.shortfall import shortfall_of
from missiontree.mission.explanation import Cause
from missiontree.mission.grounded import GroundedTree, Grounding
from missiontree.mission.reason import Reason
from missiontree.mission.tree import MissionTree

FAR = {"capability_missing": 1, "no_robot_able": 2, "kind_refused": 3}
"""How far a type is from being able, by the rule that refused it: what is not listed is a number, a way or a permission away."""


def routine_causes(tree: MissionTree, grounding: Grounding) -> tuple[Cause, ...]:
    """
    Why the mission cannot be done, whatever the limits of the robots: routines for which there is nobody.

    Of an AND every child that cannot be done is told, of a XOR, which has then no child that can, all of them.
    """
    return tuple(_cause(tree, node, grounding) for node in _to_blame(grounding.tree))


def _to_blame(grounded: GroundedTree) -> Iterator[str]:
    """Ids of the routines that stand in the way, in tree order."""
    possible = [True] * len(grounded.nodes)
    for node in range(len(grounded.nodes) - 1, -1, -1):
        ways = [possible[child] for child in grounded.children[node]]
        if grounded.nodes[node].kind != "action":
            possible[node] = any(ways) if grounded.nodes[node].kind == "xor" else all(ways)
    if possible[0]:
        return
    waiting, seen = [0], set[str]()
    while waiting:
        node = waiting.pop()
        if possible[node]:
            continue
        below = [child for child in grounded.children[node] if not possible[child]]
        source = grounded.nodes[node].source
        if not below and source is not None and source not in seen:
            seen.add(source)
            yield source
        waiting.extend(reversed(below))


def _cause(tree: MissionTree, node_id: str, grounding: Grounding) -> Cause:
    reasons = tuple(reason for reason in grounding.not_offered if reason.node == node_id)
    reasons = tuple(sorted(reasons, key=lambda reason: FAR.get(reason.rule, 0)))
    first = next((reason for reason in reasons if shortfall_of(reason) is not None), None)
    return Cause(
        stage="tree",
        rule=_rule(reasons),
        words=f'No robot of this fleet can do "{tree.by_id[node_id].label}".',
        node=node_id,
        reasons=reasons,
        shortfall=None if first is None else shortfall_of(first),
    )


def _rule(reasons: tuple[Reason, ...]) -> str:
    """The rule that all reasons share; else that nobody is able."""
    rules = {reason.rule for reason in reasons}
    return rules.pop() if len(rules) == 1 else "no_robot_able"
