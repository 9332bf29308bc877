"""Verdicts are counted."""

from missiontree.evaluation.tally import Tally, tally
from missiontree.evaluation.verdict import Verdict


def test_verdicts_are_counted() -> None:
    right = Verdict(mission="a", kind="right", status="complete")
    wrong = Verdict(mission="b", kind="wrong", status="complete", differences=("x",))
    assert tally([right, wrong, right]) == Tally(right=2, wrong=1)
    assert tally([right, wrong, right]).missions == 3
    assert tally([]).missions == 0
