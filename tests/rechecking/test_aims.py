"""The second checker knows what a mission is after: means, the least utility, teams that differ."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree import plan
from missiontree.mission.aim import Accumulate
from missiontree.mission.plan import Plan
from missiontree.rechecking import recheck


def asked(**aim: object) -> Plan:
    return plan("Reunite mom with her lost child", k=3, **aim)  # type: ignore[arg-type]


@pytest.mark.parametrize("aim", [{"accumulate": "mean"}, {"accumulate": "min"}, {"diverse": True}], ids=str)
def test_what_was_asked_for_is_in_order(aim: dict[str, object]) -> None:
    assert recheck(asked(**aim)) == []


@pytest.mark.parametrize("accumulate", ["mean", "min"])
def test_a_sum_is_no_mean_and_no_least(accumulate: Accumulate) -> None:
    made = asked(accumulate="sum")
    other = replace(made, brief=replace(made.brief, accumulate=accumulate))
    assert {fault.rule for fault in recheck(other)} == {"core_utility"}


def test_equal_teams_are_told() -> None:
    made = plan("Rescue cat trapped in a building on fire", k=4)
    other = replace(made, brief=replace(made.brief, diverse=True))
    assert {fault.rule for fault in recheck(other)} == {"core_ranks"}
