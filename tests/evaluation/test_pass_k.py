"""pass^k by hand."""

import re
from itertools import combinations

import pytest

from missiontree.evaluation.pass_k import mean_pass, pass_hat


def test_the_share_of_choices_that_hold_right_runs_alone() -> None:
    """Of four runs three are right: C(3, k) of C(4, k) choices, that is 3/4, 3/6, 1/4, 0/1."""
    assert [pass_hat(4, 3, k) for k in (1, 2, 3, 4)] == [0.75, 0.5, 0.25, 0.0]


@pytest.mark.parametrize("runs", range(1, 7))
def test_it_is_what_counting_all_choices_gives(runs: int) -> None:
    for right in range(runs + 1):
        for k in range(1, runs + 1):
            choices = list(combinations([True] * right + [False] * (runs - right), k))
            assert pass_hat(runs, right, k) == pytest.approx(sum(map(all, choices)) / len(choices))


@pytest.mark.parametrize(("runs", "right", "k"), [(3, 1, 0), (3, 1, 4), (3, 4, 1), (3, -1, 1)])
def test_what_cannot_be_estimated_is_refused(runs: int, right: int, k: int) -> None:
    with pytest.raises(ValueError, match=re.escape(f"pass^{k}")):
        pass_hat(runs, right, k)


def test_missions_weigh_alike_and_the_fewest_runs_end_it() -> None:
    """Always right in 3 runs: 1, 1. Once right in 2 runs: 1/2, 0. Their means are 3/4 and 1/2; the second has no third run."""
    assert mean_pass([(3, 3), (2, 1)]) == (0.75, 0.5)
    assert mean_pass([]) == ()
