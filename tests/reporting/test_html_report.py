"""The report as a document: whole, well formed, within its size, the same every time, and served to those who do not see it."""

from __future__ import annotations

import base64
import hashlib
import re
from contextlib import suppress
from dataclasses import replace
from itertools import islice, pairwise

import pytest

from missiontree.checking import check, taken_on_trust
from missiontree.errors import InputError
from missiontree.mission.plan import Outcome, Plan
from missiontree.mission.reason import Reason
from missiontree.mission.schedule import Schedule
from missiontree.reporting.html.checked import Checked
from missiontree.reporting.html.report import report_html
from missiontree.samples import catalogue
from tests.checking.damages import DAMAGES
from tests.checking.plans import PLANS
from tests.reporting.html_page import Element, parsed, planned, report_of

PAPER = ("reunite", "rescue", "luggage", "monster", "restaurants")
SAMPLES = (*PAPER, "site")
LARGEST_KB = 400


@pytest.mark.parametrize("sample", SAMPLES)
def test_every_tag_is_closed_and_every_id_stands_once(sample: str) -> None:
    page = parsed(report_of(sample))
    ids = [element.attributes["id"] for element in page.all() if "id" in element.attributes]
    assert len(set(ids)) == len(ids)


@pytest.mark.parametrize("sample", catalogue.SAMPLES)
def test_a_report_of_a_sample_mission_is_small(sample: str) -> None:
    assert len(report_of(sample).encode()) < LARGEST_KB * 1000


@pytest.mark.parametrize("sample", SAMPLES)
def test_nothing_is_loaded_and_nothing_could_be(sample: str) -> None:
    page = parsed(report_of(sample))
    for element in page.all():
        assert element.tag not in {"link", "img", "iframe", "object", "embed", "base", "form", "foreignobject", "use"}
        assert not {"src", "srcset", "style", "action", "xlink:href"} & element.attributes.keys()
        assert not any(name.startswith("on") for name in element.attributes)
        assert element.attributes.get("href", "#").startswith("#")
    assert "@import" not in report_of(sample)
    assert set(re.findall(r"url\(([^)]{1,3})", report_of(sample))) <= {"#mt", "#tr", "#ga", "#ma", "#br"}


@pytest.mark.parametrize("sample", SAMPLES)
def test_the_policy_names_the_one_style_and_the_one_script_by_their_content(sample: str) -> None:
    page = parsed(report_of(sample))
    (style,) = page.find("style")
    data, script = page.find("script")
    assert data.attributes["type"] == "application/json"
    policies = [meta.attributes["content"] for meta in page.find("meta") if "http-equiv" in meta.attributes]
    assert policies == [
        f"default-src 'none'; style-src {source(style)}; script-src {source(script)}; base-uri 'none'; form-action 'none'"
    ]


def source(element: Element) -> str:
    return f"'sha256-{base64.b64encode(hashlib.sha256(element.raw.encode()).digest()).decode()}'"


@pytest.mark.parametrize("sample", SAMPLES)
def test_whatever_points_inside_the_page_points_at_something(sample: str) -> None:
    html = report_of(sample)
    page = parsed(html)
    ids = {element.attributes["id"] for element in page.all() if "id" in element.attributes}
    for element in page.all():
        if element.attributes.get("href", "").startswith("#"):
            assert element.attributes["href"][1:] in ids
        for name in ("aria-labelledby", "aria-describedby", "for"):
            assert set(element.attributes.get(name, "").split()) <= ids
        for value in element.attributes.values():
            assert set(re.findall(r"url\(#([^)]*)\)", value)) <= ids


@pytest.mark.parametrize("sample", SAMPLES)
def test_headings_go_down_one_level_at_a_time_and_sections_bear_them(sample: str) -> None:
    page = parsed(report_of(sample))
    levels = [int(element.tag[1]) for element in page.find("h1", "h2", "h3", "h4")]
    assert levels[0] == 1
    assert levels.count(1) == 1
    assert all(after <= before + 1 for before, after in pairwise(levels))
    for section in page.find("section"):
        assert page.by_id(section.attributes["aria-labelledby"]).tag == "h2"
    assert [len(page.find(tag)) for tag in ("header", "nav", "main", "footer")] == [1, 1, 1, 1]
    anchors = [link.attributes["href"] for link in page.find("nav")[0].find("a")]
    assert anchors == [f"#{section.attributes['id']}" for section in page.find("section")]


@pytest.mark.parametrize("sample", SAMPLES)
def test_tables_pictures_and_boxes_that_scroll_say_what_they_are(sample: str) -> None:
    page = parsed(report_of(sample))
    for cell in page.find("th"):
        assert cell.attributes["scope"] in {"col", "row", "rowgroup"}
    for box in (*page.by_class("picture"), *page.by_class("scroll")):
        assert box.attributes["role"] == "region"
        assert box.attributes["aria-label"]
        assert box.attributes["tabindex"] == "0"
    for picture in (svg for box in page.by_class("picture") for svg in box.find("svg")):
        assert picture.attributes["role"] == "img"
        assert picture.find("title")[0].text


def test_equal_plans_give_equal_bytes() -> None:
    assert report_html(planned("site")) == report_html(replace(planned("site")))


def test_the_first_sight_says_what_comes_of_it_and_who_does_what_when() -> None:
    """The building site: Guide ben takes over from 98.2 s, when scout-1 has found the visitor, until 177.5 s."""
    page = parsed(report_of("site"))
    assert page.find("h1")[0].text == planned("site").brief.text
    assert page.by_class("outcome")[0].text == (
        "Planned. 4 robots do it in 325 s. It is the best of 3 alternatives; their order is proven."
    )
    first = page.by_id("schedule").by_class("way-1")[0]
    crew = [member.text for member in first.by_class("crew")[0].children]
    assert crew[0] == "scout-1 Scout Search for visitor and report where visitor was found. 0.0 – 98.2 s"
    assert crew[1] == "ben Guide Bring visitor to gate. 98.2 – 177.5 s, after Search(visitor)"
    assert "325 s" in first.by_class("facts")[0].text


def test_choosing_an_alternative_is_a_matter_of_radio_buttons_and_style() -> None:
    page = parsed(report_of("site"))
    radios = page.find("fieldset")[0].find("input")
    assert [radio.attributes["id"] for radio in radios] == ["way-1", "way-2", "way-3"]
    assert ["checked" in radio.attributes for radio in radios] == [True, False, False]
    style = page.find("style")[0].text
    for section in ("schedule", "map", "tree", "timetable", "limits"):
        for rank in (1, 2, 3):
            assert len(page.by_id(section).by_class(f"way-{rank}")) == 1
            assert f"body:has(#way-{rank}:checked) .way-{rank}" in style


def test_a_rank_that_is_asked_for_is_shown_at_first() -> None:
    page = parsed(report_html(planned("site"), rank=3))
    assert [radio.attributes["id"] for radio in page.find("input") if "checked" in radio.attributes] == ["way-3"]


def test_what_cannot_be_done_says_why_and_what_to_do_first() -> None:
    page = parsed(report_of("restaurants"))
    assert page.by_class("outcome")[0].text.startswith("Cannot be done.")
    assert "The mission needs the capability recommend" in page.by_id("why").text
    assert page.by_class("first-step")[0].text == (
        "Do this first Write a routine with 'recommend' among its verbs and give the capability to a robot type, or reword the mission."
    )
    assert page.by_id("why").text.count("Write a routine") == 1
    assert not page.by_class("way")


def test_an_incomplete_mission_shows_the_tree_so_far() -> None:
    plan = planned("reunite")
    made = replace(
        plan,
        outcome="incomplete",
        grounding=None,
        ranking=None,
        schedules=(),
        reasons=(Reason(rule="not_understood", message="The clause 'sing' is not understood.", hint="reword it"),),
    )
    page = parsed(report_html(made))
    assert page.by_class("outcome")[0].text.startswith("Incomplete.")
    assert "The clause 'sing' is not understood." in page.by_id("why").text
    assert page.by_class("first-step")[0].text == "Do this first Reword it."
    assert "Locate the Lost Child" in page.by_id("tree").text


@pytest.mark.parametrize("outcome", ["exhausted", "provider_failed", "incomplete", "cannot_be_done"])
def test_every_outcome_has_a_report_even_with_nothing_to_tell(outcome: Outcome) -> None:
    plan = replace(
        planned("reunite"), outcome=outcome, tree=None, grounding=None, ranking=None, schedules=(), reasons=()
    )
    page = parsed(report_html(plan))
    assert page.by_class("outcome")[0].text


def test_what_the_checker_says_stands_where_it_cannot_be_missed() -> None:
    plan = planned("reunite")
    sound = parsed(report_html(plan, Checked(tuple(check(plan)), taken_on_trust(plan))))
    assert "finds that the plan keeps every rule" in sound.by_id("proofs").text
    assert not sound.by_class("faults")
    assert "was not checked" in parsed(report_html(plan)).by_id("proofs").text
    fault = Reason(rule="order_broken", message="Get to Child starts before it may.")
    refused = parsed(report_html(plan, Checked((fault,))))
    assert "The checker found 1 fault in this plan." in refused.find("header")[0].text
    assert fault.message in refused.find("header")[0].text
    (outcome,) = refused.by_class("outcome")  # nothing beside a fault looks as if all were well
    assert outcome.text.startswith("Planned, with faults.")
    assert "bad" in outcome.attributes["class"].split()
    assert "good" in sound.by_class("outcome")[0].attributes["class"].split()


@pytest.mark.parametrize(("tasks", "folded", "more"), [(8, 0, 0), (9, 1, 0), (60, 52, 0), (63, 52, 3)])
def test_of_many_tasks_with_refusals_the_first_eight_stand_open(tasks: int, folded: int, more: int) -> None:
    plan = planned("reunite")
    assert plan.grounding is not None
    reasons = tuple(Reason(rule="kind_wrong", message=f"No {number}.", node=f"n{number}") for number in range(tasks))
    page = parsed(report_html(replace(plan, grounding=replace(plan.grounding, not_offered=reasons))))
    section = page.by_id("refused")
    assert len(section.by_class("refused")) == min(tasks, 60)
    inside = section.find("details")
    assert [len(one.by_class("refused")) for one in inside] == ([folded] if folded else [])
    assert [one.text for one in section.by_class("aside")] == (
        [f"… and {more} more; the plan file has them all."] if more else []
    )


def test_a_plan_that_points_nowhere_is_refused() -> None:
    plan = planned("reunite")
    action = replace(plan.schedules[0].actions[0], leaf=9999)
    damaged = replace(plan, schedules=(replace(plan.schedules[0], actions=(action,)),))
    with pytest.raises(InputError, match="node 9999"):
        report_html(damaged)


def test_a_mission_of_many_words_is_told_whole_and_does_not_fill_the_screen() -> None:
    plan = planned("reunite")
    text = "Find the keys, then find the lost child. " * 100
    page = parsed(report_html(replace(plan, brief=replace(plan.brief, text=text))))
    assert len(page.find("h1")[0].text) == 400
    assert page.find("header")[0].find("details")[0].find("p")[0].text == " ".join(text.split())
    assert len(page.find("title")[0].text) < 100


def test_an_alternative_without_a_schedule_says_why() -> None:
    plan = planned("reunite")
    why = Reason(rule="time_limit", message="Time was up.", hint="give more time")
    bare = Schedule(rank=2, status="unknown", certificate=plan.schedules[1].certificate, reasons=(why,))
    page = parsed(report_html(replace(plan, schedules=(plan.schedules[0], bare, *plan.schedules[2:]))))
    second = page.by_id("schedule").by_class("way-2")[0]
    assert "This alternative has no schedule: ✗error: Time was up. Give more time." in second.text
    assert "Social Robot" in second.by_class("crew")[0].text
    assert not second.by_class("picture")


def test_a_plan_of_a_foreign_tree_has_a_report_without_a_mission_tree() -> None:
    page = parsed(report_html(replace(planned("reunite"), tree=None)))
    assert "search by" in page.by_id("tree").text or "Tele-Robot" in page.by_id("tree").text
    assert page.by_id("schedule").by_class("crew")


@pytest.mark.parametrize("first", range(8))
def test_no_damage_does_more_than_refuse_the_plan(first: int) -> None:
    """Every kind of damage, in three plans that it can be done to: a report with the fault in it, or words that refuse it."""
    made = list(PLANS.values())
    for number in range(first, len(DAMAGES), 8):
        turned = made[number % len(made) :] + made[: number % len(made)]
        damaged = (one for plan in turned for one in islice(DAMAGES[number][1](plan()), 1))
        for plan in islice(damaged, 3):
            with suppress(InputError):
                assert report_html(plan).endswith("</html>")


def hostile(plan: Plan) -> Plan:
    """The plan under a mission text that would like to be markup, script, and the end of everything."""
    text = "</style></script><script>alert(1)</script><!-- \x1b[31m\u202e\" onload='x' ]]> {{ 7*7 }} & done"
    return replace(plan, brief=replace(plan.brief, text=text))


def test_names_of_users_are_words_and_nothing_else() -> None:
    html = report_html(hostile(planned("site")))
    page = parsed(html)
    assert len(page.find("script")) == 2
    assert len(page.find("style")) == 1
    assert (
        page.find("h1")[0].text == "</style></script><script>alert(1)</script><!-- \" onload='x' ]]> {{ 7*7 }} & done"
    )
    assert "\x1b" not in html
    assert "\u202e" not in html
    assert "49" not in page.find("h1")[0].text
