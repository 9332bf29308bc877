"""Orders that follow from holding, and bundles of roles that must be under way together."""

from __future__ import annotations

from missiontree.mission.fleet import Fleet
from missiontree.scheduling.bundles import bundles_of
from missiontree.scheduling.holding import order_held_roles
from missiontree.scheduling.precedence import TaskGraph, task_graph
from missiontree.scheduling.staffing import staffing_of
from tests.scheduling.instances import Instance, Part, mission, robots, work

TWO = [work(1), work(1)]


def graph_of(made: Instance) -> TaskGraph:
    return task_graph(made.tree, made.alternative.choices)


def ordered(made: Instance, count: int) -> tuple[bool, TaskGraph]:
    graph = graph_of(made)
    return order_held_roles(graph, staffing_of(graph), Fleet((robots("r", count), robots("s")))) is not None, graph


def test_work_for_a_later_action_comes_before_the_whole_role() -> None:
    """b must end before a.1 starts and the single r does both: so b ends before a.0 starts."""
    made = mission([Part("a", "r", TWO), Part("b", "r", [work(1)])], [("b", "a.1")])
    possible, graph = ordered(made, 1)
    assert possible
    assert graph.start(made.node["a.0"]) in graph.successors[graph.end(made.node["b.0"])]
    # with two robots nothing follows
    _, free = ordered(made, 2)
    assert free.start(made.node["a.0"]) not in free.successors[free.end(made.node["b.0"])]


def test_orders_that_follow_may_close_a_cycle_in_several_steps() -> None:
    """c within a by another type's role, which waits for a.0: r would hold a while only it can do c."""
    made = mission(
        [Part("a", "r", TWO), Part("s", "s", [work(1)]), Part("c", "r", [work(1)])],
        [("a.0", "s"), ("s", "c"), ("c", "a.1")],
    )
    assert not ordered(made, 1)[0]
    assert ordered(made, 2)[0]


def test_roles_that_wait_for_each_other_in_turn_form_a_bundle() -> None:
    """a.0 before b before a.1: a and b are under way together; c only follows."""
    made = mission(
        [Part("a", "r", TWO), Part("b", "r", [work(1)]), Part("c", "r", [work(1)])],
        [("a.0", "b"), ("b", "a.1"), ("a", "c")],
    )
    bundles = bundles_of(graph_of(made))
    assert bundles.of_role[0] == bundles.of_role[1] != bundles.of_role[2]
    assert bundles.leaves[bundles.of_role[0]] == 3


def test_joint_work_makes_a_bundle() -> None:
    made = mission([Part("a", "r", [work(1, sync=0)]), Part("b", "s", [work(1, sync=0)]), Part("c", "s", [work(1)])])
    bundles = bundles_of(graph_of(made))
    assert bundles.of_role[0] == bundles.of_role[1] != bundles.of_role[2]
