"""What each objective chooses, worked out by hand."""

from __future__ import annotations

import pytest

from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from missiontree.mission.front import Chosen
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.objective import Objective
from tests.builders import and_, grounded, leaf
from tests.choosing.asking import asked, brief, task, tasks

EXPERT, NOVICE = ("expert", 1.0, 10.0), ("novice", 0.5, 4.0)
BY_TIME = Weights(1.0, 0.06)


def chosen(tree: GroundedTree, objective: Objective, weights: Weights = Weights()) -> Chosen:
    found = asked(tree, brief(objective, weights)).chosen
    assert found is not None
    return found


def both() -> GroundedTree:
    """Two tasks: the expert alone 2.0 in 20 s, one each 1.5 in 10 s, the novice alone 1.0 in 8 s."""
    return tasks(task(1, EXPERT, NOVICE), task(2, EXPERT, NOVICE))


def told(found: Chosen) -> tuple[float, float, str]:
    """Worth, makespan and claim."""
    return found.worth, found.option.schedule.makespan_s, found.option.certificate.claim


def test_the_fastest_is_the_novice_alone() -> None:
    found = chosen(both(), "makespan")
    assert told(found) == (8.0, 8.0, "proven")
    assert found.option.certificate.bound == 8.0


def test_of_equally_fast_ones_the_better_is_chosen() -> None:
    """The twin is as fast as the novice, and better; it stands last, so that choice indices do not choose it."""
    found = chosen(tasks(task(1, EXPERT, NOVICE, ("twin", 0.7, 4.0))), "makespan")
    assert (found.option.alternative.utility, *told(found)) == (0.7, 4.0, 4.0, "proven")


def test_of_equally_good_ones_the_faster_is_chosen() -> None:
    """The twin is as good as the expert, and faster; the list has the expert first, by its choice index."""
    found = chosen(tasks(task(1, EXPERT, NOVICE, ("twin", 1.0, 7.0))), "utility-makespan")
    assert (found.option.alternative.utility, *told(found)) == (1.0, 7.0, 7.0, "proven")


def test_of_equally_good_and_fast_ones_the_least_sum_of_ends_is_chosen() -> None:
    """Beside a task of 9 s by the hand, the twin ends at 3 s and the expert at 7 s: 12 s of ends instead of 16 s."""
    tree = tasks(task(1, ("expert", 1.0, 7.0), ("twin", 1.0, 3.0)), task(2, ("hand", 1.0, 9.0)))
    found = chosen(tree, "utility-makespan")
    assert told(found) == (9.0, 9.0, "proven")
    assert {filled.robot_type for filled in found.option.alternative.roles} == {"twin", "hand"}


def test_team_time_counts_once() -> None:
    """2.0 - 0.06 * 20 = 0.8; 1.5 - 0.06 * 10 = 0.9; 1.0 - 0.06 * 8 = 0.52."""
    found = chosen(both(), "weighted-team", BY_TIME)
    assert told(found) == (0.9, 10.0, "proven")
    assert found.option.alternative.utility == pytest.approx(1.5 - 0.06 * 14)


def test_robot_time_counts_every_robot() -> None:
    """2.0 - 0.06 * 20 = 0.8; 1.5 - 0.06 * 14 = 0.66; 1.0 - 0.06 * 8 = 0.52."""
    assert told(chosen(both(), "weighted-sum", BY_TIME)) == (0.8, 20.0, "proven")


def test_cost_is_taken_off() -> None:
    """2.0 - 0.06 * 10 - 0.25 * 1 = 1.15."""
    tree = grounded(and_(leaf("a", "expert", quality=2.0, duration_s=10.0, cost=1.0)))
    assert told(chosen(tree, "weighted-team", Weights(1.0, 0.06, 0.25))) == (1.15, 10.0, "proven")


@pytest.mark.parametrize("objective", ["makespan", "utility-makespan", "weighted-team", "weighted-sum"])
def test_without_time_nothing_is_chosen_and_nothing_breaks(objective: Objective) -> None:
    assert asked(both(), brief(objective, BY_TIME), Control(stop=lambda: True)).chosen is None


def test_utility_alone_leaves_the_choice_to_the_list() -> None:
    assert asked(both(), brief()).chosen is None


@pytest.mark.parametrize("objective", ["weighted-team", "weighted-sum"])
def test_a_weighted_objective_needs_a_weight_of_time_and_sums(objective: Objective) -> None:
    with pytest.raises(ValueError, match="the weight of a second \\(beta\\) is 0"):
        brief(objective)
    with pytest.raises(ValueError, match="adds up, and accumulate is 'mean'"):
        brief(objective, BY_TIME, accumulate="mean")
