"""A sample of the campaign: what was broken is told, what undoes it is offered, and no claim is refuted."""

from __future__ import annotations

from benchmarks.campaign import made
from benchmarks.explained import CAMPAIGN
from benchmarks.explained_breaks import BREAKS


def test_missions_broken_by_one_change_are_explained_and_mended_and_others_are_not_denied() -> None:
    state = made(CAMPAIGN, 1, 0, 10)
    assert state.violations == {}
    assert sum(row.get("repairs", 0) for row in state.rows.values()) >= 5


def test_every_way_to_break_a_mission_has_a_row_of_its_own() -> None:
    assert len({way.__name__ for way in BREAKS}) == len(BREAKS)
