"""The k best ways through a bare tree: as counting and sorting finds them, at both speeds, for any shape and any ties."""

from __future__ import annotations

from itertools import islice
from typing import Any

import numpy as np
import pytest

from missiontree.allocation.arrays import TreeArrays, k_best
from missiontree.allocation.flat import Flat
from missiontree.allocation.item import choices_of
from missiontree.allocation.possible import structurally_possible
from missiontree.allocation.selection import select
from missiontree.allocation.streams import best_first, stream_of
from missiontree.mission.columns import AND, KINDS, LEAF, XOR
from tests.allocation.arrays.trees import Told, every_way, levels, random_tree, tied, told, wide

TREES, LARGER = 500, 60


def in_arrays(tree: TreeArrays) -> TreeArrays:
    return TreeArrays(*(np.array(column, dtype=np.int64) for column in (tree.kind, tree.parent, tree.utility)))


def streamed(tree: TreeArrays, k: int) -> list[Told]:
    """What the streams draw from the whole tree, nothing narrowed."""
    below: list[list[int]] = [[] for _ in range(len(tree))]
    for node in range(1, len(tree)):
        below[tree.parent[node]].append(node)
    nothing: Any = dict.fromkeys(("label", "role", "robot_type", "uses", "team", "same_robot", "different_robot"), ())
    kinds = tuple(KINDS[kind] for kind in tree.kind)
    flat = Flat(kinds, tuple(tree.parent), tuple(map(tuple, below)), utility=tuple(tree.utility), stocks={}, **nothing)
    possible = structurally_possible(flat)
    stream = stream_of(flat, possible)
    ways = [] if stream is None else islice(best_first(stream), k)
    selected = ((item.utility, select(flat, choices_of(item), possible)) for item in ways)
    return [(utility, tuple(child for _, child in way.choices), way.leaves) for utility, way in selected]


def test_random_trees_give_what_counting_gives_at_both_speeds() -> None:
    tied_lists = 0
    for seed in range(TREES):
        tree = random_tree(seed)
        ways = every_way(tree)
        for k in (1, 2, 5, 20):
            plain = told(k_best(tree, k))
            assert plain == ways[:k], (seed, k)
            assert told(k_best(in_arrays(tree), k)) == plain, (seed, k)
        tied_lists += len(ways) > 20 and ways[19][0] == ways[20][0]
    assert tied_lists > TREES // 50


def test_all_ways_are_listed_where_k_is_larger_than_their_number() -> None:
    for seed in range(TREES, TREES + LARGER):
        tree = random_tree(seed)
        ways = k_best(tree, 5_000)
        assert told(ways) == every_way(tree), seed
        assert ways.certificate.bound is None


def test_streams_over_the_whole_tree_give_the_same() -> None:
    for seed in range(LARGER):
        tree = random_tree(seed, most_ways=10**12)
        assert told(k_best(tree, 50)) == streamed(tree, 50), seed


def test_ties_go_by_the_first_choice_that_differs() -> None:
    """An AND of XORs x over 1, 2 and y over 1, 2, all leaves equal: the last XOR changes first."""
    tree = tied(2, able=2)
    assert [list(way.chosen) for way in k_best(tree, 9).ways] == [[2, 5], [2, 6], [3, 5], [3, 6]]


def test_an_earlier_child_that_is_worse_comes_first_among_equals() -> None:
    """XOR x over 4, 5 and y over 5, 4: both second bests lose 1; the one that takes x's first child has the smaller choice indices."""
    tree = TreeArrays([AND, XOR, LEAF, LEAF, XOR, LEAF, LEAF], [-1, 0, 1, 1, 0, 4, 4], [0, 0, 4, 5, 0, 5, 4])
    assert [list(way.chosen) for way in k_best(tree, 2).ways] == [[3, 5], [2, 5]]
    assert [list(way.chosen) for way in k_best(tree, 3).ways] == [[3, 5], [2, 5], [3, 6]]


@pytest.mark.parametrize("fast", [False, True])
def test_a_chain_of_fifty_thousand_gates(fast: bool) -> None:
    """The leaf of level d earns d % 3, and stands before all deeper ones: levels 2, 5, 8 are the first of the best."""
    ways = k_best(levels(50_000), 3, compiled=fast).ways
    assert [(way.utility, len(way.chosen), int(way.leaves[0])) for way in ways] == [(2, 3, 5), (2, 6, 11), (2, 9, 17)]


@pytest.mark.parametrize("fast", [False, True])
def test_a_hundred_thousand_children(fast: bool) -> None:
    equal = told(k_best(wide(XOR, 100_000, -3), 3, compiled=fast))
    assert equal == [(-3, (1,), (1,)), (-3, (2,), (2,)), (-3, (3,), (3,))]
    ((utility, chosen, leaves),) = told(k_best(wide(AND, 100_000), 3, compiled=fast))
    assert (utility, chosen, leaves) == (100_000, (), tuple(range(1, 100_001)))


@pytest.mark.parametrize("fast", [False, True])
def test_massive_ties_under_a_wide_and(fast: bool) -> None:
    """3 ** 20,000 equal ways: the last XOR's children by turns, then the last but one's second with them."""
    ways = k_best(tied(20_000), 5, compiled=fast).ways
    assert [[int(child) % 4 for child in way.chosen[-2:]] for way in ways] == [[2, 2], [2, 3], [2, 0], [3, 2], [3, 3]]
    assert {way.utility for way in ways} == {140_000}
    assert all(set(map(int, way.chosen[:-2])) == set(range(2, 79_992, 4)) for way in ways)


def test_an_xor_of_one_is_a_choice_and_no_option() -> None:
    tree = TreeArrays([XOR, XOR, LEAF], [-1, 0, 1], [0, 0, 4])
    assert told(k_best(tree, 3)) == [(4, (1, 2), (2,))]


def test_nothing_found_is_no_empty_way() -> None:
    ways = k_best(TreeArrays([AND, LEAF, XOR], [-1, 0, 0], [0, 1, 0]), 3)
    assert ways.ways == ()
    assert ways.certificate.claim == "proven"
    assert told(k_best(TreeArrays([AND], [-1], [0]), 3)) == [(0, (), ())]


def test_sums_beyond_64_bits_are_added_up_all_the_same() -> None:
    huge = (1 << 62) - 1
    tree = TreeArrays([AND, LEAF, XOR, LEAF, LEAF], [-1, 0, 0, 2, 2], [0, huge, 0, huge, -huge])
    assert [way.utility for way in k_best(in_arrays(tree), 2).ways] == [2 * huge, 0]
    large = TreeArrays(tree.kind, tree.parent, [0, huge << 9, 0, huge << 9, 1])
    assert [way.utility for way in k_best(large, 2, compiled=True).ways] == [huge << 10, (huge << 9) + 1]


def test_the_bound_is_the_utility_of_the_last() -> None:
    ways = k_best(tied(3), 4)
    assert (ways.certificate.claim, ways.certificate.bound) == ("proven", 21.0)


def test_a_tree_is_left_as_it_was() -> None:
    tree = in_arrays(tied(3))
    before = [list(column) for column in (tree.kind, tree.parent, tree.utility)]
    k_best(tree, 4)
    assert before == [list(column) for column in (tree.kind, tree.parent, tree.utility)]


def test_bad_questions_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(ValueError, match="k must be at least 1, got 0"):
        k_best(tied(1), 0)
    monkeypatch.setattr("missiontree.allocation.arrays.best.can_compile", lambda: False)
    with pytest.raises(ValueError, match="need numba"):
        k_best(tied(1), 1, compiled=True)
    assert isinstance(k_best(in_arrays(tied(1)), 1).ways[0].chosen, list)
