"""The report as people meet it: in a browser, opened from disk, on any screen, with and without its script, by keyboard, on paper."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Page, expect

from tests.browser.conftest import Opener

PARTS = ("schedule", "map", "tree", "timetable", "limits")
WIDTHS = (320, 390, 800, 1400, 2560)


@pytest.mark.parametrize("sample", ["site", "reunite", "restaurants", "wind_farm"])
@pytest.mark.parametrize("width", WIDTHS)
def test_no_screen_makes_the_page_scroll_sideways(opened: Opener, sample: str, width: int) -> None:
    page = opened(sample, width=width)
    expect(page.get_by_role("heading", level=1)).to_be_visible()
    assert page.evaluate("document.documentElement.scrollWidth") <= width


def test_the_first_screen_tells_what_comes_of_it_who_does_what_and_when(opened: Opener) -> None:
    page = opened()
    for found in (
        page.get_by_text("Planned."),
        page.locator("#schedule .way-1 .crew").get_by_text("Bring visitor to gate."),
        page.locator("#schedule .way-1 .crew").get_by_text("98.2 – 177.5 s"),
        page.locator("#gantt-1"),
    ):
        expect(found).to_be_in_viewport()


def everywhere(rank: str) -> dict[str, list[str]]:
    """One rank, and no other, in every part."""
    return {part: [rank] for part in PARTS}


def shown(page: Page) -> dict[str, list[str]]:
    """Ranks that can be seen, part by part."""
    return {
        part: [way.get_attribute("data-rank") or "" for way in page.locator(f"#{part} .way").all() if way.is_visible()]
        for part in PARTS
    }


@pytest.mark.parametrize("script", [True, False])
def test_choosing_an_alternative_changes_every_view_with_and_without_script(opened: Opener, script: bool) -> None:
    page = opened(script=script)
    assert shown(page) == everywhere("1")
    page.get_by_text("347.5 s").first.click()
    assert shown(page) == everywhere("2")


def test_alternatives_are_chosen_by_keyboard(opened: Opener) -> None:
    page = opened()
    page.get_by_role("radio", name="1 325 s").focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowRight")
    expect(page.get_by_role("radio", name="3 335 s")).to_be_checked()
    assert shown(page) == everywhere("3")


def test_the_chosen_alternative_is_remembered(opened: Opener) -> None:
    page = opened()
    page.get_by_text("347.5 s").first.click()
    page.reload()
    expect(page.get_by_role("radio", name="2 347.5 s")).to_be_checked()


def test_the_first_tab_leads_past_everything_to_the_plan(opened: Opener) -> None:
    page = opened()
    page.keyboard.press("Tab")
    expect(page.get_by_role("link", name="Skip to the plan")).to_be_focused()
    page.keyboard.press("Enter")
    expect(page.locator("main")).to_be_focused()


def test_contents_lead_to_sections_that_the_bar_does_not_hide(opened: Opener) -> None:
    page = opened()
    for name in ("Inputs", "Map", "Timetable"):
        page.get_by_role("navigation").get_by_role("link", name=name).click()
        heading = page.get_by_role("heading", name=name, exact=True)
        expect(heading).to_be_in_viewport()
        box, bar = heading.bounding_box(), page.locator(".bar").bounding_box()
        assert box is not None
        assert bar is not None
        assert box["y"] >= bar["y"] + bar["height"]


def test_who_does_not_see_the_page_is_told_what_there_is(opened: Opener) -> None:
    page = opened()
    expect(page.get_by_role("slider", name="Time in the schedule")).to_be_visible()
    for name in ("Chart of the schedule of alternative 1", "Map of alternative 1", "Mission tree with alternative 1"):
        region = page.get_by_role("region", name=name)
        expect(region).to_be_visible()
        expect(region.get_by_role("img")).to_have_count(1)
    expect(page.get_by_role("table").first).to_be_visible()


def moved(page: Page, seconds: float) -> None:
    """The slider set to a time, as a hand would."""
    slider = page.locator("#time")
    slider.fill(str(round(seconds * 1000)))


def spot(page: Page, label: str) -> tuple[float, float]:
    """Where the mark of a mover stands on the first map."""
    mark = page.locator("#map-1 .mover").filter(has=page.locator("title", has_text=re.compile(f"^{label}$")))
    found = re.fullmatch(r"translate\((\S+) (\S+)\)", mark.get_attribute("transform") or "")
    assert found is not None
    return float(found[1]), float(found[2])


def test_the_clock_moves_robots_over_the_map_and_a_line_over_the_chart(opened: Opener) -> None:
    """ben leads the visitor from 108.2 to 177.5 s; 143 s is halfway, and both are on the same way."""
    page = opened()
    expect(page.locator("#map-1 .mover")).to_have_count(0)
    moved(page, 108)
    begun = spot(page, "ben")
    moved(page, 143)
    halfway = spot(page, "ben")
    moved(page, 177)
    ended = spot(page, "ben")
    assert begun != halfway != ended
    expect(page.locator("#schedule .way-1 .says[data-robot='ben']")).to_have_text("now: Get to gate location")
    expect(page.locator("#schedule .way-1 .says[data-robot='scout-1']")).to_have_text("done")
    expect(page.locator("#schedule .way-1 .says[data-robot='ada']")).to_have_text("from 177.5 s: Get to tower crane")
    expect(page.locator("#reading-of-time")).to_have_text("177.0 s")
    assert page.locator("#time").get_attribute("aria-valuetext") == "177.0 s"


def test_the_line_on_the_chart_stands_where_the_axis_says(opened: Opener) -> None:
    """At 100 s it must stand at the hairline of 100 s, within the pixel that one decimal allows."""
    page = opened()
    moved(page, 100)
    line = page.locator("#gantt-1 .cursor").bounding_box()
    tick = page.locator("#gantt-1 text", has_text=re.compile("^100 s$")).bounding_box()
    assert line is not None
    assert tick is not None
    assert abs(line["x"] + line["width"] / 2 - tick["x"] - tick["width"] / 2) < 1.5


def test_the_clock_ends_with_the_mission_and_starts_with_it(opened: Opener) -> None:
    page = opened()
    slider = page.locator("#time")
    slider.focus()
    page.keyboard.press("End")
    expect(page.locator("#reading-of-time")).to_have_text("325.0 s")
    page.keyboard.press("Home")
    expect(page.locator("#reading-of-time")).to_have_text("0.0 s")


def test_play_takes_twenty_seconds_for_the_whole_and_can_be_paused(opened: Opener) -> None:
    """The page's own clock is turned by hand: after ten of twenty seconds, half of 325 s have passed."""
    page = opened()
    page.clock.install(time=0)
    page.reload()
    page.clock.pause_at(3_600)
    page.get_by_role("button", name="Play").click()
    page.clock.run_for(10_000)
    page.get_by_role("button", name="Pause").click()
    reading = page.locator("#reading-of-time").inner_text()
    assert float(reading.removesuffix(" s")) == pytest.approx(162.5, abs=2)
    page.clock.run_for(5_000)
    assert page.locator("#reading-of-time").inner_text() == reading
    page.get_by_role("button", name="Play").click()
    page.clock.run_for(11_000)
    expect(page.locator("#reading-of-time")).to_have_text("325.0 s")
    expect(page.get_by_role("button", name="Play")).to_be_visible()


def test_without_a_map_the_clock_tells_who_does_what(opened: Opener) -> None:
    page = opened("reunite")
    moved(page, 80)
    expect(page.locator("#schedule .way-1 .says[data-robot='transportation_robot-1']")).to_have_text(
        "now: Get to Child location"
    )
    expect(page.locator("#gantt-1 .cursor")).to_have_count(1)


def test_without_script_there_is_no_clock_and_nothing_is_missing(opened: Opener) -> None:
    page = opened(script=False)
    expect(page.locator("#clock")).to_be_hidden()
    for part in PARTS:
        expect(page.locator(f"#{part} .way-1")).to_be_visible()


def colour(page: Page, selector: str, name: str) -> str:
    return str(page.locator(selector).first.evaluate("(element, name) => getComputedStyle(element)[name]", name))


@pytest.mark.parametrize(("dark", "paper"), [(False, "rgb(255, 255, 255)"), (True, "rgb(22, 22, 22)")])
def test_pictures_stand_on_the_same_paper_as_the_page_by_day_and_by_night(
    opened: Opener, dark: bool, paper: str
) -> None:
    page = opened(dark=dark)
    assert colour(page, "body", "backgroundColor") == paper
    for picture in ("gantt-1", "map-1", "tree-1"):
        assert colour(page, f"#{picture} svg > rect", "fill") == paper


def test_paper_has_no_controls_and_no_folds_and_is_always_light(opened: Opener) -> None:
    page = opened(dark=True)
    page.emulate_media(media="print", color_scheme="dark")
    for hidden in ("nav", ".bar", ".skip"):
        expect(page.locator(hidden)).to_be_hidden()
    assert colour(page, "#gantt-1 svg > rect", "fill") == "rgb(255, 255, 255)"
    for fold in page.locator("#inputs details pre").all():
        box = fold.bounding_box()
        assert box is not None
        assert box["height"] > 0


def test_it_prints_on_a4(opened: Opener) -> None:
    page = opened()
    paper = page.pdf(prefer_css_page_size=True)
    assert paper.startswith(b"%PDF")
    sizes = {
        tuple(round(float(side)) for side in box.split()[2:]) for box in re.findall(rb"/MediaBox\s*\[([^\]]*)\]", paper)
    }
    assert sizes == {(595, 842)}  # 210 by 297 mm in points
    assert 4 <= len(re.findall(rb"/Type\s*/Page\b", paper)) <= 14


def test_a_mission_that_cannot_be_done_says_what_to_do_first_on_the_first_screen(opened: Opener) -> None:
    page = opened("restaurants", width=360, height=740)
    expect(page.get_by_text("Do this first")).to_be_in_viewport()
    expect(page.locator("#clock")).to_be_hidden()
