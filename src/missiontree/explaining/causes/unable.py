"""Who is not able to do the parts of a link: what stands behind one that nobody can keep."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.mission.grounded import GroundedLink, GroundedTree
from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason

ABOUT_ROBOTS = ("same_robot", "different_robot")


def unable(plan: Plan, words: str) -> tuple[Reason, ...]:
    """
    Refusals of robot types for the parts that a clash names as those of one robot, or of different ones.

    Such a link clashes where each part has somebody, but nobody could do both, or too few could do one; then it is worth telling who lacks
    what, and of whom there are too few.

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
    few: dict[str, Reason] = {}
    for link in tree.links:
        ends = [tree.nodes[end] for end in (link.first, link.second)]
        if link.kind in ABOUT_ROBOTS and all(f'"{end.label}"' in words for end in ends):
            named += [end.source for end in ends if end.source is not None]
            if link.kind == "different_robot":
                few |= {one.robot: one for one in _too_few(plan, tree, link)}
    within = _within(plan, named)
    lacking = (one for one in plan.grounding.not_offered if one.node in within and one.robot)
    return (*lacking, *few.values())


def _too_few(plan: Plan, tree: GroundedTree, link: GroundedLink) -> Iterator[Reason]:
    """Robot types that can do both parts of a link, of each of which there is one robot that may take part."""
    first, second = (_types_below(tree, end) for end in (link.first, link.second))
    for kind in plan.brief.fleet.types:
        if kind.id in first & second and kind.usable == 1:
            there = "there is one" if len(kind.members) == 1 else "one of them may be in use"
            yield Reason(
                rule="too_few_robots",
                message=f"{kind.label} can do both parts, and {there}.",
                robot=kind.id,
                found="1",
                needed="2",
            )


def _types_below(tree: GroundedTree, node: int) -> set[str]:
    """Robot types that some action below a node is for."""
    found, waiting = set[str](), [node]
    while waiting:
        index = waiting.pop()
        action = tree.nodes[index].action
        if action is not None:
            found.add(action.robot_type)
        waiting += tree.children[index]
    return found


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
