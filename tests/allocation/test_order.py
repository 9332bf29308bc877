"""The place of every way in the order of choices, as a sum over its choices."""

from __future__ import annotations

from hypothesis import given, settings

from benchmarks.random_trees import Case
from missiontree.allocation.exhaustive import every_selection
from missiontree.allocation.flat import flatten
from missiontree.allocation.order import order_of
from missiontree.allocation.possible import structurally_possible
from missiontree.mission.estimate import Weights
from tests.builders import and_, grounded, leaf, trivial_fleet, xor_
from tests.strategies import cases


@settings(max_examples=200)
@given(cases())
def test_places_count_up_in_the_order_of_choices(case: Case) -> None:
    """The oracle's odometer runs in that order: its ways have the places 0, 1, 2 and so on."""
    flat = flatten(case.tree, case.fleet, case.weights)
    possible = structurally_possible(flat)
    if not possible[0]:
        return
    order = order_of(flat, possible)
    assert order is not None
    places = [-order.score(0, way.choices) for way in every_selection(flat) if way is not None]
    assert places == list(range(order.ways))


def test_utility_comes_first() -> None:
    flat = flatten(grounded(xor_(leaf("a"), leaf("b"))), trivial_fleet(), Weights())
    order = order_of(flat, [True] * 3)
    assert order is not None
    # Two ways: with equal points the first is greater, and one point outweighs both places.
    assert order.score(5, [(0, 1)]) > order.score(5, [(0, 2)]) > order.score(4, [(0, 1)])


def test_too_many_ways_to_count() -> None:
    flat = flatten(grounded(and_(*(xor_(leaf(f"a{n}"), leaf(f"b{n}")) for n in range(20)))), trivial_fleet(), Weights())
    possible = [True] * len(flat.kind)
    assert order_of(flat, possible, max_bits=19) is None
    order = order_of(flat, possible, max_bits=20)
    assert order is not None
    assert order.ways == 2**20
