"""The task graph: only what is selected, ends of inner nodes, cycles with names, orders per robot."""

from __future__ import annotations

from missiontree.scheduling.precedence import TaskGraph, order_by_robot, task_graph
from tests.scheduling.instances import Group, Instance, Part, mission, work


def graph_of(instance: Instance) -> TaskGraph:
    return task_graph(instance.tree, instance.alternative.choices)


def test_activities_and_roles_are_the_selected_ones() -> None:
    """An XOR takes its first child; the role below the other is not there."""
    made = mission([Group("way", [Part("a", "r", [work(1), work(1)]), Part("b", "r", [work(1)])], "xor")])
    graph = graph_of(made)
    assert graph.roles == {0: (made.node["a.0"], made.node["a.1"])}
    assert graph.activities == ((made.node["a.0"],), (made.node["a.1"],))


def test_a_link_to_a_node_that_is_not_selected_binds_nothing() -> None:
    """b is not selected, so neither "b before c" nor "c before b" is there: both together would be a cycle."""
    made = mission(
        [Group("way", [Part("a", "r", [work(1)]), Part("b", "r", [work(1)])], "xor"), Part("c", "r", [work(1)])],
        [("b", "c"), ("c", "b")],
    )
    assert graph_of(made).order() is not None
    assert graph_of(made).links("precedence") == []


def test_a_precedence_between_inner_nodes_orders_all_leaves_below() -> None:
    made = mission(
        [Group("G", [Part("a", "r", [work(1)]), Part("b", "r", [work(1)])]), Part("c", "r", [work(1)])], [("c", "G")]
    )
    graph = graph_of(made)
    order = graph.order()
    assert order is not None
    before = graph.marks_before(order, {graph.end(made.node["c.0"]): 1})
    assert before[graph.start(made.node["a.0"])] == before[graph.start(made.node["b.0"])] == 1
    assert before[graph.end(made.node["a.0"])] == 1


def test_a_cycle_is_named_by_its_nodes() -> None:
    made = mission([Part("a", "r", [work(1)]), Part("b", "r", [work(1)])], [("a", "b"), ("b", "a")])
    graph = graph_of(made)
    assert graph.order() is None
    assert {"a", "b"} <= {graph.name(node) for node in graph.cycle() or ()}


def test_joint_work_against_the_order_of_roles_is_a_cycle() -> None:
    """a.0 with b.1 and a.1 with b.0: each pair would have to come before the other."""
    made = mission(
        [Part("a", "r", [work(1, sync=0), work(1, sync=1)]), Part("b", "r", [work(1, sync=1), work(1, sync=0)])]
    )
    assert graph_of(made).order() is None


def test_until_each_other_is_a_cycle() -> None:
    made = mission(
        [Part("a", "r", [work(1, open_ended=True)]), Part("b", "r", [work(1, open_ended=True)])],
        [("a", "b", "until"), ("b", "a", "until")],
    )
    assert graph_of(made).order() is None


def test_until_reaches_open_ended_actions_only() -> None:
    made = mission(
        [Part("a", "r", [work(1), work(1, open_ended=True)]), Part("b", "r", [work(1)])], [("a", "b", "until")]
    )
    graph = graph_of(made)
    assert graph.until == {graph.activity_of[made.node["a.1"]]: {graph.activity_of[made.node["b.0"]]}}


def test_each_robot_has_a_topological_order_of_its_own() -> None:
    """b comes before a by precedence, though a stands first in the tree; r1 does both."""
    made = mission(
        [Part("a", "r", [work(1), work(1)]), Part("b", "r", [work(1)]), Part("c", "r", [work(1)])], [("b", "a")]
    )
    orders = order_by_robot(graph_of(made), {0: "r1", 1: "r1", 2: "r2"})
    assert orders == {"r1": (made.node["b.0"], made.node["a.0"], made.node["a.1"]), "r2": (made.node["c.0"],)}
