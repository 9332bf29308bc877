"""The offline author against every built-in English mission; docs/benchmarks.md tells how those that it had not seen went at first."""

from __future__ import annotations

import pytest

from benchmarks.offline_author import SEED, SUITE, Judged, judged, miss, missions_of
from missiontree.evaluation.suite import load_suite
from missiontree.evaluation.tally import tally


@pytest.mark.parametrize(("suite", "missions", "right"), [("english", 360, 350), ("everyday", 120, 95)])
def test_no_plan_is_wrong_and_few_are_missing(suite: str, missions: int, right: int) -> None:
    """``right`` is a floor, a little below what is reached."""
    run = [
        judged(setting, mission) for setting, mission in missions_of(load_suite(SUITE.with_name(suite)), "all", SEED)
    ]
    numbers = tally(one.verdict for one in run)
    assert numbers.missions == missions
    assert misses(run, "wrong") == []
    assert numbers.right >= right, "\n".join(misses(run))


def misses(run: list[Judged], kind: str = "") -> list[str]:
    return [miss(one) for one in run if one.verdict.kind == kind or (not kind and one.verdict.kind != "right")]
