"""What is no tree is refused, and the first wrong node is named; in lists and in arrays alike."""

from __future__ import annotations

import numpy as np
import pytest

from missiontree.allocation.arrays import TreeArrays

WRONG = [
    ([1, 0], [-1], [0, 0], "columns must be of one length, got 2, 1 and 2"),
    ([], [], [], "at least one node"),
    ([1, 0], [0, 0], [0, 0], "node 0 is the root and has parent -1, got 0"),
    ([1, 3, 4], [-1, 0, 0], [0, 0, 0], "node 1 is of kind 3"),
    ([1, 0, 0], [-1, 0, 2], [0, 0, 0], "node 2 has parent 2; parents come before"),
    ([1, 0, 0], [-1, 0, -1], [0, 0, 0], "node 2 has parent -1"),
    ([1, 0, 0], [-1, 0, 1], [0, 0, 0], "node 2 has parent 1, which is a leaf"),
    ([1, 0, 2], [-1, 0, 0], [0, 5, 6], "node 2 is a gate with utility 6"),
]


@pytest.mark.parametrize(("kind", "parent", "utility", "message"), WRONG)
def test_what_is_no_tree_is_refused(kind: list[int], parent: list[int], utility: list[int], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        TreeArrays(kind, parent, utility)
    with pytest.raises(ValueError, match=message):
        TreeArrays(*(np.array(column, dtype=np.int64) for column in (kind, parent, utility)))


def test_numbers_that_are_not_whole_are_refused() -> None:
    with pytest.raises(ValueError, match="utility must hold whole numbers only"):
        TreeArrays([0], [-1], [0.5])  # type: ignore[list-item]
    with pytest.raises(ValueError, match="utility must hold whole numbers in one dimension, got float64 in 1"):
        TreeArrays([0], [-1], np.array([0.5]))
    with pytest.raises(ValueError, match="must fit into 64 bits"):
        TreeArrays([0], [-1], np.array([1 << 63], dtype=np.uint64))


def test_smaller_integers_become_64_bits_wide() -> None:
    tree = TreeArrays(*(np.array(column, dtype=np.int8) for column in ([1, 0], [-1, 0], [0, -9])))
    assert {np.asarray(column).dtype for column in (tree.kind, tree.parent, tree.utility)} == {np.dtype(np.int64)}


def test_no_way_earns_more_than_the_span() -> None:
    """One list is added up exactly, an array is bounded by its largest number."""
    assert TreeArrays([1, 0, 0], [-1, 0, 0], [0, -5, 3]).span == 8
    arrays = [np.array(column) for column in ([1, 0, 0], [-1, 0, 0], [0, -5, 3])]
    assert TreeArrays(*arrays).span == 15
