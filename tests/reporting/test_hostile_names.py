"""
Names from users never become markup, script, terminal control or a formula.

Five hundred names of :mod:`tests.reporting.hostile` stand, each in its turn, in every free text of a plan, and the plan goes through
every output there is. What comes out is read by parsers that forgive nothing and compared with what harmless names give: the same
elements with the same attributes, the same scripts, the same shape of data.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from functools import cache
from io import StringIO

import pytest
from rich.console import Console

from missiontree import check
from missiontree.authoring.builder import TreeBuilder
from missiontree.authoring.prompt import opening, review
from missiontree.errors import InputError
from missiontree.formats.document import read_text, write_text
from missiontree.formats.source import forbidden
from missiontree.mission.plan import Plan
from missiontree.mission.scene import Scene
from missiontree.reporting.escape import one_line
from missiontree.reporting.gantt.view import gantt_svg
from missiontree.reporting.html.checked import Checked
from missiontree.reporting.html.notebook import plan_html
from missiontree.reporting.html.report import report_html
from missiontree.reporting.maps.text import map_view
from missiontree.reporting.maps.view import map_svg
from missiontree.reporting.png import png_of
from missiontree.reporting.reading_view import reading_text, reading_view
from missiontree.reporting.team.table import team_table
from missiontree.reporting.text import findings_view, orders_view, plan_text, plan_view, render
from missiontree.reporting.tree.view import tree_svg, tree_text
from missiontree.scheduling.precedence import order_by_robot, task_graph
from tests.reporting.hostile import FAMILIES, MARK, MARKED, hostile_names
from tests.reporting.hostile_plans import (
    DECLINED,
    DELIVERED,
    as_a_file_may_hold_it,
    as_planning_makes_it,
    dealt,
    harmless,
    poisoned,
)
from tests.reporting.strict import Parsed, check_png, check_terminal, parse_page, parse_svg

NAMES = hostile_names(500)
FEW, SOME, MANY = 10, 20, 50


def hands(size: int) -> pytest.MarkDecorator:
    """The names in hands of that size, each dealt to a plan of its own."""
    dealt = [pytest.param(NAMES[start : start + size], id=f"{start}+{size}") for start in range(0, len(NAMES), size)]
    return pytest.mark.parametrize("hand", dealt)


# Long ones wrap and are cut, short ones are not: between them, every element that words alone can bring about.
HARMLESS = (
    "A",
    "Anna Berg",
    "one two three four five six seven eight nine ten " * 8,
    "W" * 3000,
    "\u4e2d" * 800,
    "x " * 900,
)


def world_of(hand: Sequence[str]) -> str:
    return DELIVERED[NAMES.index(hand[0]) // len(hand) % len(DELIVERED)]


def dealt_plan(hand: Sequence[str]) -> Plan:
    return as_a_file_may_hold_it(world_of(hand), hand)


def marks_in(text: str) -> set[str]:
    """The marks of the names in a text."""
    return set(MARKED.findall(text))


def pictures(plan: Plan) -> Iterator[str]:
    assert plan.tree is not None
    assert plan.grounding is not None
    yield tree_svg(plan.tree)
    yield tree_svg(plan.grounding.tree)
    yield tree_svg(plan.tree, plan=plan, rank=1)
    yield gantt_svg(plan, 1)
    for rank in (None, 1):
        drawn = map_svg(plan, rank)
        assert drawn is not None
        yield drawn


def texts(plan: Plan) -> Iterator[str]:
    assert plan.tree is not None
    assert plan.grounding is not None
    assert plan.ranking is not None
    graph = task_graph(plan.grounding.tree, plan.ranking.alternatives[0].choices)
    robots = {filled.role: filled.robot for filled in plan.schedules[0].assignments}
    yield plan_text(plan)
    yield plan_text(plan, width=40)
    yield reading_text(plan)
    yield tree_text(plan.tree)
    yield tree_text(plan.grounding.tree)
    yield render(orders_view(plan.grounding.tree, order_by_robot(graph, robots)))
    yield render(findings_view(check(plan)))
    for width in (100, 50):
        for view in (team_table(plan), map_view(plan, 1, width)):
            assert view is not None
            yield render(view, width)


@cache
def allowed(world: str) -> tuple[Parsed, Parsed]:
    """What pictures and page consist of when nobody has a hostile name."""
    drawn, page = Parsed(), Parsed()
    for names in ("A",), ("six words " * 6,), ("six words " * 20,), ("x " * 900,), HARMLESS:
        plan = as_a_file_may_hold_it(world, names)
        for svg in pictures(plan):
            drawn.signatures |= parse_svg(svg).signatures
        parsed = parse_page(report_html(plan))
        page.signatures |= parsed.signatures
        page.scripts += parsed.scripts
        page.styles += parsed.styles
    return drawn, page


def test_there_are_500_and_every_family_is_among_them() -> None:
    assert len(set(NAMES)) == 500
    assert all(MARK in name for name in NAMES)
    assert len(FAMILIES) == 22
    assert hostile_names(500) == NAMES


@pytest.mark.parametrize("first", range(10))
def test_each_of_them_as_a_task_and_as_what_it_is_about(first: int) -> None:
    for name in NAMES[first::10]:
        usual = harmless(DELIVERED[first % len(DELIVERED)]).tree
        assert usual is not None
        tree = poisoned(usual, dealt([name]))
        check_terminal(tree_text(tree))
        assert len(tree_text(tree).splitlines()) == len(tree_text(usual).splitlines())
        parsed = parse_svg(tree_svg(tree))
        parsed.check_values(MARKED)
        assert marks_in(parsed.words) >= marks_in(one_line(name)[:40])


@hands(MANY)
def test_a_terminal_shows_names_and_does_not_obey_them(hand: Sequence[str]) -> None:
    plan = dealt_plan(hand)
    for text in texts(plan):
        check_terminal(text)
    page = StringIO()
    for view in (plan_view(plan), reading_view(plan), team_table(plan), map_view(plan, 1)):
        assert view is not None
        Console(file=page, width=100, color_system="truecolor", force_terminal=True, highlight=False).print(view)
    check_terminal(page.getvalue(), colour=True)


@hands(FEW)
def test_a_picture_shows_names_as_words(hand: Sequence[str]) -> None:
    drawn = list(pictures(dealt_plan(hand)))
    for svg in drawn:
        parsed = parse_svg(svg)
        parsed.check_values(MARKED)
        assert parsed.signatures <= allowed(world_of(hand))[0].signatures
    seen = marks_in(" ".join(parse_svg(svg).words for svg in drawn))
    assert seen >= {mark for name in hand for mark in marks_in(one_line(name)[:12])}  # longer words are cut and wrapped


def sizeless(styles: list[str]) -> set[str]:
    """Styles without their numbers, which are sizes of the pictures."""
    return {re.sub(r"\d+(?:\.\d+)?", "0", style) for style in styles}


@hands(SOME)
def test_the_report_shows_names_as_words(hand: Sequence[str]) -> None:
    plan = dealt_plan(hand)
    parsed = parse_page(report_html(plan))
    parsed.check_values(MARKED)
    known = allowed(world_of(hand))[1]
    assert parsed.signatures <= known.signatures
    assert set(parsed.scripts) <= set(known.scripts)
    assert sizeless(parsed.styles) <= sizeless(known.styles)
    assert marks_in(parsed.words) >= {mark for name in hand for mark in marks_in(one_line(name)[:40])}


@hands(MANY)
def test_faults_and_reasons_for_no_plan_are_words_as_well(hand: Sequence[str]) -> None:
    damaged = dealt_plan(hand)
    faults = check(damaged)
    assert faults
    parse_page(report_html(damaged, Checked(faults, faults))).check_values(MARKED)
    for mission in DECLINED:
        plan = as_a_file_may_hold_it(mission, hand)
        assert plan.outcome != "delivered"
        check_terminal(plan_text(plan))
        check_terminal(reading_text(plan))
        for page in (report_html(plan), plan_html(plan)):
            parse_page(page).check_values(MARKED)


@hands(MANY)
def test_a_notebook_shows_names_as_words(hand: Sequence[str]) -> None:
    parsed = parse_page(plan_html(dealt_plan(hand)))
    parsed.check_values(MARKED)
    assert (parsed.scripts, parsed.styles, parsed.data) == ([], [], [])


@hands(MANY)
def test_what_planning_says_of_them_is_as_harmless(hand: Sequence[str]) -> None:
    """Texts of actions, reasons and findings are made of the names by planning; here nothing is put into their place."""
    plan = as_planning_makes_it(world_of(hand), hand)
    for text in texts(plan):
        check_terminal(text)
    parse_page(plan_html(plan)).check_values(MARKED)


@hands(MANY)
def test_a_png_holds_pixels_and_no_words(hand: Sequence[str]) -> None:
    drawn = list(pictures(dealt_plan(hand)))
    width, height = check_png(png_of(drawn[NAMES.index(hand[0]) // len(hand) % len(drawn)], zoom=0.5))
    assert width > 0 < height


@hands(MANY)
def test_a_plan_comes_back_from_its_file_as_it_was(hand: Sequence[str]) -> None:
    names = [name for name in hand if not forbidden(name)]
    plan = as_a_file_may_hold_it(world_of(hand), names)
    text = write_text(plan, "plan")
    check_terminal(text)
    assert read_text(text, "plan") == plan
    usual = as_a_file_may_hold_it(world_of(hand), ["Anna"])
    assert shape(json.loads(text)) == shape(json.loads(write_text(usual, "plan")))


@hands(MANY)
def test_what_a_terminal_would_obey_is_refused_in_files_and_never_written_as_it_is(hand: Sequence[str]) -> None:
    for name in filter(forbidden, hand):
        text = write_text(Scene(label=name), "scene")
        check_terminal(text)
        assert json.loads(text)["label"] == name  # every character of it is there, by its number
        for written in (text, text[1:-2].replace('"format"', "# YAML\nformat").replace(",", "")):
            with pytest.raises(InputError) as caught:
                read_text(written, "scene")
            check_terminal(str(caught.value))


def shape(plain: object) -> object:
    """Keys and lengths, without what the strings say; two maps have keys of their own."""
    if isinstance(plain, dict):
        return {key: shape(inner) for key, inner in plain.items() if key not in {"digests", "versions"}}
    return [shape(inner) for inner in plain] if isinstance(plain, list) else type(plain).__name__


STRING = re.compile(r'"(?:[^"\\\x00-\x1f]|\\.)*"')


def skeleton(text: str) -> str:
    """A text without what its JSON strings say; a breakout would leave something behind."""
    return STRING.sub('""', text)


@hands(MANY)
def test_a_language_model_is_told_names_as_data(hand: Sequence[str]) -> None:
    plan, usual = dealt_plan(hand), as_a_file_may_hold_it(world_of(hand), ["Anna"])
    assert plan.tree is not None
    assert usual.tree is not None
    ours, theirs = (opening(TreeBuilder(one.brief))[0].text for one in (usual, plan))
    assert skeleton(ours) == skeleton(theirs)
    assert skeleton(review(plan.tree, ()).text) == skeleton(review(usual.tree, ()).text)
