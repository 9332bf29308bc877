"""Selection: the root, all children of a selected AND, exactly one child of a selected XOR, and nothing else."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from missiontree.mission.reason import Reason
from missiontree.rechecking.facts import Facts, broken

RULE = "core_selection"


def one_child_per_xor(facts: Facts) -> Iterator[Reason]:
    """Every reached XOR has one choice, which is a child of its own; no other node has any."""
    nodes = facts.tree.nodes
    chosen = Counter(choice.xor for choice in facts.alternative.choices)
    reached = set(facts.selected)
    for choice in facts.alternative.choices:
        if choice.xor >= len(nodes) or nodes[choice.xor].kind != "xor":
            yield broken(RULE, f"a choice is made at node {choice.xor}, which is no XOR.", node=choice.xor)
        elif choice.child not in facts.tree.children[choice.xor]:
            message = f"{choice.child} is chosen at {facts.label(choice.xor)} and is no child of it."
            yield broken(RULE, message, node=choice.xor)
        elif choice.xor not in reached:
            yield broken(RULE, f"a choice is made at {facts.label(choice.xor)}, which is not reached.", node=choice.xor)
    for node in facts.selected:
        if nodes[node].kind == "xor" and chosen[node] != 1:
            message = f"{facts.label(node)} has {chosen[node]} chosen children; a reached XOR has exactly one."
            yield broken(RULE, message, node=node)


def choices_in_preorder(facts: Facts) -> Iterator[Reason]:
    """Choices stand in the order in which their nodes are reached."""
    reached = [node for node in facts.selected if facts.tree.nodes[node].kind == "xor"]
    chosen = [choice.xor for choice in facts.alternative.choices]
    if sorted(chosen) == sorted(reached) and chosen != reached:
        yield broken(RULE, f"choices stand in the order {chosen}, and are reached in the order {reached}.")
