"""Purses: only those that can be overdrawn, in their own units."""

from __future__ import annotations

from missiontree.allocation.flat import flatten
from missiontree.allocation.possible import structurally_possible
from missiontree.allocation.purses import purses_of
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
    assert [taken for taken, uses in zip(purses.of_leaves(flat), flat.uses, strict=True) if uses] == [
        ((0, 2),),
        (),
        ((0, 3),),
    ]


def test_without_limits_there_are_none() -> None:
    flat = flatten(grounded(leaf("a", uses={"energy_j": 4})), trivial_fleet(), Weights())
    assert purses_of(flat, [True]).names == ()
