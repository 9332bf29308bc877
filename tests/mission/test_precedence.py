"""The order that links impose, against hand cases and against a plain search for a cycle."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.mission.precedence import EventGraph, IndexedLink, end_of, event_graph, start_of
from missiontree.mission.tree import Link, LinkKind, MissionNode, MissionTree

# A root (0) with two tasks, 1 and 2; below 1 the leaves 3 and 4, below 2 the leaf 5.
PARENTS = [-1, 0, 0, 1, 1, 2]


def test_containment_alone_orders_nothing_but_starts_and_ends() -> None:
    graph = EventGraph(PARENTS)
    assert graph.cycle() is None
    assert graph.path(start_of(0), end_of(3)) is not None
    assert not graph.precedes(3, 4)
    assert not graph.precedes(1, 3)


def test_precedence_between_tasks_reaches_their_leaves() -> None:
    graph = EventGraph(PARENTS, [(1, 2, "precedence")])
    assert graph.precedes(3, 5)
    assert graph.precedes(1, 2)
    assert not graph.precedes(5, 3)


def test_a_precedence_is_no_cycle_by_itself() -> None:
    graph = EventGraph(PARENTS)
    assert graph.closing_cycle(1, 2) is None
    assert graph.closing_cycle(3, 4) is None


def test_the_precedence_back_closes_a_cycle_of_both() -> None:
    graph = EventGraph(PARENTS, [(1, 2, "precedence")])
    assert graph.closing_cycle(2, 1) == [1, 2]


def test_a_cycle_through_containment_names_the_nodes_in_order() -> None:
    """5 before 3 would close: 3 ends before 1 ends, before 2 starts, before 5 starts, before 3 starts."""
    graph = EventGraph(PARENTS, [(1, 2, "precedence")])
    assert graph.closing_cycle(5, 3) == [3, 1, 2, 5]


@pytest.mark.parametrize("pair", [(1, 3), (3, 1), (0, 5), (2, 2)])
def test_precedence_with_what_contains_it_closes_a_cycle(pair: tuple[int, int]) -> None:
    assert EventGraph(PARENTS).closing_cycle(*pair) is not None


def test_until_the_end_of_what_waits_for_me_is_a_cycle() -> None:
    """1 lasts until 2 ends, and 2 cannot start before 1 has ended."""
    graph = EventGraph(PARENTS, [(1, 2, "precedence")])
    assert graph.closing_cycle(1, 2, "until") == [1, 2]
    graph = EventGraph(PARENTS, [(1, 2, "until")])
    assert graph.closing_cycle(1, 2, "precedence") == [2, 1]


def test_until_what_came_before_is_a_cycle() -> None:
    """2 must be under way when 1 ends, and cannot start before that."""
    graph = EventGraph(PARENTS, [(1, 2, "precedence")])
    assert graph.closing_cycle(2, 1, "until") == [1, 2]
    graph = EventGraph(PARENTS, [(2, 1, "until")])
    assert graph.closing_cycle(1, 2, "precedence") == [2, 1]


def test_what_lasts_until_another_ends_starts_before_that_and_is_in_no_other_order_with_it() -> None:
    graph = EventGraph(PARENTS, [(1, 2, "until")])
    assert graph.cycle() is None
    assert graph.path(start_of(1), end_of(2)) is not None
    assert graph.path(end_of(2), end_of(1)) is not None
    assert graph.path(start_of(1), start_of(2)) is None
    assert graph.path(start_of(2), start_of(1)) is None


def test_two_that_last_until_a_third_ends_cannot_be_one_after_the_other() -> None:
    """3 and 4 are both under way when 5 ends; 3 before 4 would have 3 end before 4 starts, which is before 5 and so 3 end."""
    graph = EventGraph(PARENTS, [(3, 5, "until"), (4, 5, "until")])
    assert graph.cycle() is None
    assert graph.closing_cycle(3, 4) == [4, 5, 3]


def test_links_of_robots_order_nothing() -> None:
    graph = EventGraph(PARENTS, [(1, 2, "same_robot"), (2, 1, "different_robot")])
    assert graph.cycle() is None
    assert graph.closing_cycle(2, 1, "same_robot") is None
    assert not graph.precedes(1, 2)


def test_the_graph_of_a_tree_numbers_its_nodes_in_preorder() -> None:
    nodes = (
        MissionNode(id="root", label="root", gate="and", children=("a", "b")),
        MissionNode(id="a", label="a"),
        MissionNode(id="b", label="b"),
    )
    graph = event_graph(MissionTree(objective="x", nodes=nodes, links=(Link("b", "a"),)))
    assert graph.precedes(2, 1)
    assert not graph.precedes(1, 2)


def test_deep_trees_do_not_exhaust_the_stack() -> None:
    depth = 20_000
    graph = EventGraph(range(-1, depth - 1))
    assert graph.cycle() is None
    way = graph.path(start_of(0), end_of(0))
    assert way is not None


@st.composite
def trees_with_links(draw: st.DrawFn) -> tuple[list[int], list[IndexedLink]]:
    size = draw(st.integers(min_value=2, max_value=8))
    parents = [-1, *(draw(st.integers(min_value=0, max_value=node - 1)) for node in range(1, size))]
    nodes = st.integers(min_value=0, max_value=size - 1)
    kinds: st.SearchStrategy[LinkKind] = st.sampled_from(["precedence", "until"])
    return parents, draw(st.lists(st.tuples(nodes, nodes, kinds), max_size=8))


@given(trees_with_links())
def test_a_link_closes_a_cycle_exactly_if_the_graph_with_it_has_one(case: tuple[list[int], list[IndexedLink]]) -> None:
    parents, links = case
    kept: list[IndexedLink] = []
    for link in links:
        circle = EventGraph(parents, kept).closing_cycle(*link)
        assert (circle is None) == (EventGraph(parents, [*kept, link]).cycle() is None)
        if circle is None:
            kept.append(link)
        else:
            assert set(link[:2]) <= set(circle)


@given(trees_with_links())
def test_a_cycle_is_found_exactly_if_the_events_cannot_be_sorted(case: tuple[list[int], list[IndexedLink]]) -> None:
    """Kahn's sorting takes events without predecessors away until none is left, or a cycle is."""
    parents, links = case
    graph = EventGraph(parents, links)
    waiting = [0] * len(graph.successors)
    for after in (after for successors in graph.successors for after in successors):
        waiting[after] += 1
    free = [event for event, count in enumerate(waiting) if count == 0]
    sorted_events = 0
    while free:
        sorted_events += 1
        for after in graph.successors[free.pop()]:
            waiting[after] -= 1
            if waiting[after] == 0:
                free.append(after)
    assert (graph.cycle() is None) == (sorted_events == len(graph.successors))
