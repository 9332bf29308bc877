"""A model in numbers, all added up by hand."""

from pathlib import Path

import pytest

from missiontree.evaluation.evaluation import Evaluation
from missiontree.evaluation.run import Run
from missiontree.evaluation.summary import Summary, summaries
from missiontree.evaluation.tally import Tally
from missiontree.mission.spent import Spent
from tests.evaluation.contestants import SUITE, missions_in, run

TWINS = SUITE.replace("because: paint", "because: paint\n    twin: home-find\n    removed: the brush")


def of(folder: Path, *runs: Run, text: str = SUITE) -> Summary:
    missions = missions_in(folder, text)
    (summary,) = summaries(Evaluation(suite="s", missions=missions, models=("m",), asked=2, runs=runs))
    return summary


def test_runs_are_counted_and_averaged(tmp_path: Path) -> None:
    """
    The first mission is right twice, the second once of two runs.

    pass^1 = (2/2 + 1/2) / 2 = 0.75, pass^2 = (1 + 0) / 2 = 0.5; the score is (1 + 1 + 1 + 0.5) / 4; each run takes 2 s and 0.25 dollars.
    """
    runs = (run(number=1), run(number=2), run("home-visit"), run("home-visit", 2, right=False))
    summary = of(tmp_path, *runs)
    assert (summary.runs, summary.verdicts) == (4, Tally(right=3, wrong=1))
    assert (summary.pass_k, summary.right, summary.score) == ((0.75, 0.5), 0.75, 0.875)
    assert (summary.seconds, summary.asked) == (8.0, 4)
    assert summary.spent == Spent(turns=8, calls=12, refused=4, input_tokens=400, output_tokens=40, cost_usd=1.0)


def test_a_mission_that_was_never_run_is_left_out_and_the_fewest_runs_end_pass_k(tmp_path: Path) -> None:
    """One of two runs of the first mission, one of one of the second: pass^1 = (1/2 + 1) / 2."""
    summary = of(tmp_path, run(number=1), run(number=2, right=False), run("home-visit"))
    assert summary.pass_k == (0.75,)


def test_no_runs_are_no_numbers(tmp_path: Path) -> None:
    summary = of(tmp_path)
    assert (summary.runs, summary.pass_k, summary.right, summary.score, summary.asked) == (0, (), 0.0, 0.0, 0)
    assert summary.spent == Spent()


def test_money_is_known_only_if_it_is_known_for_every_answer(tmp_path: Path) -> None:
    known, unknown = run(), run(number=2, spent=Spent(turns=1))
    never_answered = run(number=2, spent=Spent())
    assert of(tmp_path, known, unknown).spent.cost_usd is None
    assert of(tmp_path, known, never_answered).spent.cost_usd == 0.25
    assert of(tmp_path, run(spent=Spent(turns=1, cost_usd=0.0))).spent.cost_usd == 0.0


def test_what_no_language_model_was_asked_for_costs_nothing_and_is_not_averaged(tmp_path: Path) -> None:
    summary = of(tmp_path, run(spent=None), run(number=2))
    assert (summary.runs, summary.asked, summary.spent.cost_usd) == (2, 1, 0.25)


def test_one_estimate_makes_the_sum_an_estimate(tmp_path: Path) -> None:
    assert of(tmp_path, run(), run(number=2, spent=Spent(turns=1, estimated=True))).spent.estimated


@pytest.mark.parametrize(
    ("runs", "told"),
    [
        ((run("home-find"), run("home-paint")), (1, 1)),
        ((run("home-find"), run("home-paint", right=False)), (0, 1)),
        ((run("home-find", right=False), run("home-paint")), (0, 1)),  # declining everything tells nothing apart
        ((run("home-find"), run("home-paint", 2)), (0, 0)),
        ((run("home-paint"),), (0, 0)),
    ],
)
def test_twins_are_told_apart_if_both_are_right_in_one_run(
    tmp_path: Path, runs: tuple[Run, ...], told: tuple[int, int]
) -> None:
    summary = of(tmp_path, *runs, text=TWINS)
    assert (summary.told_apart, summary.twins) == told


def test_each_model_has_its_own(tmp_path: Path) -> None:
    runs = (run(model="a"), run(model="b", right=False))
    evaluation = Evaluation(suite="s", missions=missions_in(tmp_path), models=("b", "a"), asked=1, runs=runs)
    assert [(one.model, one.right) for one in summaries(evaluation)] == [("b", 0.0), ("a", 1.0)]
