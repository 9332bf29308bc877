"""Numbers as people read them."""

import pytest

from missiontree.evaluation.in_words import MEANINGS, VERDICT_NAMES, count, money, per_run, share, took
from missiontree.evaluation.summary import Summary
from missiontree.evaluation.tally import Tally
from missiontree.evaluation.verdict import VERDICTS
from missiontree.mission.spent import Spent

NOTHING = Spent()


def summary(spent: Spent = NOTHING, asked: int = 4) -> Summary:
    return Summary(
        model="m",
        runs=4,
        verdicts=Tally(right=4),
        pass_k=(1.0,),
        score=1.0,
        seconds=5.0,
        asked=asked,
        spent=spent,
        twins=0,
        told_apart=0,
    )


def test_every_verdict_has_a_name_and_a_meaning() -> None:
    assert set(VERDICT_NAMES) == set(MEANINGS) == set(VERDICTS)
    assert len(set(VERDICT_NAMES.values())) == len(VERDICTS)


@pytest.mark.parametrize(
    ("value", "shown"),
    [(0.0, "0.000"), (1.0, "1.000"), (2 / 3, "0.667"), (0.99999, "0.999"), (0.00001, "0.001"), (0.5, "0.500")],
)
def test_only_all_is_1_and_only_none_is_0(value: float, shown: str) -> None:
    assert share(value) == shown


def test_one_is_one_and_thousands_are_parted() -> None:
    assert (count(1, "run"), count(0, "run"), count(1200, "run")) == ("1 run", "0 runs", "1,200 runs")
    assert (per_run(5, 2), per_run(12345, 1, 0), per_run(5, 0)) == ("2.5", "12,345", "–")


@pytest.mark.parametrize(
    ("spent", "asked", "shown"),
    [
        (Spent(turns=1, cost_usd=12.345), 4, "$12.35"),
        (Spent(turns=1, cost_usd=0.01234), 4, "$0.0123"),
        (Spent(turns=1, cost_usd=0.0), 4, "$0.00"),
        (Spent(turns=1), 4, "not known"),
        (Spent(), 0, "–"),
    ],
)
def test_money_is_shown_only_if_it_is_known(spent: Spent, asked: int, shown: str) -> None:
    assert money(summary(spent, asked)) == shown


def test_what_a_run_takes_is_a_mean_of_those_that_asked() -> None:
    spent = Spent(turns=8, calls=12, refused=2, input_tokens=4000, output_tokens=10, estimated=True, cost_usd=1.0)
    assert took(summary(spent)) == {
        "turns": "2.0",
        "calls": "3.0",
        "refused": "0.5",
        "tokens in": "about 1,000",
        "tokens out": "about 2",
        "seconds": "1.25",
        "money in all": "$1.00",
    }
    assert set(took(summary(asked=0)).values()) == {"–", "1.25"}
