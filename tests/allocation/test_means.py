"""The k best by mean utility."""

from __future__ import annotations

from fractions import Fraction

import pytest

from missiontree.allocation.flat import flatten
from missiontree.allocation.kbest import ExactKBest
from missiontree.allocation.means import MeanKBest, around
from missiontree.errors import InputError
from missiontree.mission.alternative import Ranking
from missiontree.mission.control import Control, Progress
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.grounded import GroundedTree
from tests.builders import Spec, and_, grounded, leaf, trivial_fleet, xor_

SECONDS_COUNT = Weights(0, 1, 0)


def ranked(tree: GroundedTree, fleet: Fleet | None = None, k: int = 9, weights: Weights | None = None) -> Ranking:
    return MeanKBest(ExactKBest())(tree, fleet or trivial_fleet(), weights or Weights(), k, Control())


def told(ranking: Ranking) -> list[tuple[float, int]]:
    """Utility and first choice of each."""
    return [(one.utility, one.choices[0].child) for one in ranking.alternatives]


def either(name: str) -> Spec:
    """Done by type a for 3 at a use of 5, or by type b for 2 at a use of 2."""
    return xor_(
        leaf(f"{name} by a", "a", role=name, quality=3, uses={"energy_j": 5}),
        leaf(f"{name} by b", "b", role=name, quality=2, uses={"energy_j": 2}),
        label=name,
    )


def test_a_mean_does_not_favour_the_longer_branch() -> None:
    """By sum 1.2 stands before 1.0; by mean 1.0 before 0.6. Node 1 is the longer branch, node 4 the shorter."""
    tree = grounded(xor_(and_(leaf("a", quality=0.6), leaf("b", quality=0.6)), leaf("c", quality=1.0)))
    by_sum = ExactKBest()(tree, trivial_fleet(), Weights(), 2, Control())
    assert told(by_sum) == [(1.2, 1), (1.0, 4)]
    ranking = ranked(tree)
    assert told(ranking) == [(1.0, 4), (0.6, 1)]
    assert (ranking.status, ranking.certificate.bound) == ("exact", None)
    assert {one.certificate.claim for one in ranking.alternatives} == {"proven"}


def test_the_bound_of_what_is_not_listed_is_the_last_mean() -> None:
    tree = grounded(xor_(and_(leaf("a", quality=0.6), leaf("b", quality=0.6)), leaf("c", quality=1.0)))
    ranking = ranked(tree, k=1)
    assert (ranking.certificate.claim, ranking.certificate.method, ranking.certificate.bound) == (
        "proven",
        "dinkelbach",
        1.0,
    )


def test_around_a_guess_the_sums_tell_better_means_from_worse() -> None:
    """Around 4/5 (0.8 is 800,000 millionths): of the longer branch 2 x (600,000 - 800,000), of the shorter 200,000."""
    tree = grounded(xor_(and_(leaf("a", quality=0.6), leaf("b", quality=0.6)), leaf("c", quality=1.0)))
    flat = flatten(tree, trivial_fleet(), Weights())
    assert [around(flat, Fraction(800_000)).utility[node] for node in (2, 3, 4)] == [-200_000, -200_000, 200_000]
    assert around(flat, Fraction(1, 3)).utility[4] == 3 * 1_000_000 - 1


def test_means_that_look_equal_are_told_apart() -> None:
    """(333,333 + 333,333 + 333,334) / 3 millionths is a third of a millionth above 333,333, and both are told as 0.333333."""
    third = [leaf(name, quality=quality) for name, quality in (("a", 0.333333), ("b", 0.333333), ("c", 0.333334))]
    tree = grounded(xor_(leaf("alone", quality=0.333333), and_(*third)))
    assert told(ranked(tree)) == [(0.333333, 2), (0.333333, 1)]


def test_equal_means_stand_in_the_order_of_their_choices() -> None:
    tree = grounded(xor_(and_(leaf("a"), leaf("b")), leaf("c"), and_(leaf("d"), leaf("e"), leaf("f"))))
    assert told(ranked(tree, k=2)) == [(1.0, 1), (1.0, 4)]


def test_means_keep_what_couples_the_robots() -> None:
    """Both by a is 10 J of 9, and would be 3.0; a and b 2.5, b and a 2.5, b and b 2.0."""
    fleet = Fleet((RobotType(id="a", count=1), RobotType(id="b", count=1)), total_limits={"energy_j": 9})
    assert [one.utility for one in ranked(grounded(and_(either("x"), either("y"))), fleet).alternatives] == [
        2.5,
        2.5,
        2.0,
    ]


def test_nothing_to_do_is_worth_nothing() -> None:
    """Where seconds cost, doing nothing (0) stands before one second (-1) and two (-2)."""
    tree = grounded(xor_(leaf("two", duration_s=2), leaf("one", duration_s=1), and_()))
    for k in (1, 2, 3):
        assert told(ranked(tree, k=k, weights=SECONDS_COUNT)) == [(0.0, 3), (-1.0, 2), (-2.0, 1)][:k]
    assert told(ranked(grounded(xor_(leaf("a"), and_())), k=1)) == [(1.0, 1)]


def test_too_many_ways_of_doing_nothing_are_refused() -> None:
    """2 to the power of 10 is 1,024."""
    tree = grounded(and_(*(xor_(and_(), and_()) for _ in range(10))))
    with pytest.raises(InputError, match="more than 1,000 ways without any action"):
        ranked(tree)


def test_what_cannot_be_done_says_why() -> None:
    fleet = Fleet((RobotType(id="a", count=1), RobotType(id="b", count=1)), total_limits={"energy_j": 3})
    ranking = ranked(grounded(and_(either("x"), either("y"))), fleet)
    assert (ranking.status, ranking.certificate.claim) == ("infeasible", "proven")
    assert ranking.reasons[0].rule == "limits_clash"


def test_whoever_listens_is_told_of_the_whole_search() -> None:
    """Not of sums around a guess, which mean nothing to anybody."""
    heard: list[Progress] = []
    tree = grounded(xor_(and_(leaf("a", quality=0.6), leaf("b", quality=0.6)), leaf("c", quality=1.0)))
    MeanKBest(ExactKBest())(tree, trivial_fleet(), Weights(), 1, Control(report=heard.append))
    assert [news.found for news in heard] == [1, 2, 2]  # by sum, around 0.6, around 1.0


def test_a_search_that_is_stopped_says_how_good_what_it_lacks_can_be() -> None:
    """Nobody looked at anything: no mean is above that of the best action, 1.0."""
    tree = grounded(xor_(and_(leaf("a", quality=0.6), leaf("b", quality=0.6)), leaf("c", quality=1.0)))
    ranking = MeanKBest(ExactKBest(max_examined=0))(tree, trivial_fleet(), Weights(), 2, Control(stop=lambda: True))
    assert (ranking.certificate.claim, ranking.certificate.bound) == ("bounded", 1.0)
    assert ranking.status in {"partial", "unknown"}
