"""Purses: only those that can be overdrawn, in their own units, packed so that sums and limits are one addition each."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from missiontree.allocation.flat import flatten
from missiontree.allocation.possible import structurally_possible
from missiontree.allocation.purses import Purses, purses_of
from missiontree.mission.estimate import Weights
from tests.builders import and_, grounded, leaf, trivial_fleet, xor_


def test_only_what_can_be_overdrawn_is_a_purse() -> None:
    # r uses 4 + 6 of 9 at most; s uses 4 of 9 at most, since its other leaf is a way that excludes the first.
    root = and_(
        xor_(leaf("a", "r", uses={"energy_j": 4}), leaf("b", "s", uses={"energy_j": 4})),
        xor_(leaf("c", "r", uses={"energy_j": 6}), leaf("d", "r", uses={"water_l": 1})),
    )
    flat = flatten(grounded(root), trivial_fleet(("r", "s"), limits={"energy_j": 9}), Weights())
    purses = purses_of(flat, structurally_possible(flat))
    assert purses.names == (("r", "energy_j"),)
    # The greatest unit of 4 and 6 is 2, and 9 hold four of it.
    assert purses.limits == (4,)
    assert [purses.of_leaf(flat, node) for node in range(len(flat.kind)) if flat.uses[node]] == [
        ((0, 2),),
        (),
        ((0, 3),),
    ]


def test_without_limits_there_are_none() -> None:
    flat = flatten(grounded(leaf("a", uses={"energy_j": 4})), trivial_fleet(), Weights())
    assert purses_of(flat, [True]).names == ()


@given(st.lists(st.tuples(st.integers(0, 50), st.integers(0, 50), st.integers(0, 50)), min_size=1, max_size=4))
def test_packed_sums_and_guards(rows: list[tuple[int, int, int]]) -> None:
    """For amounts within the limits, the packed sum unpacks to the sums, and the guard tells whether any is too much."""
    limits = tuple(limit for limit, _, _ in rows)
    purses = Purses(tuple(("r", f"b{index}") for index in range(len(rows))), limits, (1,) * len(rows))
    first = [min(amount, limit) for limit, amount, _ in rows]
    second = [min(amount, limit) for limit, _, amount in rows]
    both = purses.packed(tuple(enumerate(first))) + purses.packed(tuple(enumerate(second)))
    sums = [one + other for one, other in zip(first, second, strict=True)]
    assert purses.unpacked(both) == sums
    overdrawn = any(used > limit for used, limit in zip(sums, limits, strict=True))
    assert bool((both + purses.slack) & purses.guard) == overdrawn
