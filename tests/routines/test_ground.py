"""A mission tree over a fleet: the paper's numbers, links, order, and input that is refused."""

from __future__ import annotations

from dataclasses import replace
from itertools import product

import pytest

from missiontree.errors import InputError
from missiontree.mission.brief import MissionBrief
from missiontree.mission.estimate import Weights
from missiontree.mission.grounded import GroundedTree, Grounding
from missiontree.mission.scene import Scene
from missiontree.mission.tree import Link, MissionNode
from missiontree.routines.ground import ground
from missiontree.routines.library import built_in
from tests.builders import (
    actions_of,
    flat_tree,
    grounding_of,
    paper_fleet,
    people,
    rescue_tree,
    reunite_tree,
    routine_node,
)


def staffings(tree: GroundedTree, node: int = 0) -> list[tuple[int, ...]]:
    """Every choice of leaves, by brute force; small trees only."""
    if tree.nodes[node].kind == "action":
        return [(node,)]
    below = [staffings(tree, child) for child in tree.children[node]]
    if tree.nodes[node].kind == "xor":
        return [choice for choices in below for choice in choices]
    return [tuple(leaf for part in parts for leaf in part) for parts in product(*below)]


def utilities(grounding: Grounding) -> list[float]:
    tree, weights = grounding.tree, Weights()
    sums = (sum(weights.utility_micro(tree.action(leaf).estimate) for leaf in leaves) for leaves in staffings(tree))
    return sorted((total / 1e6 for total in sums), reverse=True)


def texts(tree: GroundedTree, leaves: tuple[int, ...]) -> list[str]:
    return [tree.action(leaf).text for leaf in leaves]


# The paper's numbers (design section 13)


def test_reunite_has_the_papers_four_alternatives() -> None:
    # Search: Tele-Robot 3 * 1.0 or Transportation Robot 3 * 0.3. Then 2 * 0.3 reaching and 2 * 1.0 by either of the two ways.
    assert utilities(grounding_of(reunite_tree())) == [5.6, 5.6, 3.5, 3.5]


def test_rescue_with_kinds_on_and_off() -> None:
    # Two searches (3.0 or 0.9 each) and 2.6: 8.6, 6.5 twice, 4.4; all of it twice if the cat could read.
    assert utilities(grounding_of(rescue_tree())) == [8.6, 6.5, 6.5, 4.4]
    assert utilities(grounding_of(rescue_tree(), check_kinds=False)) == [8.6] * 2 + [6.5] * 4 + [4.4] * 2


def test_reunite_says_it_in_the_papers_words() -> None:
    tree = grounding_of(reunite_tree()).tree
    search = ["Get search path to find Child", "Detect Child", "Report detection of Child to server"]
    reach = ["Get Child location to reach", "Get to Child location"]
    carry, message = (texts(tree, leaves) for leaves in staffings(tree)[:2])
    assert carry == [*search, *reach, "Carry Child", "Get to Mom location"]
    assert message == [
        *search,
        *reach,
        "Display message to Child to follow Social Robot to Mom",
        "Get to Mom location",
    ]


def test_each_action_keeps_the_rating_of_its_part() -> None:
    leaves = staffings(grounding_of(reunite_tree()).tree)[0]
    tree = grounding_of(reunite_tree()).tree
    assert [tree.action(leaf).capability for leaf in leaves] == ["search"] * 3 + ["reach"] * 2 + ["carry"] * 2
    assert [tree.action(leaf).estimate.quality for leaf in leaves] == [1, 1, 1, 0.3, 0.3, 1, 1]


def test_links_of_the_mission_are_mapped() -> None:
    tree = reunite_tree()
    grounding = grounding_of(
        replace(tree, links=(Link("search", "reunite"), Link("locate", "transport", "different_robot")))
    )
    sources = [
        (grounding.tree.nodes[link.first].source, grounding.tree.nodes[link.second].source, link.kind)
        for link in grounding.tree.links
    ]
    assert sources == [("search", "reunite", "precedence"), ("locate", "transport", "different_robot")]


# Order of uses of one entity


def orders(grounding: Grounding) -> set[tuple[str | None, str | None]]:
    nodes = grounding.tree.nodes
    return {
        (nodes[link.first].source, nodes[link.second].source)
        for link in grounding.tree.links
        if link.kind == "precedence"
    }


def test_a_move_and_another_use_get_the_order_of_the_tree_with_a_notice() -> None:
    bring = routine_node("bring", "ReachAndTransport", agent="x", location="y")
    follow = routine_node("follow", "Follow", agent="x")
    grounding = grounding_of(flat_tree(bring, follow, entities=people("x", "y")))
    assert orders(grounding) == {("bring", "follow")}
    (notice,) = grounding.notices
    assert (notice.rule, notice.severity, notice.node) == ("order_added", "notice", "bring")
    assert "moves x" in notice.message


def test_a_given_order_stands() -> None:
    bring = routine_node("bring", "ReachAndTransport", agent="x", location="y")
    follow = routine_node("follow", "Follow", agent="x")
    grounding = grounding_of(flat_tree(bring, follow, entities=people("x", "y"), links=(Link("follow", "bring"),)))
    assert (orders(grounding), grounding.notices) == ({("follow", "bring")}, ())


def test_two_searches_need_no_order() -> None:
    nodes = [routine_node(f"n{i}", "Search", agent="x") for i in range(2)]
    assert orders(grounding_of(flat_tree(*nodes, entities=people("x")))) == set()


# Bad input


@pytest.mark.parametrize(
    ("node", "message"),
    [
        (routine_node("n", "Serach", agent="x"), "Did you mean 'Search'"),
        (routine_node("n", "Search", agent="alicf"), "Did you mean 'alice'"),
        (routine_node("n", "Search", thing="x"), "no argument 'thing'"),
        (routine_node("n", "Transport", agent="x"), "lacks its argument 'location'"),
        (routine_node("n", "Search", resources=("tele_robto",), agent="x"), "Did you mean 'tele_robot'"),
        (MissionNode(id="n", label="Think"), "'Think' is a leaf"),
    ],
)
def test_what_nobody_knows_is_bad_input(node: MissionNode, message: str) -> None:
    with pytest.raises(InputError, match=message) as caught:
        grounding_of(flat_tree(node, entities=people("x", "alice")))
    assert caught.value.where.startswith("n")


def test_entities_that_stand_twice_are_bad_input() -> None:
    tree = flat_tree(routine_node("n", "Search", agent="x"), entities=people("x"))
    with pytest.raises(InputError, match="stands twice"):
        grounding_of(tree, scene=Scene(entities=people("x")))


def test_links_that_contradict_each_other_are_bad_input() -> None:
    nodes = [routine_node(name, "Search", agent="x") for name in "abc"]
    links = (Link("a", "b"), Link("b", "c"), Link("c", "a"))
    with pytest.raises(InputError, match="wait for each other"):
        grounding_of(flat_tree(*nodes, links=links, entities=people("x")))


def test_wire_names_are_accepted() -> None:
    tree = flat_tree(routine_node("n", "SearchTree", agent="x"), entities=people("x"))
    assert len(actions_of(grounding_of(tree).tree)) == 6


def test_a_brief_is_all_it_takes() -> None:
    brief = MissionBrief(text="m", fleet=paper_fleet(), routines=built_in())
    assert ground(reunite_tree(), brief) == ground(reunite_tree(), brief)
