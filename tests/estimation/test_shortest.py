"""The resumable Dijkstra."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.estimation.shortest import ShortestTree

STEPS = {0: [(1, 2.0), (2, 2.0)], 1: [(3, 1.0)], 2: [(3, 1.0)], 3: [], 4: [(0, 1.0)]}


def test_costs_and_ways() -> None:
    tree = ShortestTree(0, lambda node: STEPS[node])
    assert tree.cost(3) == 3
    assert tree.cost(0) == 0
    assert tree.way(0) == [0]
    # both 0-1-3 and 0-2-3 cost 3: the smaller node number wins
    assert tree.way(3) == [0, 1, 3]


def test_what_cannot_be_reached_costs_none_and_has_no_way() -> None:
    tree = ShortestTree(0, lambda node: STEPS[node])
    assert tree.cost(4) is None
    with pytest.raises(KeyError):
        tree.way(4)


def test_it_goes_only_as_far_as_it_is_asked() -> None:
    asked = []

    def line(node: int) -> list[tuple[int, float]]:
        asked.append(node)
        return [(node + 1, 1.0)]

    tree = ShortestTree(0, line)
    assert tree.cost(5) == 5
    assert asked == [0, 1, 2, 3, 4, 5]
    assert tree.cost(3) == 3
    assert asked == [0, 1, 2, 3, 4, 5]  # nothing was asked twice


edges = st.lists(st.tuples(st.integers(0, 7), st.integers(0, 7), st.integers(0, 9)), max_size=24)


@given(edges, st.permutations(range(8)))
def test_the_order_of_questions_does_not_matter_and_bellman_ford_agrees(
    drawn: list[tuple[int, int, int]], order: list[int]
) -> None:
    tree = ShortestTree(0, lambda node: [(end, float(cost)) for start, end, cost in drawn if start == node])
    best = {0: 0}
    for _ in range(8):
        for start, end, cost in drawn:
            if start in best:
                best[end] = min(best.get(end, 10**9), best[start] + cost)
    for node in order:
        assert tree.cost(node) == best.get(node)
