"""Bounds by a robot type that takes part."""

from __future__ import annotations

from fractions import Fraction

import pytest

from benchmarks.aim_agreement import HOWS, numbered_case
from missiontree.allocation.ceilings import ANY, ceiling, ceilings
from missiontree.allocation.enumerated import Enumerated
from missiontree.allocation.flat import flatten
from missiontree.allocation.measure import leaves_of, team_of, worth_of
from missiontree.allocation.teams import Teams
from missiontree.mission.aim import Accumulate, Aim
from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from tests.builders import and_, grounded, leaf, trivial_fleet, xor_

TREE = grounded(
    and_(
        xor_(leaf("xa", "a", quality=3), leaf("xb", "b", quality=2)),
        xor_(leaf("ya", "a", quality=3), and_(leaf("yb", "b", quality=1), leaf("yc", "c", quality=0.5))),
    )
)
FLAT = flatten(TREE, trivial_fleet(("a", "b", "c")), Weights())
MILLION = 1_000_000


def test_ceilings_by_hand() -> None:
    """The best, 3 + 3, is by a alone; the best with b 2 + 3 (for x), with c 3 + 1.5. Least: a 3, b 2, c 0.5. Without a: 2 + 1.5."""
    above = Fraction(10 * MILLION)
    assert ceilings(FLAT, (), "sum", above) == {
        ANY: 6 * MILLION,
        "a": 6 * MILLION,
        "b": 5 * MILLION,
        "c": Fraction(45, 10) * MILLION,
    }
    assert ceilings(FLAT, (), "min", above) == {ANY: 3 * MILLION, "a": 3 * MILLION, "b": 2 * MILLION, "c": MILLION / 2}
    assert ceilings(FLAT, ("a",), "sum", above)[ANY] == Fraction(35, 10) * MILLION
    assert ceilings(FLAT, ("a", "c"), "sum", above) == {}


def test_means_are_bounded_from_above_down() -> None:
    """From 3 down: with c (3 - 3) + (1 - 3) + (0.5 - 3) = -4.5 over at most three actions, so 1.5 at most."""
    assert ceilings(FLAT, (), "mean", Fraction(3 * MILLION))["c"] == Fraction(15, 10) * MILLION


def test_a_team_is_bounded_by_each_of_its_types() -> None:
    found = ceilings(FLAT, (), "sum", Fraction(10 * MILLION))
    assert ceiling(found, Teams(within=frozenset("ab")), Fraction(10 * MILLION)) == 5 * MILLION
    assert ceiling(found, Teams(within=frozenset("ab")), Fraction(4 * MILLION)) == 4 * MILLION
    assert ceiling(found, Teams(within=frozenset("ad")), Fraction(10 * MILLION)) is None
    assert ceiling({}, Teams(), Fraction(10 * MILLION)) is None


@pytest.mark.parametrize("accumulate", HOWS)
def test_no_alternative_is_above_its_ceiling(accumulate: Accumulate) -> None:
    """Every alternative of 60 random trees, by each of its types, and among those that lack what it lacks."""
    seen = 0
    for index in range(60):
        case = numbered_case(8, index)
        flat = case.flat
        listed = Enumerated(Aim(accumulate=accumulate))(flat, case.fleet, case.weights, 50, Control()).alternatives
        types = sorted(set(flat.robot_type) - {""})
        for one in listed:
            worth, team = worth_of(flat, leaves_of(flat, one), accumulate), team_of(one)
            above = worth_of(flat, leaves_of(flat, listed[0]), accumulate)
            for without in ((), [name for name in types if name not in team]):
                found = ceilings(flat, without, accumulate, above)
                bound = ceiling(found, Teams(frozenset(without), team), above)
                assert bound is not None or not team
                assert bound is None or bound >= worth
                seen += 1
    assert seen > 300
