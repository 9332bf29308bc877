"""The offline author against every mission of the built-in English suite; docs/benchmarks.md tells how the part set aside went at first."""

from __future__ import annotations

from benchmarks.offline_author import SEED, SUITE, Judged, judged, miss, missions_of
from missiontree.evaluation.suite import load_suite
from missiontree.evaluation.tally import tally

FLOOR = 350


def test_no_plan_is_wrong_and_hardly_any_is_missing() -> None:
    run = [judged(setting, mission) for setting, mission in missions_of(load_suite(SUITE), "all", SEED)]
    numbers = tally(one.verdict for one in run)
    assert numbers.missions == 360
    assert misses(run, "wrong") == []
    assert numbers.right >= FLOOR, "\n".join(misses(run))


def misses(run: list[Judged], kind: str = "") -> list[str]:
    return [miss(one) for one in run if one.verdict.kind == kind or (not kind and one.verdict.kind != "right")]
