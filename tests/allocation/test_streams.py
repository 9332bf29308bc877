"""Streams draw all ways of doing a tree, best first, ties by choice indices."""

from __future__ import annotations

from itertools import islice

from hypothesis import given, settings

from benchmarks.random_trees import Case
from missiontree.allocation.exhaustive import every_selection
from missiontree.allocation.flat import Flat, flatten
from missiontree.allocation.item import choices_of
from missiontree.allocation.possible import structurally_possible
from missiontree.allocation.selection import select
from missiontree.allocation.streams import best_first, stream_of
from missiontree.mission.estimate import Weights
from tests.builders import Spec, and_, grounded, leaf, trivial_fleet, xor_
from tests.strategies import cases


def drawn(flat: Flat, count: int | None = None) -> list[tuple[int, tuple[tuple[int, int], ...]]]:
    possible = structurally_possible(flat)
    stream = stream_of(flat, possible)
    if stream is None:
        return []
    return [
        (item.utility, select(flat, choices_of(item), possible).choices) for item in islice(best_first(stream), count)
    ]


def flat_of(root: Spec) -> Flat:
    return flatten(grounded(root), trivial_fleet(), Weights())


def either(label: str, *qualities: float) -> Spec:
    return xor_(*(leaf(f"{label}{place}", quality=quality) for place, quality in enumerate(qualities)), label=label)


@settings(max_examples=300)
@given(cases())
def test_a_stream_is_the_sorted_list_of_all_ways(case: Case) -> None:
    flat = flatten(case.tree, case.fleet, case.weights)
    ways = [selection for selection in every_selection(flat) if selection is not None]
    # Enumeration is in the order of choice indices and sorting is stable, so ties keep it.
    ways.sort(key=lambda way: -sum(flat.utility[node] for node in way.leaves))
    expected = [(sum(flat.utility[node] for node in way.leaves), way.choices) for way in ways]
    assert drawn(flat) == expected


def test_ties_go_by_the_first_choice_that_differs() -> None:
    # Preorder: 0 and, 1 xor x, 2 3 leaves, 4 xor y, 5 6 leaves. Sums: 1 + 2, then 0 + 2 = 1 + 1, then 0 + 1.
    flat = flat_of(and_(either("x", 0, 1), either("y", 1, 2)))
    assert drawn(flat) == [
        (3_000_000, ((1, 3), (4, 6))),
        (2_000_000, ((1, 2), (4, 6))),
        (2_000_000, ((1, 3), (4, 5))),
        (1_000_000, ((1, 2), (4, 5))),
    ]


def test_negative_utilities_and_an_xor_of_one() -> None:
    # u = -duration: the quicker leaf first, and the XOR of one stands among the choices.
    tree = grounded(
        and_(xor_(leaf("only", duration_s=1)), xor_(leaf("slow", duration_s=3), leaf("quick", duration_s=2)))
    )
    flat = flatten(tree, trivial_fleet(), Weights(0, 1, 0))
    assert drawn(flat) == [(-3_000_000, ((1, 2), (3, 5))), (-4_000_000, ((1, 2), (3, 4)))]


def test_an_impossible_child_is_skipped_and_keeps_its_position() -> None:
    # Children of node 0: 1 (impossible), 2.
    assert drawn(flat_of(xor_(xor_(), leaf("a")))) == [(1_000_000, ((0, 2),))]


def test_nothing_found_is_not_an_empty_plan() -> None:
    assert drawn(flat_of(and_(leaf("a"), xor_()))) == []


def test_only_what_is_asked_for_is_drawn() -> None:
    """50 XORs of 2 have 2**50 ways; the first five of them are no trouble."""
    flat = flat_of(and_(*(either(f"x{number}_", 1, 0) for number in range(50))))
    # All ones make 50; 49 are left by switching any one XOR, the last one first (its choice indices are smallest before).
    assert [utility // 1_000_000 for utility, _ in drawn(flat, 5)] == [50, 49, 49, 49, 49]
    switched = [
        [place for place, (xor, child) in enumerate(choices) if child == xor + 2] for _, choices in drawn(flat, 5)
    ]
    assert switched == [[], [49], [48], [47], [46]]
