"""Parts of a mission: a plan that leaves something out says so, and what it says it leaves out is all that it leaves out."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason
from missiontree.rechecking.facts import broken

RULE = "core_partial"


def part_of_the_mission(plan: Plan) -> Iterator[Reason]:
    """The outcome is partial if and only if something is left out, the tree holds all the rest, and all of that is on offer."""
    partial = plan.partial
    if plan.tree is not None and plan.grounding is not None:
        there = {node.source for node in plan.grounding.tree.nodes}
        for node in plan.tree.nodes:
            if node.routine is not None and node.id not in there:
                yield broken(
                    RULE, f"{node.label} is part of the mission, and the tree over the fleet lacks it.", node=node.id
                )
    if (partial is None) != (plan.outcome != "partial"):
        yield broken(
            RULE, f"the outcome is {plan.outcome}, and what is left out is {'not ' if partial is None else ''}said."
        )
    if partial is None or plan.tree is None:
        return
    if not partial.left_out:
        yield broken(RULE, "a part of the mission is planned, and nothing is said to be left out.")
    without = {one.node for one in partial.left_out}
    expected = [
        node.id
        for node in partial.whole.nodes
        if node.id not in without and without.isdisjoint(partial.whole.ancestors(node.id))
    ]
    if [node.id for node in plan.tree.nodes] != expected:
        yield broken(RULE, "what is planned is not the whole mission without what is left out.")
    links = {link for link in partial.whole.links if link.first in expected and link.second in expected}
    needed = {link for link in links if link.kind != "until"}  # nothing open-ended may be left that one could speak of
    if not needed <= set(plan.tree.links) <= links:
        yield broken(RULE, "the links of what is planned are not those of the whole mission.")
