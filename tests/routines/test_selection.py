"""Which nodes can be selected together, and which must be."""

from __future__ import annotations

from missiontree.mission.tree import MissionNode, MissionTree
from missiontree.routines.selection import CoSelection
from tests.builders import routine_node

TREE = MissionTree(
    objective="o",
    nodes=(
        MissionNode(id="root", label="r", gate="and", children=("always", "either")),
        routine_node("always", "Search", agent="x"),
        MissionNode(id="either", label="e", gate="xor", children=("left", "right")),
        MissionNode(id="left", label="l", gate="and", children=("l1", "l2")),
        routine_node("l1", "Search", agent="x"),
        routine_node("l2", "Search", agent="x"),
        routine_node("right", "Search", agent="x"),
    ),
)
NUMBER = {node.id: index for index, node in enumerate(TREE.nodes)}


def test_only_different_children_of_one_xor_exclude_each_other() -> None:
    selection = CoSelection(TREE)
    pairs = {(a, b) for a in NUMBER for b in NUMBER if a < b and selection.exclusive(NUMBER[a], NUMBER[b])}
    assert pairs == {("left", "right"), ("l1", "right"), ("l2", "right")}


def test_what_is_selected_with_a_node() -> None:
    selection = CoSelection(TREE)
    with_l1 = {name for name in NUMBER if selection.implies(NUMBER["l1"], NUMBER[name])}
    assert with_l1 == {"root", "always", "either", "left", "l1", "l2"}
    assert not selection.implies(NUMBER["always"], NUMBER["l1"])
