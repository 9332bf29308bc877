"""When may one choice forbid another?"""

from __future__ import annotations

import pytest

from missiontree.allocation.coupling import couples
from missiontree.allocation.flat import flatten
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree
from tests.builders import and_, grounded, leaf, trivial_fleet, xor_

TWO = trivial_fleet({"r": 2, "s": 1})


@pytest.mark.parametrize(
    ("tree", "fleet", "expected"),
    [
        pytest.param(grounded(and_(leaf("a"), leaf("b"))), TWO, False, id="free"),
        pytest.param(grounded(leaf("a", uses={"e": 1})), TWO, False, id="use-without-limit"),
        pytest.param(grounded(leaf("a", uses={"e": 1})), trivial_fleet(limits={"e": 9}), True, id="budget"),
        pytest.param(grounded(leaf("a")), trivial_fleet(limits={"e": 9}), False, id="limit-without-use"),
        pytest.param(grounded(and_(leaf("a"), leaf("b")), [("a", "b")]), TWO, False, id="precedence"),
        pytest.param(grounded(and_(leaf("a"), leaf("b")), [("a", "b", "same_robot")]), TWO, True, id="same-robot"),
        pytest.param(grounded(and_(leaf("a"), leaf("b")), teams={"a": 0, "b": 0}), TWO, False, id="team-of-two"),
        pytest.param(
            grounded(and_(leaf("a", "s"), leaf("b", "s")), teams={"a": 0, "b": 0}), TWO, True, id="team-too-large"
        ),
        pytest.param(grounded(xor_(leaf("a", "r", "x"), leaf("b", "s", "x"))), TWO, False, id="role-of-either-type"),
        pytest.param(grounded(and_(leaf("a", "r", "x"), leaf("b", "s", "x"))), TWO, True, id="role-torn"),
        pytest.param(
            grounded(and_(leaf("a", "r", "x"), xor_(leaf("b", "r", "x"), leaf("c", "s", "x")))),
            TWO,
            True,
            id="role-torn-by-a-choice",
        ),
    ],
)
def test_what_couples(tree: GroundedTree, fleet: Fleet, expected: bool) -> None:
    assert couples(flatten(tree, fleet, Weights())) is expected
