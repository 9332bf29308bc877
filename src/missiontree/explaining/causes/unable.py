"""Who is not able to do the parts of a link: what stands behind one that nobody can keep."""

from __future__ import annotations

from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason

ABOUT_ROBOTS = ("same_robot", "different_robot")


def unable(plan: Plan, words: str) -> tuple[Reason, ...]:
    """
    Refusals of robot types for the parts that a clash names as those of one robot, or of different ones.

    Such a link clashes where each part has somebody, but nobody could do both, or too few could do one; then it is worth telling who lacks
    what.

    Parameters
    ----------
    plan
        A plan with a tree over its fleet.
    words
        The clash in words, which name parts by their labels.
    """
    assert plan.grounding is not None
    tree = plan.grounding.tree
    named: list[str] = []
    for link in tree.links:
        ends = [tree.nodes[end] for end in (link.first, link.second)]
        if link.kind in ABOUT_ROBOTS and all(f'"{end.label}"' in words for end in ends):
            named += [end.source for end in ends if end.source is not None]
    within = _within(plan, named)
    return tuple(one for one in plan.grounding.not_offered if one.node in within and one.robot)


def _within(plan: Plan, nodes: list[str]) -> set[str]:
    """Nodes of the mission tree, and all below them: of a part with choices, whoever cannot do one of them."""
    found, waiting = set[str](), list(nodes)
    below = {node.id: node.children for node in plan.tree.nodes} if plan.tree is not None else {}
    while waiting:
        node = waiting.pop()
        if node not in found:
            found.add(node)
            waiting += below.get(node, ())
    return found
