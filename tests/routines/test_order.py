"""Orders added for moved entities: never a cycle, never two uses left open, nothing added that is there already."""

from __future__ import annotations

from itertools import combinations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.errors import InputError
from missiontree.mission.entity import Entity
from missiontree.mission.precedence import event_graph
from missiontree.mission.tree import Link, MissionNode, MissionTree
from missiontree.routines.calls import calls_of
from missiontree.routines.order import RoutineOrder, order_moved
from tests.builders import brief_of, flat_tree, routine_node

ENTITIES = tuple(Entity(id=name, kind="person") for name in "xyz")


def bring(name: str, agent: str = "x", location: str = "y") -> MissionNode:
    return routine_node(name, "ReachAndTransport", agent=agent, location=location)


def follow(name: str, agent: str = "x") -> MissionNode:
    return routine_node(name, "Follow", agent=agent)


def added(tree: MissionTree) -> list[tuple[str, str]]:
    brief = brief_of(tree)
    calls = calls_of(tree, brief, brief.world.extended(tree.entities))
    links, notices = order_moved(tree, calls, RoutineOrder(tree))
    assert len(links) == len(notices)
    return [(link.first, link.second) for link in links]


def flat(*leaves: MissionNode, links: tuple[Link, ...] = ()) -> MissionTree:
    return flat_tree(*leaves, links=links, entities=ENTITIES)


def test_users_between_two_moves_are_ordered_against_both_and_not_against_each_other() -> None:
    tree = flat(bring("m1"), follow("u1"), follow("u2"), bring("m2"), follow("u3"))
    # m1 before m2 follows by way of u1; u3 comes after m2 only.
    assert set(added(tree)) == {("m1", "u1"), ("m1", "u2"), ("u1", "m2"), ("u2", "m2"), ("m2", "u3")}


def test_the_location_is_used_too() -> None:
    assert added(flat(bring("a", "x", "y"), bring("b", "y", "z"))) == [("a", "b")]


def test_a_place_that_nobody_moves_orders_nothing() -> None:
    assert added(flat(bring("a", "x", "z"), bring("b", "y", "z"))) == []


def test_given_orders_come_first_then_the_tree() -> None:
    # c before a is given; b is free: before c and a by the tree's order? b stands after a, and a waits for c.
    tree = flat(bring("a"), bring("b"), bring("c"), links=(Link("c", "a"),))
    assert added(tree) == [("a", "b")]  # c, a, b


def test_an_order_of_inner_nodes_counts() -> None:
    nodes = (
        MissionNode(id="root", label="r", gate="and", children=("late", "early")),
        MissionNode(id="late", label="l", gate="and", children=("f",)),
        follow("f"),
        MissionNode(id="early", label="e", gate="and", children=("m",)),
        bring("m"),
    )
    assert added(MissionTree(objective="o", nodes=nodes, entities=ENTITIES, links=(Link("early", "late"),))) == []
    assert added(MissionTree(objective="o", nodes=nodes, entities=ENTITIES)) == [("f", "m")]


def test_alternatives_are_never_ordered() -> None:
    nodes = (
        MissionNode(id="root", label="r", gate="xor", children=("m", "f")),
        bring("m"),
        follow("f"),
    )
    assert added(MissionTree(objective="o", nodes=nodes, entities=ENTITIES)) == []


def test_an_order_by_way_of_a_node_that_may_not_be_there_is_no_order() -> None:
    nodes = (
        MissionNode(id="root", label="r", gate="and", children=("m1", "either", "m2")),
        bring("m1"),
        MissionNode(id="either", label="e", gate="xor", children=("s", "t")),
        routine_node("s", "Search", agent="z"),
        routine_node("t", "Search", agent="z"),
        bring("m2"),
    )
    links = (Link("m1", "s"), Link("s", "m2"))
    assert added(MissionTree(objective="o", nodes=nodes, entities=ENTITIES, links=links)) == [("m1", "m2")]
    # By way of the XOR itself, which is always there, it is one.
    links = (Link("m1", "either"), Link("either", "m2"))
    assert added(MissionTree(objective="o", nodes=nodes, entities=ENTITIES, links=links)) == []


def test_what_lasts_until_another_ends_is_not_ordered_with_it() -> None:
    assert added(flat(follow("a"), bring("b"), links=(Link("a", "b", "until"),))) == []
    assert added(flat(bring("b"), follow("a"), links=(Link("a", "b", "until"),))) == []


def test_an_until_between_tasks_leaves_all_below_them_free() -> None:
    nodes = (
        MissionNode(id="root", label="r", gate="and", children=("shadow", "work")),
        MissionNode(id="shadow", label="s", gate="and", children=("f1", "f2")),
        follow("f1"),
        follow("f2"),
        MissionNode(id="work", label="w", gate="and", children=("m",)),
        bring("m"),
    )
    tree = MissionTree(objective="o", nodes=nodes, entities=ENTITIES, links=(Link("shadow", "work", "until"),))
    assert added(tree) == []


def test_a_third_is_ordered_with_both_that_overlap() -> None:
    # u stands before and after: f overlaps b, and u is ordered with the move b alone; f moves nobody.
    until = (Link("f", "b", "until"),)
    assert added(flat(follow("u"), follow("f"), bring("b"), links=until)) == [("u", "b")]
    assert added(flat(follow("f"), bring("b"), follow("u"), links=until)) == [("b", "u")]
    # The move m stands before the move b, which f overlaps. f starts late on the line, after m.
    assert set(added(flat(bring("m"), follow("f"), bring("b"), links=until))) == {("m", "f"), ("m", "b")}


def test_a_cycle_is_named() -> None:
    tree = flat(follow("a"), follow("b"), links=(Link("a", "b"), Link("b", "a")))
    with pytest.raises(InputError, match="wait for each other"):
        RoutineOrder(tree)


@st.composite
def missions(draw: st.DrawFn) -> MissionTree:
    """Tasks of both gates two levels deep over moves and uses of three entities, with any links that make no cycle."""
    nodes: list[MissionNode] = []
    groups = draw(st.integers(1, 4))
    for group in range(groups):
        names = [f"n{group}_{i}" for i in range(draw(st.integers(1, 3)))]
        gate = draw(st.sampled_from(["and", "xor"]))
        nodes.append(MissionNode(id=f"g{group}", label="g", gate=gate, children=tuple(names)))  # type: ignore[arg-type]
        for name in names:
            agent, location = draw(st.permutations("xyz"))[:2]
            nodes.append(bring(name, agent, location) if draw(st.booleans()) else follow(name, agent))
    root = MissionNode(id="root", label="r", gate="and", children=tuple(f"g{group}" for group in range(groups)))
    tree = MissionTree(objective="o", nodes=(root, *nodes), entities=ENTITIES)
    links: list[Link] = []
    names = [node.id for node in tree.nodes[1:]]
    pairs = st.tuples(st.sampled_from(names), st.sampled_from(names), st.sampled_from(["precedence", "until"]))
    for first, second, kind in draw(st.lists(pairs, max_size=5)):
        if tree.contains(first, second) or tree.contains(second, first):
            continue
        tried = MissionTree(
            objective="o",
            nodes=tree.nodes,
            entities=ENTITIES,
            links=(*links, Link(first, second, kind)),  # type: ignore[arg-type]
        )
        if event_graph(tried).cycle() is None:
            links.append(tried.links[-1])
    return MissionTree(objective="o", nodes=tree.nodes, entities=ENTITIES, links=tuple(links))


def selections(tree: MissionTree) -> list[set[str]]:
    """Every set of nodes that may be selected together: one child of each XOR group, in all ways."""
    ways: list[set[str]] = [{"root"}]
    for group in tree.root.children:
        node = tree.by_id[group]
        options = [set(node.children)] if node.gate == "and" else [{child} for child in node.children]
        ways = [way | option | {group} for way in ways for option in options]
    return ways


def joined(tree: MissionTree, first: str, second: str) -> bool:
    """Whether an until link joins nodes that are or contain the two."""
    return any(
        tree.contains(one, first) and tree.contains(other, second)
        for link in tree.links
        if link.kind == "until"
        for one, other in ((link.first, link.second), (link.second, link.first))
    )


@given(missions())
def test_every_use_of_a_moved_entity_is_ordered_in_every_selection(tree: MissionTree) -> None:
    """Whatever is chosen, a move of an entity and any other use of it are ordered by links among chosen nodes alone."""
    brief = brief_of(tree)
    calls = calls_of(tree, brief, brief.world.extended(tree.entities))
    links, _ = order_moved(tree, calls, RoutineOrder(tree))
    everything = MissionTree(objective="o", nodes=tree.nodes, entities=ENTITIES, links=(*tree.links, *links))
    whole = event_graph(everything)
    assert whole.cycle() is None
    for chosen in selections(tree):
        binding = tuple(link for link in everything.links if {link.first, link.second} <= chosen)
        graph = event_graph(MissionTree(objective="o", nodes=tree.nodes, entities=ENTITIES, links=binding))
        number = {node.id: index for index, node in enumerate(tree.nodes)}
        leaves = [node.id for node in tree.nodes if node.routine and node.id in chosen]
        for first, second in combinations(leaves, 2):
            one, two = calls[first].touch, calls[second].touch
            if set(one.moves) & set(two.uses) or set(two.moves) & set(one.uses):
                a, b = number[first], number[second]
                if joined(tree, first, second):
                    continue  # meant to overlap
                kept_apart = graph.precedes(a, b) or graph.precedes(b, a)
                held_together = whole.closing_cycle(a, b) and whole.closing_cycle(b, a)
                assert kept_apart or held_together, (first, second, chosen)


@given(missions())
def test_the_same_tree_gets_the_same_orders_and_a_second_look_adds_nothing(tree: MissionTree) -> None:
    once = added(tree)
    assert once == added(tree)
    links = (*tree.links, *(Link(first, second) for first, second in once))
    assert added(MissionTree(objective="o", nodes=tree.nodes, entities=ENTITIES, links=links)) == []
