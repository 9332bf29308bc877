"""The table of tours: the peer is asked the same question as ours, and both find what trying every order finds."""

from __future__ import annotations

import argparse
from itertools import pairwise, permutations

import pytest

from benchmarks.tours import FIRST_MS, Size, _ms, row, spots


@pytest.mark.parametrize("text", ["5x1", "5x1h"])
def test_ours_and_the_peer_find_the_shortest_of_a_hundred_and_twenty_orders(text: str) -> None:
    size, start = Size.parse(text), (0.0, 0.0)
    ends = [start] if size.home else []
    shortest_ms = min(
        sum(_ms(one, other) for one, other in pairwise([start, *order, *ends])) + 5 * FIRST_MS
        for order in permutations(spots(size, seed=3))
    )
    cells = row(size, 3, 0.5, ["cpsat"]).strip("| ").split(" | ")
    assert (cells[2], cells[-1]) == (f"{shortest_ms / 1000:.1f}",) * 2
    assert cells[-2].startswith("optimal, confirmed")


@pytest.mark.parametrize("text", ["5", "x", "5x", "0x1", "5x0", "5x1hh", "-5x1", "5.5x1"])
def test_sizes_that_are_none_are_refused(text: str) -> None:
    with pytest.raises(argparse.ArgumentTypeError, match="places x robots"):
        Size.parse(text)
