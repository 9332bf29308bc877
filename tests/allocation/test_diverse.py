"""Alternatives that differ in team."""

from __future__ import annotations

import pytest

from benchmarks.aim_agreement import false_claims, numbered_case, truth_of
from missiontree.allocation.bottleneck import LeastKBest
from missiontree.allocation.diverse import Diverse
from missiontree.allocation.flat import flatten
from missiontree.allocation.kbest import ExactKBest
from missiontree.allocation.measure import team_of
from missiontree.mission.aim import Aim
from missiontree.mission.alternative import Ranking
from missiontree.mission.control import Control, StopToken
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.terms import Terms
from tests.builders import Spec, and_, grounded, leaf, trivial_fleet, xor_


def ranked(tree: GroundedTree, fleet: Fleet | None = None, k: int = 9) -> Ranking:
    return Diverse(ExactKBest())(tree, fleet or trivial_fleet(("a", "b", "c")), Weights(), k, Control())


def told(ranking: Ranking) -> list[tuple[float, str]]:
    """Utility and team of each."""
    return [(one.utility, "".join(sorted(team_of(one)))) for one in ranking.alternatives]


def task(name: str, **qualities: float) -> Spec:
    """Done by any of some types, as well as is said."""
    return xor_(*(leaf(f"{name}{kind}", kind, name, quality=quality) for kind, quality in qualities.items()))


TREE = grounded(and_(task("x", a=3, b=2), task("y", a=3, b=2, c=1)))
"""By utility: aa 6; ab 5, ba 5; ac 4, bb 4; bc 3."""


def test_the_best_of_each_team_in_order() -> None:
    """Team a has 6, ab 5 (twice, in two orders), ac 4 and b 4 (ac first in the order of choices), bc 3."""
    ranking = ranked(TREE)
    assert told(ranking) == [(6, "a"), (5, "ab"), (4, "ac"), (4, "b"), (3, "bc")]
    assert [choice.child for choice in ranking.alternatives[1].choices] == [2, 6]
    assert (ranking.status, ranking.certificate.bound) == ("exact", None)
    assert ranking.certificate.detail == "There are no more teams."


def test_fewer_than_there_are() -> None:
    ranking = ranked(TREE, k=2)
    assert told(ranking) == [(6, "a"), (5, "ab")]
    certificate = ranking.certificate
    assert (certificate.claim, certificate.method, certificate.bound) == ("proven", "team_partition", 5)


def test_who_must_take_part_is_in_every_team() -> None:
    """With b required by the mission."""
    fleet = trivial_fleet(("a", "b", "c"))
    flat = flatten(TREE, fleet, Weights(), Terms(require=("b",)))
    ranking = Diverse(ExactKBest())(flat, fleet, Weights(), 9, Control())
    assert told(ranking) == [(5, "ab"), (4, "b"), (3, "bc")]


def test_teams_keep_what_couples_the_robots() -> None:
    """Type a may use 5 J and each of its tasks takes 3, so that a alone is no team."""
    tree = grounded(
        and_(
            *(
                xor_(leaf(f"{name}a", "a", name, quality=3, uses={"e": 3}), leaf(f"{name}b", "b", name, quality=2))
                for name in ("x", "y")
            )
        )
    )
    fleet = Fleet((RobotType(id="a", count=1, limits={"e": 5}), RobotType(id="b", count=1)))
    assert told(ranked(tree, fleet)) == [(5, "ab"), (4, "b")]


def test_the_least_and_different_teams_together() -> None:
    """By the weakest action: a 3; ab 2; b 2; ac 1; bc 1."""
    ranking = Diverse(LeastKBest(ExactKBest()), "min")(TREE, trivial_fleet(("a", "b", "c")), Weights(), 9, Control())
    assert told(ranking) == [(3, "a"), (2, "ab"), (2, "b"), (1, "ac"), (1, "bc")]


def test_what_cannot_be_done_says_why() -> None:
    ranking = ranked(grounded(and_(leaf("a", "a"), xor_())))
    assert (ranking.status, [reason.rule for reason in ranking.reasons]) == ("infeasible", ["no_robot_able"])


def after(questions: int) -> StopToken:
    """Says stop when it has been asked so often."""
    left = iter(range(questions))
    return lambda: next(left, None) is None


@pytest.mark.parametrize("asked", range(0, 60, 5))
def test_a_search_that_is_stopped_lists_different_teams_and_claims_no_more_than_it_knows(asked: int) -> None:
    """Stopped after so many questions, in ten random trees."""
    aim = Aim(diverse=True)
    for index in range(10):
        case = numbered_case(5, index)
        control = Control(stop=after(asked))
        ranking = Diverse(ExactKBest(patience=0))(case.flat, case.fleet, case.weights, 4, control)
        assert list(false_claims("stopped", aim, ranking, truth_of(case, aim), 4)) == []


def test_many_types_are_split_only_as_far_as_needed() -> None:
    """Ten tasks, each by one of five types of its own: of 5^10 teams the three best, by 10, 9.9 and 9.9 in the order of choices."""
    tree = grounded(
        and_(*(task(f"t{number}", **{f"k{number}_{kind}": 1 - kind / 10 for kind in range(5)}) for number in range(10)))
    )
    fleet = trivial_fleet([f"k{number}_{kind}" for number in range(10) for kind in range(5)])
    ranking = ranked(tree, fleet, k=3)
    assert [one.utility for one in ranking.alternatives] == [10, 9.9, 9.9]
    assert ranking.status == "exact"
    changed = [
        {filled.role for filled in one.roles if not filled.robot_type.endswith("_0")} for one in ranking.alternatives
    ]
    assert changed == [set(), {9}, {8}]
