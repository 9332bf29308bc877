"""Gantt charts: heads of arrows, edges of bars, names at the side, and what waits are for, each where it is seen."""

from __future__ import annotations

import re
from itertools import pairwise
from xml.etree import ElementTree

import pytest
from hypothesis import given, settings

from missiontree.mission.fleet import Fleet
from missiontree.mission.plan import Plan
from missiontree.reporting.gantt.layout import MAX_ROWS
from missiontree.reporting.gantt.view import gantt_svg
from missiontree.reporting.palette import HUES
from tests.reporting.charts import SVG, Words, bars_in, parsed, planned, plans, worded, words_in
from tests.reporting.test_palette import contrast
from tests.scheduling.instances import Part, at, mission, robots, scene, work

_HEAD = re.compile(r"M([\d.]+) ([\d.]+) L([\d.]+) ([\d.]+) V([\d.]+) Z")


def heads_in(root: ElementTree.Element) -> list[Words]:
    """Heads of arrows that come from the left: the room of each; the legend's stand in a group."""
    found = []
    for path in root.findall(f"{SVG}path"):
        if (path.get("class") or "").endswith("mt-fill") and (head := _HEAD.fullmatch(path.get("d") or "")):
            x, _, left, top, bottom = map(float, head.groups())
            found.append(Words(left, top, x, bottom, "head"))
    return found


def handed_over() -> Plan:
    """B's second part begins when A is done, and follows B's first part at once: the arrow ends where two bars meet."""
    instance = mission(
        [Part("A", "a", [work(20)]), Part("B", "b", [work(20)]), Part("C", "b", [work(20)])], [("A", "C"), ("B", "C")]
    )
    return planned(instance, Fleet((robots("a"), robots("b"))))


def test_heads_of_arrows_stand_before_the_bars() -> None:
    """The bar to the left of its goal would hide the head if it were drawn later."""
    root = parsed(gantt_svg(handed_over(), 1))
    assert len(heads_in(root)) == 1
    order = [element.get("class") or "" for element in root]
    rows = [place for place, kind in enumerate(order) if kind.startswith("mt-row")]
    heads = [place for place, kind in enumerate(order) if kind in {"mt-link mt-fill", "mt-critical mt-fill"}]
    lines = [place for place, kind in enumerate(order) if kind in {"mt-link mt-line", "mt-critical mt-line"}]
    assert max(lines) < min(rows) < max(rows) < min(heads)


def test_words_in_a_bar_give_way_to_the_head_of_an_arrow_on_its_end() -> None:
    """A word that just fits into B's first bar gets a number instead if an arrow ends at the next one: its head lies on the bar."""
    parts = [Part("A", "a", [work(20)]), Part("B", "b", [work(20)]), Part("C", "b", [work(160)])]
    fleet = Fleet((robots("a"), robots("b")))
    word = "x" * 13  # 13 * 0.62 * 11.5 = 92.7 wide; 20 of 180 s are about 104 pixels, less 5 at each end or 9
    for links, listed in (([("B", "C")], False), ([("A", "C"), ("B", "C")], True)):
        instance = worded(mission(parts, links), [word])
        root = parsed(gantt_svg(planned(instance, fleet), 1))
        bar = bars_in(root)[instance.node["B.0"]]
        assert 5 < (bar.right - bar.left - 92.7) / 2 < 9
        assert len(heads_in(root)) == len(links) - 1
        inside = [one for one in words_in(root) if bar.left < one.left < bar.right and bar.top < one.top < bar.bottom]
        assert [one.text != word for one in inside] == [listed]


@given(plans())
@settings(max_examples=80)
def test_no_word_stands_under_the_head_of_an_arrow(plan: Plan) -> None:
    for width in (480.0, 1100.0):
        root = parsed(gantt_svg(plan, 1, width=width))
        for head in heads_in(root):
            for word in words_in(root):
                aside = word.right <= head.left + 0.5 or word.left >= head.right - 0.5
                assert aside or word.bottom <= head.top + 0.5 or word.top >= head.bottom - 0.5, word.text


@pytest.mark.parametrize("place", range(len(HUES)))
def test_edges_part_neighbouring_bars_in_every_hue(place: int) -> None:
    """Two actions of one robot, not critical: their edge is told from their fill."""
    parts = [Part("P", f"k{place}", [work(20), work(20)]), Part("Long", f"k{(place + 1) % len(HUES)}", [work(90)])]
    fleet = Fleet(tuple(robots(f"k{number}") for number in range(len(HUES))))
    root = parsed(gantt_svg(planned(mission(parts), fleet), 1))
    [group] = [
        group
        for group in root.iter(f"{SVG}g")
        if group.get("class") == "mt-fill" and group.get("fill") == HUES[place].fill and group.get("stroke")
    ]
    assert contrast(group.get("stroke") or "", group.get("fill") or "") > 1.4


@pytest.mark.parametrize("count", [3, 30, 90, MAX_ROWS])
def test_swatches_stay_within_their_rows(count: int) -> None:
    parts = [Part(f"P{number}", "a", [work(10)]) for number in range(count)]
    root = parsed(gantt_svg(planned(mission(parts), Fleet((robots("a", count),))), 1))
    rules = [float((path.get("d") or "").split()[1]) for path in root.findall(f"{SVG}path") if _level(path)]
    swatches = [
        rect for row in root.findall(f"{SVG}g") for rect in row.findall(f"{SVG}rect") if rect.get("width") == "5"
    ]
    assert len(swatches) == count
    for (top, bottom), rect in zip(pairwise(sorted(rules)), swatches, strict=True):
        assert top < float(rect.get("y", "")) < float(rect.get("y", "")) + float(rect.get("height", "")) < bottom


def _level(path: ElementTree.Element) -> bool:
    return path.get("class") == "mt-hair" and " H" in (path.get("d") or "")


def test_the_name_of_a_type_is_written_whole_where_it_is_the_widest() -> None:
    """The column is as wide as the widest name: no name in it is cut, whatever the sum of its letters rounds to."""
    for label in ("Carrier of kind A", "Heavy Lift Carrier", "Tele-Operated Robot 7"):
        plan = planned(mission([Part("A", "a", [work(5)])]), Fleet((robots("a", label=label),)))
        assert label in {one.text for one in words_in(parsed(gantt_svg(plan, 1)))}


def test_what_a_robot_waits_for_stands_over_the_dots_in_full_or_in_short() -> None:
    """B is at q after 15 s and waits for A until 67 s: at 1,100 pixels there is room for all of it, at 480 only for whom."""
    instance = worded(
        mission([Part("A", "a", [work(67)]), Part("B", "b", [work(10, at="q")])], [("A", "B")]),
        ["Report the detection of the child", "Meet"],
    )
    plan = planned(instance, Fleet((robots("a"), robots("b", speed=2.0, position=at(0)))), scene(q=30))
    text = instance.tree.action(instance.node["A.0"]).text
    assert f"waits for a-1: {text}" in {one.text for one in words_in(parsed(gantt_svg(plan, 1)))}
    narrow = {one.text for one in words_in(parsed(gantt_svg(plan, 1, width=480)))}
    assert [word for word in narrow if word.startswith("waits")] in ([f"waits for a-1: {text}"], ["waits for a-1"])


def test_roles_are_cut_in_their_middle_since_they_differ_at_their_ends() -> None:
    parts = [Part(f"Measure the gas at the far station {number}", "a", [work(20)]) for number in range(8)]
    root = parsed(gantt_svg(planned(mission(parts), Fleet((robots("a"),))), 1))
    cut = [one.text for one in words_in(root) if "…" in one.text]
    assert len(set(cut)) == len(cut) == 8
    assert all(re.fullmatch(r"Meas.*….*\d", text) for text in cut)


def test_the_tint_of_joint_work_lies_over_the_words_of_its_rows() -> None:
    """A halo in the colour of the ground is tinted with the ground: no patch is seen round the words."""
    instance = mission([Part("A", "a", [work(7), work(30, sync=0)]), Part("B", "b", [work(2), work(30, sync=0)])])
    root = parsed(gantt_svg(planned(instance, Fleet((robots("a"), robots("b")))), 1))
    order = [element.get("class") or "" for element in root]
    assert order.index("mt-joint mt-line") < order.index("mt-row mt-hue-0") < order.index("mt-joint mt-fill")
    tint = next(element for element in root if element.get("class") == "mt-joint mt-fill")
    upper, lower = (bars_in(root)[instance.node[name]] for name in ("A.1", "B.1"))
    assert float(tint.get("y", "")) == upper.bottom
    assert float(tint.get("y", "")) + float(tint.get("height", "")) == pytest.approx(lower.top)


def test_times_in_the_list_are_in_the_unit_of_the_axis_and_moves_tell_their_metres() -> None:
    """Of 1,205 s, which the axis counts in minutes, 5 s are too little for words."""
    instance = worded(
        mission([Part("A", "a", [work(600), work(5), work(600)])]), ["A long report to everybody who listens"]
    )
    words = {one.text for one in words_in(parsed(gantt_svg(planned(instance, Fleet((robots("a"),))), 1)))}
    assert "A long report to everybody who listens (10:00 to 10:05 min)" in words


def test_the_list_says_who_hands_over_to_whom() -> None:
    """The first second of B, 601 to 602 s, is too short for words, and the next action follows at once."""
    parts = [
        Part("A", "a", [work(600), work(1, at="p")]),
        Part("B", "b", [work(1, at="p"), work(600)]),
    ]
    instance = worded(
        mission(parts, [("A", "B", "hand_over")]),
        ["Bring the crate", "Put it down for whoever comes", "Take it up from whoever came"],
    )
    fleet = Fleet((robots("a"), robots("b")))
    words = {one.text for one in words_in(parsed(gantt_svg(planned(instance, fleet, scene(p=0)), 1)))}
    assert "Take it up from whoever came (10:01 to 10:02 min), takes over from a-1" in words


def test_a_flag_stands_at_each_deadline_that_the_axis_reaches() -> None:
    """A, 20 s, by 25 s, and B, 40 s, by 90 s, which is after the end; the legend has a flag of its own."""
    instance = mission([Part("A", "a", [work(20)]), Part("B", "b", [work(40)])]).timed(
        A=(0, 25), B=(0, 90), root=(0, 95)
    )
    root = parsed(gantt_svg(planned(instance, Fleet((robots("a"), robots("b")))), 1))
    titles = [group.find(f"{SVG}title") for group in root.iter(f"{SVG}g") if group.get("class") == "mt-due"]
    assert [title.text for title in titles if title is not None] == ["A must end by 25 s"]
    written = " ".join(text.text or "" for text in root.iter(f"{SVG}text"))
    assert "a deadline of something in the row" in written
    assert "due by 95 s" in written
    bars = [title.text or "" for title in root.iter(f"{SVG}title")]
    assert any("must end by 90 s" in title for title in bars)


def test_a_wait_for_a_release_time_is_told() -> None:
    instance = mission([Part("A", "a", [work(2), work(3)])]).timed(A_1=(5, None))
    svg = gantt_svg(planned(instance, Fleet((robots("a"),))), 1)
    assert "until it may start, at 5 s" in svg
