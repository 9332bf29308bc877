"""The front and the choice, as people see them: terminal, picture, report."""

from __future__ import annotations

from dataclasses import replace
from xml.etree import ElementTree as ET

import pytest

from missiontree.mission.plan import Plan
from missiontree.mission.search_limit import SearchLimit
from missiontree.reporting.front.plot import Scale, front_svg
from missiontree.reporting.front.rows import choice_in_words, front_in_words, rows_of
from missiontree.reporting.html.report import report_html
from missiontree.reporting.text import plan_text
from tests.checking.damages import with_options
from tests.checking.plans import PLANS

SVG = "{http://www.w3.org/2000/svg}"


def trade() -> Plan:
    """Three plans, the third of which is chosen and not listed."""
    return PLANS["trade"]()


def test_the_table_says_what_each_plan_comes_to_and_which_is_chosen() -> None:
    rows = [(row.number, row.utility, row.makespan_s, row.known, row.listed, row.chosen) for row in rows_of(trade())]
    assert [(*row[:2], round(row[2], 1), *row[3:]) for row in rows] == [
        (1, "8", 380.4, "proven", 1, False),
        (2, "7.2", 145.0, "proven", 2, False),
        (3, "6.4", 132.6, "proven", None, True),
    ]
    text = plan_text(trade())
    assert "From the best staffed to the fastest: 3 plans, proven to be all" in text
    assert "Chosen by least makespan: an alternative that is not listed, utility 6.4, 132.6 s (proven best)" in text
    assert "Schedule of the choice: 132.6 s" in text


def test_what_is_known_of_other_plans_is_said() -> None:
    front = trade().front
    assert front is not None
    assert front_in_words(replace(front, found=9)) == "3 plans of 9 found, all of which are proven"
    open_ = replace(front.certificate, claim="unproven", limit=SearchLimit("time_s", 2))
    assert (
        front_in_words(replace(front, certificate=open_))
        == "3 plans; there may be others, ended by the time limit of 2 s"
    )
    assert front_in_words(replace(front, options=front.options[:1], found=1)) == "one plan, proven to be all"


def test_what_is_known_of_the_choice_is_said() -> None:
    """By weighted worth nothing is above the bound; by makespan nothing is below it."""
    weighed, by_time = PLANS["weighed"](), trade()
    assert weighed.chosen is not None
    assert by_time.chosen is not None
    assert "none is above 5.39896, proven" in choice_in_words(weighed, weighed.chosen)
    certificate = replace(by_time.chosen.option.certificate, claim="bounded", bound=100.0)
    bounded = replace(by_time.chosen, option=replace(by_time.chosen.option, certificate=certificate))
    assert "(none is below 100 s, proven)" in choice_in_words(by_time, bounded)
    assert "(not proven best)" in choice_in_words(
        by_time, replace(bounded, option=replace(bounded.option, certificate=replace(certificate, bound=None)))
    )


def test_the_picture_has_a_point_per_plan_and_a_ring_round_the_chosen_one() -> None:
    drawn = front_svg(trade())
    assert drawn is not None
    circles = ET.fromstring(drawn).findall(f"{SVG}circle")  # noqa: S314 - drawn here
    assert [circle.get("r") for circle in circles].count("6") == 3 + 1  # three points, and the ring in the key
    assert [circle.get("r") for circle in circles].count("10.5") == 1
    assert "1: utility 8, 380.4 s, proven" in drawn


def test_a_plan_that_is_not_proven_is_hollow_and_a_beaten_one_is_a_cross() -> None:
    plan = trade()
    assert plan.front is not None
    first = plan.front.options[0]
    found = replace(first, certificate=replace(first.certificate, claim="unproven"))
    drawn = front_svg(with_options(plan, [found]))
    assert drawn is not None
    assert "found, not proven" in drawn
    assert "other listed alternatives" in drawn
    assert "proven: nothing is better in both" not in drawn


def test_there_is_no_picture_without_a_front() -> None:
    assert front_svg(PLANS["weighed"]()) is None


@pytest.mark.parametrize(
    ("low", "high", "marks"), [(0.0, 10.0, [0, 2, 4, 6, 8, 10]), (0.13, 0.16, [0.13, 0.14, 0.15, 0.16])]
)
def test_marks_are_round_numbers(low: float, high: float, marks: list[float]) -> None:
    assert Scale(low, high, 0.0, 100.0).marks(5) == pytest.approx(marks)


def test_the_report_has_the_front_and_the_choice() -> None:
    page = report_html(trade())
    assert 'id="front-plot"' in page
    assert 'id="gantt-chosen"' in page
    assert "It is chosen by least makespan: an alternative that is not listed" in page
    assert "plan 3 of the front" in page
    assert "Option · utility 6.4" in page


def test_the_report_opens_with_the_chosen_alternative_where_it_is_listed() -> None:
    page = report_html(PLANS["weighed"]())
    chosen, ranking = PLANS["weighed"]().chosen, PLANS["weighed"]().ranking
    assert chosen is not None
    assert ranking is not None
    rank = next(one.rank for one in ranking.alternatives if one.choices == chosen.option.alternative.choices)
    assert f'value="{rank}" checked' in page
    assert 'id="gantt-chosen"' not in page
