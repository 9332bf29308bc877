"""A sample of the campaign: whatever ends a process, it ends well; how soon, is for the benchmark to say."""

from __future__ import annotations

from pathlib import Path
from random import Random

import pytest

from benchmarks.overshoot import WAYS, Ran, Work, _faults, ran, table, works


@pytest.mark.parametrize("way", WAYS)
def test_a_plan_that_is_cut_short_is_sound_and_loses_nothing(tmp_path: Path, way: str) -> None:
    pool = works(tmp_path, Random(3))  # noqa: S311 - luck for tests, not for secrets
    work = next(one for one in pool if one.name == "20 goals, cpsat, k 1")
    assert ran(work, way, 0.3, 0).faults == []


def test_a_schedule_that_got_lost_is_seen() -> None:
    """10 was reported and 12 returned; and the robot's second action begins before the first has ended."""
    output = '{"makespan_s": 12, "actions": [{"robot": "r", "start_s": 0, "end_s": 7}, {"robot": "r", "start_s": 6, "end_s": 12}]}'
    work = Work("schedule", "by hand", ())
    faults = list(_faults(work, 0, output, "", [["begun", "0"], ["best", "whole", "10.0", "1"]]))
    assert [fault.split()[0] for fault in faults] == ["10.0", "r"]


def test_an_undocumented_exit_is_seen() -> None:
    assert list(_faults(Work("rank", "by hand", ()), -15, "", "", [])) == ["exit -15: "]


def test_nothing_is_kept_only_if_nothing_was_found() -> None:
    work = Work("plan", "by hand", ())
    assert list(_faults(work, 130, "", "", [["begun", "0"]])) == []
    assert len(list(_faults(work, 130, "", "", [["best", "schedule-1", "5.0", "1"]]))) == 1


def test_the_table_takes_the_share_off_what_counts() -> None:
    """0.3 s late of 10 s: 2 % of them are 0.2 s, so 0.1 s counts."""
    one = Ran(Work("plan", "by hand", ()), "limit", 10.0, done_s=0.3, gone_s=0.4)
    assert one.over == pytest.approx(0.1)
    assert "| plan | limit | 1 | 0 | 300 | 300 | 300 | 300 | 100 | 400 |" in table([one])
