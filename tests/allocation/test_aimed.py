"""Every aim, held against all alternatives written out."""

from __future__ import annotations

from random import Random

import pytest

from benchmarks.aim_agreement import AIMS, judge, numbered_case
from benchmarks.random_trees import random_case
from missiontree.allocation import ALLOCATORS
from missiontree.allocation.aimed import allocator_for, allocators_for, reaching
from missiontree.allocation.enumerated import Enumerated
from missiontree.allocation.flat import Flat
from missiontree.allocation.kbest import ExactKBest
from missiontree.allocation.narrowing import valued
from missiontree.errors import InputError
from missiontree.mission.aim import PLAIN_AIM, Aim
from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet, RobotType
from tests.builders import and_, grounded, leaf

PARTS, PER_PART = 4, 80


@pytest.mark.parametrize("part", range(PARTS))
def test_lists_by_every_aim_are_those_of_enumeration(part: int) -> None:
    """320 trees with one to ten ranks wanted, half of them under a rule for the whole mission; each by one aim after the other."""
    for index in range(part * PER_PART, (part + 1) * PER_PART):
        aim = AIMS[index % len(AIMS)]
        searches = [("whole", ExactKBest()), ("whole by bounds", ExactKBest(patience=0))]
        assert list(judge(numbered_case(6, index), aim, 1 + index % 10, searches)) == [], f"case {index}, {aim}"


@pytest.mark.parametrize("aim", AIMS, ids=lambda aim: aim.in_words)
def test_no_aim_claims_more_than_enumeration_bears_out(aim: Aim) -> None:
    """Searches cut short in five ways, on 15 trees."""
    for index in range(15):
        assert list(judge(numbered_case(7, index), aim, 1 + index % 5)) == [], f"case {index}"


def huge(flat: Flat) -> Flat:
    """Utilities 10^18 times as large, of which the last digits differ."""
    return valued(flat, lambda leaf: flat.utility[leaf] * (10**18 + 9) + leaf % 3)


@pytest.mark.parametrize("aim", AIMS, ids=lambda aim: aim.in_words)
def test_huge_utilities_coarsen_bounds_and_never_ranks(aim: Aim) -> None:
    """Utilities of 10^24 millionths, beyond what the inner loops hold, that differ in their last digits alone."""
    for index in range(20):
        case = random_case(Random(f"huge:{index}"))  # noqa: S311 - luck for tests, not for secrets
        flat = huge(case.flat)
        truth = Enumerated(aim)(flat, case.fleet, case.weights, 5, Control())
        result = reaching(aim, ExactKBest(patience=0))(flat, case.fleet, case.weights, 5, Control())
        assert [one.choices for one in result.alternatives] == [one.choices for one in truth.alternatives]
        assert result.status == truth.status


def test_the_plain_aim_is_reached_by_all() -> None:
    assert allocators_for(PLAIN_AIM) == ALLOCATORS
    assert list(allocators_for(Aim(accumulate="mean"))) == ["exact", "exhaustive"]


@pytest.mark.parametrize("name", ["pruned", "pruned_as_printed"])
def test_an_allocator_that_cannot_says_which_can(name: str) -> None:
    with pytest.raises(
        InputError, match="ranks by sums alone, and mean utility, different teams is asked for"
    ) as caught:
        allocator_for(name, Aim(accumulate="mean", diverse=True))
    assert caught.value.accepted == "exact or exhaustive"


def test_what_cannot_be_done_names_the_limits_that_clash() -> None:
    """Once, whatever the aim; and the searches underneath do not seek them."""
    tree = grounded(and_(*(leaf(name, quality=1, uses={"energy_j": 2}) for name in "xy")))
    fleet = Fleet((RobotType(id="r", count=1),), total_limits={"energy_j": 3})
    for aim in AIMS:
        ranking = allocator_for("exact", aim)(tree, fleet, Weights(), 2, Control())
        assert ranking.status == "infeasible"
        assert [reason.rule for reason in ranking.reasons].count("limits_clash") == 1
    assert "limits_clash" not in {
        reason.rule for reason in ExactKBest(explain=False)(tree, fleet, Weights(), 2, Control()).reasons
    }


def test_an_unknown_allocator_is_refused_with_those_there_are() -> None:
    with pytest.raises(InputError, match="there is no allocator 'best'") as caught:
        allocator_for("best", PLAIN_AIM)
    assert caught.value.accepted == "exact, pruned, pruned_as_printed, exhaustive"
