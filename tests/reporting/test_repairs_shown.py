"""Why it cannot be done, and what would make it possible, in the same words in report and terminal."""

from __future__ import annotations

from missiontree.briefing import request_from
from missiontree.explaining.explain import explained
from missiontree.explaining.nearest import nearest_part
from missiontree.explaining.of_plan import explanation_of
from missiontree.mission.control import Control
from missiontree.planner import author, plan_authored
from missiontree.reporting.explanation_view import hint_view
from missiontree.reporting.html.report import report_html
from missiontree.reporting.text import render


def test_report_and_terminal_say_the_same_of_a_mission_that_cannot_be_done() -> None:
    request = request_from("Rescue the cat from the house", without=["transportation_robot"])
    authored = author(request)
    plan = plan_authored(request, authored, Control())
    told = explained(plan, request, Control(), 3).told
    page, text = report_html(plan, told=told), render(hint_view(told), 200)
    for words in (told.repairs[0].words, told.nearest.words if told.nearest is not None else "?"):
        assert words in text
        assert words.replace("'", "&#39;") in page
    assert "Why it cannot be done" in page
    assert "What would make it possible" in page
    assert explanation_of(plan, Control()) == told

    part = nearest_part(plan, request, authored, Control())
    assert part is not None
    page = report_html(part, told=explanation_of(part, Control()))
    assert "In part only" in page
    assert "Left out" in page
    assert told.repairs[0].words.replace("'", "&#39;") in page


def test_a_plan_that_is_delivered_is_not_explained() -> None:
    request = request_from("Reunite mom with her lost child")
    assert explanation_of(plan_authored(request, author(request), Control()), Control()) is None
