from dataclasses import replace

import pytest

from missiontree.authoring.findings import findings, gate
from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.tree import Link, MissionNode, MissionTree
from tests.builders import reunite_tree


def changed(node_id: str, **changes: object) -> MissionTree:
    tree = reunite_tree()
    nodes = tuple(replace(node, **changes) if node.id == node_id else node for node in tree.nodes)  # type: ignore[arg-type]
    return replace(tree, nodes=nodes)


def test_the_papers_tree_passes_the_gate(brief: MissionBrief) -> None:
    assert findings(reunite_tree(), brief) == ()


def test_no_tree_is_a_finding(brief: MissionBrief) -> None:
    assert [finding.rule for finding in gate(None, brief)] == ["no_tree"]


@pytest.mark.parametrize(
    ("tree", "rule", "node"),
    [
        (changed("search", routine=None, arguments={}), "open_leaf", "search"),
        (changed("search", routine="Fly"), "unknown_routine", "search"),
        (changed("search", arguments={}), "wrong_arguments", "search"),
        (changed("search", arguments={"agent": "Child", "location": "Mom"}), "wrong_arguments", "search"),
        (changed("search", arguments={"agent": "Chld"}), "unknown_entity", "search"),
        (changed("search", resources=("tele_robto",)), "unknown_robot", "search"),
        (replace(reunite_tree(), links=(Link("locate", "reunite"), Link("transport", "search"))), "cycle", ""),
    ],
)
def test_each_fault_is_found_once_and_named(tree: MissionTree, rule: str, node: str, brief: MissionBrief) -> None:
    (finding,) = gate(tree, brief)
    assert finding.rule == rule
    assert finding.node == node or not node
    assert finding.hint


def test_a_cycle_names_all_its_nodes(brief: MissionBrief) -> None:
    """locate ends before reunite starts, so search (below locate) cannot wait for transport (below reunite)."""
    tree = replace(reunite_tree(), links=(Link("locate", "reunite"), Link("transport", "search")))
    (finding,) = gate(tree, brief)
    for node in ("locate", "reunite", "search", "transport"):
        assert node in finding.message


def test_entities_that_clash_with_the_scene_are_found(scenic: MissionBrief) -> None:
    tree = replace(reunite_tree(), entities=(Entity(id="child", kind="person"),))
    assert [finding.rule for finding in gate(tree, scenic)] == ["entities_clash"]


def test_a_kind_that_the_routine_does_not_take_is_found(brief: MissionBrief) -> None:
    """ReachAndTransport takes no place as agent."""
    tree = replace(reunite_tree(), entities=(Entity(id="Child", kind="place"), Entity(id="Mom", kind="person")))
    assert [(finding.rule, finding.node) for finding in gate(tree, brief)] == [("wrong_kind", "transport")]


def test_too_deep_a_tree_is_found(brief: MissionBrief) -> None:
    """64 tasks in a chain and the routine below the last make 65 levels."""
    chain = [MissionNode(id=f"t{n}", label="t", gate="and", children=(f"t{n + 1}",)) for n in range(64)]
    leaf = MissionNode(id="t64", label="Search", routine="Search", arguments={"agent": "x"})
    tree = MissionTree(objective="x", nodes=(*chain, leaf), entities=(Entity(id="x"),))
    (finding,) = gate(tree, brief)
    assert (finding.rule, finding.found) == ("size", "65")


def test_a_link_across_a_xor_is_a_warning_and_no_fault(brief: MissionBrief) -> None:
    tree = changed("root", gate="xor")
    (finding,) = findings(tree, brief)
    assert (finding.rule, finding.severity) == ("link_never_binds", "warning")
    assert gate(tree, brief) == ()


def test_one_entity_for_two_arguments_is_a_fault(brief: MissionBrief) -> None:
    """A tree from a file has not gone through the calls that refuse this."""
    tree = reunite_tree()
    leaf = next(node for node in tree.nodes if node.routine == "ReachAndTransport")
    twice = replace(leaf, arguments=dict.fromkeys(leaf.arguments, leaf.arguments["agent"]))
    nodes = tuple(twice if node is leaf else node for node in tree.nodes)
    assert [finding.rule for finding in gate(replace(tree, nodes=nodes), brief)] == ["same_entity_twice"]
