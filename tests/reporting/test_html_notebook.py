"""A plan in a notebook, and who says how values are shown there."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree.mission.shown import draw_with, html_of
from tests.reporting.html_page import parsed, planned


def test_a_plan_shows_itself_in_a_notebook() -> None:
    page = parsed(planned("site")._repr_html_() or "")
    assert page.text.startswith("Find the visitor and guide her to the gate")
    assert "Planned. 4 robots do it in 325 s." in page.text
    assert "ben: Bring visitor to gate (98.2 – 177.5 s)" in page.text
    assert len(page.find("svg")) == 2
    assert not page.find("script", "style", "link")


def test_a_plan_that_is_declined_shows_why_in_a_notebook() -> None:
    page = parsed(planned("restaurants")._repr_html_() or "")
    assert "Cannot be done." in page.text
    assert "The mission needs the capability recommend" in page.text


def test_two_plans_in_one_notebook_do_not_share_names() -> None:
    first, second = (parsed(planned(name)._repr_html_() or "") for name in ("reunite", "rescue"))
    names = [{e.attributes["id"] for e in page.all() if "id" in e.attributes} for page in (first, second)]
    assert names[0]
    assert not names[0] & names[1]


def test_names_of_users_are_words_in_a_notebook_too() -> None:
    plan = planned("reunite")
    text = "<img src=x onerror=alert(1)>\x1b[2J"
    html = replace(plan, brief=replace(plan.brief, text=text))._repr_html_() or ""
    page = parsed(html)
    assert not page.find("img")
    assert page.text.startswith("<img src=x onerror=alert(1)>")


def test_a_damaged_plan_says_so_instead_of_failing() -> None:
    plan = planned("reunite")
    action = replace(plan.schedules[0].actions[0], leaf=9999)
    damaged = replace(plan, schedules=(replace(plan.schedules[0], actions=(action,)),))
    assert "node 9999" in parsed(damaged._repr_html_() or "").text


class Drawable:
    """A value of a class that somebody may draw."""


def test_a_value_that_nobody_draws_has_no_html(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("missiontree.mission.shown._drawers", {})
    assert html_of(Drawable()) is None
    draw_with("Drawable", lambda value: f"<p>{type(value).__name__}</p>")
    assert html_of(Drawable()) == "<p>Drawable</p>"
