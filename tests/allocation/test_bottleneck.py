"""The k best by the least utility of an action."""

from __future__ import annotations

from typing import Any

import pytest

from missiontree.allocation.bottleneck import LeastKBest
from missiontree.allocation.kbest import ExactKBest
from missiontree.mission.alternative import Ranking
from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.grounded import GroundedTree
from tests.builders import Spec, and_, grounded, leaf, trivial_fleet, xor_


def ranked(tree: GroundedTree, fleet: Fleet | None = None, k: int = 9, weights: Weights | None = None) -> Ranking:
    return LeastKBest(ExactKBest())(tree, fleet or trivial_fleet(), weights or Weights(), k, Control())


def told(ranking: Ranking) -> list[tuple[float, tuple[int, ...]]]:
    """Utility and choices of each."""
    return [(one.utility, tuple(choice.child for choice in one.choices)) for one in ranking.alternatives]


def one_of(*qualities: float) -> Spec:
    return xor_(*(leaf(f"q{quality}", quality=quality, role=f"{qualities}") for quality in qualities))


TWO = grounded(and_(one_of(0.9, 0.2, 0.5), one_of(0.7, 0.5)))
"""Nodes: 1 xor, 2 (0.9), 3 (0.2), 4 (0.5), 5 xor, 6 (0.7), 7 (0.5)."""


def test_the_weakest_action_decides_and_choices_order_equals() -> None:
    """0.9 with 0.7 gives 0.7. With a 0.5 and no 0.2: (2,7), (4,6), (4,7), in the order of choices. Then both with 0.2."""
    expected = [(0.7, (2, 6)), (0.5, (2, 7)), (0.5, (4, 6)), (0.5, (4, 7)), (0.2, (3, 6)), (0.2, (3, 7))]
    assert told(ranked(TWO)) == expected
    for k in range(1, 6):
        ranking = ranked(TWO, k=k)
        assert told(ranking) == expected[:k]
        assert (ranking.status, ranking.certificate.method, ranking.certificate.bound) == (
            "exact",
            "bottleneck",
            expected[k - 1][0],
        )


def test_a_sum_cannot_make_up_for_a_weak_action() -> None:
    """5 + 0.1 is the better sum, 1 + 1 the better least."""
    tree = grounded(xor_(and_(leaf("a", quality=5), leaf("b", quality=0.1)), and_(leaf("c"), leaf("d"))))
    assert told(ranked(tree)) == [(1.0, (4,)), (0.1, (1,))]


def test_the_least_keeps_what_couples_the_robots() -> None:
    """Both by the good robot, 0.9, take 10 J of its 9; so one is done by the other, at 0.4, and there are three such ways."""
    good: dict[str, Any] = {"robot_type": "good", "quality": 0.9, "uses": {"energy_j": 5}}
    tree = grounded(
        and_(
            *(
                xor_(leaf(f"{name}g", role=name, **good), leaf(f"{name}p", "poor", name, quality=0.4))
                for name in ("x", "y")
            )
        )
    )
    fleet = Fleet((RobotType(id="good", count=1, limits={"energy_j": 9}), RobotType(id="poor", count=1)))
    assert told(ranked(tree, fleet)) == [(0.4, (2, 6)), (0.4, (3, 5)), (0.4, (3, 6))]
    assert told(ranked(tree, fleet, k=1)) == [(0.4, (2, 6))]


def test_nothing_to_do_is_worth_nothing() -> None:
    """Where seconds cost, doing nothing (0) stands before one second (-1) and two (-2); where they do not, behind 1.0."""
    tree = grounded(xor_(leaf("two", duration_s=2), leaf("one", duration_s=1), and_()))
    for k in (1, 2, 3):
        assert told(ranked(tree, k=k, weights=Weights(0, 1, 0))) == [(0.0, (3,)), (-1.0, (2,)), (-2.0, (1,))][:k]
    assert told(ranked(grounded(xor_(and_(), leaf("a"))))) == [(1.0, (2,)), (0.0, (1,))]


def test_only_nothing_to_do() -> None:
    assert told(ranked(grounded(xor_(and_(), and_())), k=1)) == [(0.0, (1,))]


def test_what_cannot_be_done_says_why() -> None:
    ranking = ranked(grounded(and_(leaf("a"), xor_())))
    assert (ranking.status, [reason.rule for reason in ranking.reasons]) == ("infeasible", ["no_robot_able"])


@pytest.mark.parametrize("most", range(6))
def test_a_search_that_is_stopped_bounds_what_it_lacks(most: int) -> None:
    """Stopped when the token has been asked so often: what is not listed is never better than the bound."""
    asked = iter(range(most))
    ranking = LeastKBest(ExactKBest())(
        TWO, trivial_fleet(), Weights(), 2, Control(stop=lambda: next(asked, None) is None)
    )
    missing = [worth for worth, choices in told(ranked(TWO)) if (worth, choices) not in told(ranking)]
    assert ranking.certificate.bound is not None
    assert ranking.certificate.bound >= max(missing)
