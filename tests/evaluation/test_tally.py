"""Verdicts are counted."""

from missiontree.evaluation.tally import Tally, tally
from missiontree.evaluation.verdict import Verdict


def test_verdicts_are_counted() -> None:
    right = Verdict(mission="a", kind="right", status="complete", score=1)
    wrong = Verdict(mission="b", kind="wrong", status="complete", score=0, differences=("x",))
    assert tally([right, wrong, right]) == Tally(right=2, wrong=1)
    late = Verdict(mission="c", kind="no_answer", status="exhausted", score=0, differences=("x",))
    assert tally([right, wrong, late, right]) == Tally(right=2, wrong=1, no_answer=1)
    assert tally([right, wrong, late, right]).missions == 4
    assert tally([]).missions == 0
