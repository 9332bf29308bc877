"""Refusals are counted by kind, and the first of a kind, which is the best candidate refused, is told."""

from __future__ import annotations

from missiontree.allocation.refusals import Refusals
from missiontree.mission.reason import Reason


def over(robot: str, needed: str) -> Reason:
    return Reason(rule="budget_exceeded", message=f"{robot} needs {needed}.", robot=robot, needed=needed)


def test_one_reason_per_rule_type_and_budget() -> None:
    refusals = Refusals()
    for reason in (over("r", "energy_j 7"), over("s", "energy_j 9"), over("s", "energy_j 8"), over("s", "water_l 8")):
        refusals.add(reason)
    refusals.add(None)
    # energy of s twice, and once each: energy of r and water of s, by name.
    assert [
        (reason.robot, reason.needed, reason.severity, reason.message) for reason in refusals.summary("notice")
    ] == [
        ("s", "energy_j 9", "notice", "2 candidates were refused. The best of them: s needs energy_j 9."),
        ("r", "energy_j 7", "notice", "1 candidate was refused. The best of them: r needs energy_j 7."),
        ("s", "water_l 8", "notice", "1 candidate was refused. The best of them: s needs water_l 8."),
    ]
