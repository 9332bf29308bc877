"""Who does what: in the order in which people meet it elsewhere on the page."""

from __future__ import annotations

import pytest

from missiontree import plan
from missiontree.mission.fleet import Fleet
from missiontree.mission.scene import Scene
from missiontree.reporting.html.crew import crew
from missiontree.reporting.html.report import report_html
from missiontree.samples.catalogue import sample_file
from tests.reporting.map_plans import Doing, by_hand, walker


def test_robots_stand_as_they_begin_and_those_that_begin_together_as_in_the_fleet() -> None:
    """walker-3 begins last; of the two that begin at once, walker-2 is done first, and still comes second."""
    made = by_hand(
        Scene(), Fleet((walker(3),)), [Doing("walker-2", 0, 5), Doing("walker-1", 0, 9), Doing("walker-3", 4, 6)]
    )
    assert made.ranking is not None
    told = crew(made, made.ranking.alternatives[0], made.schedules[0])
    assert [member.name for member in told.members] == ["walker-1", "walker-2", "walker-3"]


def test_where_one_alternative_only_is_drawn_the_page_does_not_speak_of_choosing(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    made = plan(sample_file("site"))
    assert "can be chosen above" not in report_html(made)
    monkeypatch.setattr("missiontree.reporting.html.ways.MOST_BYTES", 0)
    page = report_html(made, rank=2)
    assert "Only alternative 2 is drawn on this page, to keep the page small" in page
    assert "can be chosen above" not in page
    assert 'name="alternative"' not in page.partition("<script")[0]
