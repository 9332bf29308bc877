"""A tree made smaller: how small, what stays, what is said of the rest."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.reporting.tree.folding import LEAST_SHOWN, folded
from missiontree.reporting.tree.shape import Shape
from tests.reporting.shapes import shapes
from tests.reporting.tree_builders import Sprout, routine, shape, task


@given(shapes(80), st.integers(1, 60))
def test_no_more_nodes_than_asked_for_and_every_node_is_there_or_counted(whole: Shape, most: int) -> None:
    small = folded(whole, most)
    assert len(small.nodes) <= most
    counted = sum(node.hidden for node in small.nodes)
    stand_ins = sum(node.kind == "more" for node in small.nodes)
    assert len(small.nodes) - stand_ins + counted == len(whole.nodes)


@given(shapes(80), st.integers(1, 60))
def test_what_is_shown_keeps_its_parent_its_order_and_its_links(whole: Shape, most: int) -> None:
    small = folded(whole, most)
    at = {node.name: number for number, node in enumerate(small.nodes) if node.kind != "more"}
    for number, node in enumerate(whole.nodes):
        if node.name in at:
            shown = [whole.nodes[child].name for child in whole.children[number] if whole.nodes[child].name in at]
            own = [small.nodes[child] for child in small.children[at[node.name]]]
            assert [child.name for child in own if child.kind != "more"] == shown
            assert all(child.kind != "more" for child in own[:-1])  # the card for the rest stands last
            assert all(child > at[node.name] for child in small.children[at[node.name]])
    expected = [
        (at[whole.nodes[first].name], at[whole.nodes[second].name], kind)
        for first, second, kind in whole.links
        if whole.nodes[first].name in at and whole.nodes[second].name in at
    ]
    assert list(small.links) == expected


@given(shapes(80), st.integers(1, 60))
def test_nothing_that_is_chosen_is_folded_while_there_is_room_to_show_it(whole: Shape, most: int) -> None:
    """Every chosen node needs a card, and all its parts that are not chosen need one together."""
    small = folded(whole, most)
    chosen = [number for number, node in enumerate(whole.nodes) if node.state == "lit"]
    others = sum(any(whole.nodes[child].state != "lit" for child in whole.children[number]) for number in chosen)
    if chosen and len(chosen) + others <= most:
        names = {node.name for node in small.nodes if not node.hidden}
        assert {whole.nodes[number].name for number in chosen} <= names


@given(shapes(80), st.integers(1, 60))
def test_of_a_tree_with_nothing_chosen_the_deepest_are_folded_first(whole: Shape, most: int) -> None:
    small = folded(whole, most)
    if any(node.state != "plain" or node.kind == "more" for node in small.nodes):
        return
    depth = [0] * len(small.nodes)
    for number, below in enumerate(small.children):
        for child in below:
            depth[child] = depth[number] + 1
    closed = [depth[number] for number, node in enumerate(small.nodes) if node.hidden]
    opened = [depth[number] for number, below in enumerate(small.children) if below]
    assert not closed or not opened or min(closed) >= max(opened)


def bush(wide: int, name: str = "t") -> Sprout:
    return task(name, *(routine(f"{name}{number}") for number in range(wide)))


def test_a_tree_that_fits_stays_as_it_is() -> None:
    tree = shape(bush(3))
    assert folded(tree, 4) is tree


def test_subtrees_become_cards_that_say_how_much_they_hold() -> None:
    small = folded(shape(task("all", bush(20, "a"), bush(3, "b"), routine("c"))), 5)
    assert [(node.label, node.hidden, node.gate) for node in small.nodes] == [
        ("all", 0, "and"),
        ("a", 20, None),
        ("b", 3, None),
        ("c", 0, None),
    ]


def test_of_too_many_siblings_some_are_shown_and_a_card_counts_the_rest() -> None:
    small = folded(shape(bush(490)), 11)
    assert [node.label for node in small.nodes] == ["t", *(f"t{number}" for number in range(9)), "and 481 more"]
    assert small.nodes[-1].hidden == 481


def test_few_of_many_are_not_shown_at_all() -> None:
    """A share of one card less than the least is no use: the parent stays folded."""
    assert len(folded(shape(bush(100)), LEAST_SHOWN).nodes) == 1
    assert len(folded(shape(bush(100)), LEAST_SHOWN + 1).nodes) == LEAST_SHOWN + 1


def test_the_chosen_ones_among_too_many_siblings_are_shown_first() -> None:
    options = [routine(f"o{number}", state="lit" if number == 70 else "quiet") for number in range(100)]
    small = folded(shape(task("one of", *options, gate="xor", state="lit")), 11)
    assert [node.label for node in small.nodes if node.state == "lit"] == ["one of", "o70"]
    assert small.nodes[-1].state == "quiet"


def test_a_node_with_too_many_parts_does_not_keep_its_neighbours_folded() -> None:
    """Six may be shown: three below the root; of the three left, the small one takes two, the large one would show one of 30."""
    small = folded(shape(task("all", bush(2, "a"), bush(30, "b"), routine("c"))), 6)
    assert [(node.label, node.hidden) for node in small.nodes] == [
        ("all", 0),
        ("a", 0),
        ("a0", 0),
        ("a1", 0),
        ("b", 30),
        ("c", 0),
    ]


def test_where_there_is_no_room_one_card_stands_for_all_that_is_not_chosen() -> None:
    options = [task(f"o{n}", *(routine(f"o{n}.{m}", state="quiet") for m in range(5)), state="quiet") for n in range(6)]
    best = task("best", routine("first", state="lit"), routine("second", state="lit"), state="lit")
    small = folded(shape(task("one of", *options, best, gate="xor", state="lit")), 5)
    assert [(node.label, node.hidden) for node in small.nodes] == [
        ("one of", 0),
        ("best", 0),
        ("first", 0),
        ("second", 0),
        ("and 6 more", 36),
    ]


def test_frames_stay_round_what_is_shown() -> None:
    tree = shape(task("all", task("f", bush(2, "a")), bush(30, "b")), frames=("f", "b"))
    small = folded(tree, 6)
    assert [small.nodes[frame].label for frame in small.frames] == ["f"]


@pytest.mark.parametrize("most", [1, 2, 3])
def test_even_the_root_may_be_folded(most: int) -> None:
    small = folded(shape(bush(9)), most)
    assert [(node.label, node.hidden) for node in small.nodes] == [("t", 9)]


def test_a_deep_tree_needs_no_recursion() -> None:
    size = 20_000
    node = shape(routine("x")).nodes[0]
    chain = Shape((node,) * size, (*((number + 1,) for number in range(size - 1)), ()), ())
    small = folded(chain, 100)
    assert len(small.nodes) == 100
    assert small.nodes[-1].hidden == size - 100
