"""Gantt charts: everything where the schedule puts it, words that never touch, and words alone where there is no schedule."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from missiontree.errors import InputError
from missiontree.mission.certificate import Certificate
from missiontree.mission.fleet import Fleet
from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason
from missiontree.mission.schedule import Schedule, ScheduledAction
from missiontree.mission.terms import Terms
from missiontree.reporting.gantt.layout import MIN_BAR
from missiontree.reporting.gantt.view import gantt_svg
from missiontree.reporting.palette import HUES
from tests.reporting.charts import (
    SVG,
    axis_of,
    bars_in,
    clashes,
    parsed,
    plan_of,
    planned,
    plans,
    titles_in,
    worded,
    words_in,
)
from tests.scheduling.instances import Instance, Part, at, mission, move, robots, scene, work


def two_robots() -> Plan:
    """A takes 20 + 60 s, B comes after A and takes 20 s: 100 s in all."""
    instance = mission([Part("A", "a", [work(20), work(60)]), Part("B", "b", [work(20)])], [("A", "B")])
    return planned(instance, Fleet((robots("a"), robots("b"), robots("c", 2))))


def all_words(svg: str) -> list[str]:
    return [one.text for one in words_in(parsed(svg))]


def test_bars_stand_where_the_schedule_puts_them() -> None:
    """The axis runs from 0 to 100 s: 20 s are a fifth of it, 80 s four fifths."""
    root = parsed(gantt_svg(two_robots(), 1))
    left, right = axis_of(root)
    at_20, at_80 = left + (right - left) / 5, left + (right - left) * 4 / 5
    first, second, third = (bars_in(root)[leaf] for leaf in sorted(bars_in(root)))
    assert (first.left, first.right) == pytest.approx((left, at_20), abs=0.11)  # numbers are written to a tenth
    assert (second.left, second.right) == pytest.approx((at_20, at_80), abs=0.11)
    assert (third.left, third.right) == pytest.approx((at_80, right), abs=0.11)
    assert first.top == second.top
    assert third.top > first.bottom


def test_the_axis_has_its_unit_and_the_end_its_value() -> None:
    words = all_words(gantt_svg(two_robots(), 1))
    assert {"0", "20 s", "40 s", "60 s", "80 s", "100 s"} <= set(words)
    assert any("done after 100 s" in line for line in words)


def test_robots_are_rows_in_the_order_of_the_fleet_and_the_idle_are_told() -> None:
    root = parsed(gantt_svg(two_robots(), 1))
    top = {one.text: one.top for one in words_in(root)}
    assert top["a-1"] < top["b-1"]
    assert "Idle: c-1, c-2" in top
    assert "c-1" not in top


def test_every_bar_tells_its_exact_times_and_its_role() -> None:
    assert "A.1\na-1, 20 s to 80 s (60 s)\npart of A" in titles_in(parsed(gantt_svg(two_robots(), 1)))


def test_a_move_tells_its_metres_and_a_way_stands_before_its_action() -> None:
    """6 m at 2 m/s to q for a move of 3 s; then 8 m more for 4 s before the work at p."""
    instance = mission([Part("A", "a", [move("q"), work(5, at="p")])])
    plan = planned(instance, Fleet((robots("a", speed=2.0, position=at(0)),)), scene(q=6, p=14))
    root = parsed(gantt_svg(plan, 1))
    titles = titles_in(root)
    assert any(title.startswith("A.0\na-1, 0 s to 3 s (3 s)") and title.endswith("6.0 m") for title in titles)
    assert "on the way to: A.1\na-1, 3 s to 7 s\n8.0 m" in titles
    assert {"A.0 · 6 m", "8 m"} <= {one.text for one in words_in(root)}


def going_home(*works: int) -> Plan:
    """Works at p, 60 m from home at 1 m/s: there and back takes 120 s."""
    instance = mission([Part("A", "a", [work(each, at="p") for each in works])])
    fleet = Fleet((robots("a", speed=1.0, position=at(0)),))
    return planned(instance, fleet, scene(p=60), Terms(return_home=True))


def test_metres_of_the_way_home_keep_off_the_line_at_the_end() -> None:
    """60 of 2,000 s are too little for the words, which begin before their way."""
    root = parsed(gantt_svg(going_home(1880), 1))
    right = axis_of(root)[1]
    (words,) = (one for one in words_in(root) if one.text == "home, 60 m")
    home = right - 0.03 * (right - axis_of(root)[0])
    assert words.left < home
    assert home < words.right < right


def test_metres_make_way_for_a_number_and_stay_under_their_way() -> None:
    """The second of two works, 2 of 700 s, is numbered; in the middle of the 60 s after it the words would touch the number."""
    root = parsed(gantt_svg(going_home(578, 2), 1))
    left, right = axis_of(root)
    (number,) = (one for one in words_in(root) if one.text == "1" and one.left > (left + right) / 2)
    (words,) = (one for one in words_in(root) if one.text == "home, 60 m")
    way = (right - 60 / 700 * (right - left), right)
    assert words.left > number.right + 5
    assert (words.left + words.right) / 2 > sum(way) / 2 + 1
    assert words.right < right


def test_waiting_is_dotted_and_says_for_what() -> None:
    """B has done its part after 2 s, A after 7 s; B waits 5 s to do the rest together with A."""
    instance = mission([Part("A", "a", [work(7), work(3, sync=0)]), Part("B", "b", [work(2), work(3, sync=0)])])
    root = parsed(gantt_svg(planned(instance, Fleet((robots("a"), robots("b")))), 1))
    assert "b-1 waits, 2 s to 7 s (5 s)\nfor a-1, to do it together" in titles_in(root)
    assert {"waiting", "done together"} <= {one.text for one in words_in(root)}
    joined = [path for path in root.iter(f"{SVG}path") if path.get("class") == "mt-joint mt-line"]
    assert len(joined) == 2  # between the rows, and in the legend


def test_the_critical_chain_is_outlined_and_marked_and_explained() -> None:
    """A then B are the chain; C of 1 s beside them is not."""
    instance = mission(
        [Part("A", "a", [work(20)]), Part("B", "b", [work(20)]), Part("C", "c", [work(1)])], [("A", "B")]
    )
    root = parsed(gantt_svg(planned(instance, Fleet((robots("a"), robots("b"), robots("c")))), 1))
    rows = [group for group in root.iter(f"{SVG}g") if (group.get("class") or "").startswith("mt-row")]
    lit = [any("mt-critical" in (path.get("class") or "") for path in row.iter(f"{SVG}path")) for row in rows]
    assert lit == [True, True, False]
    assert any("critical chain" in one.text for one in words_in(root))


def test_arrows_go_between_robots_and_not_along_a_row() -> None:
    """A before B on two robots, A before C on one: one arrow, lit since A and B are the chain. D before B has slack: a quiet one."""
    instance = mission(
        [Part("A", "a", [work(9)]), Part("B", "b", [work(9)]), Part("C", "a", [work(1)]), Part("D", "d", [work(2)])],
        [("A", "B"), ("A", "C"), ("D", "B")],
    )
    root = parsed(gantt_svg(planned(instance, Fleet((robots("a"), robots("b"), robots("d")))), 1))
    drawn = [path.get("class") for path in root.findall(f"{SVG}path")]
    assert drawn.count("mt-critical mt-fill") == 1
    assert drawn.count("mt-link mt-fill") == 1
    assert {"comes first", "where it goes on"} <= {one.text for one in words_in(root)}


def test_a_chain_of_one_robot_needs_no_sign_for_going_on() -> None:
    plan = planned(mission([Part("A", "a", [work(9), work(9)])]), Fleet((robots("a"),)))
    assert "where it goes on" not in all_words(gantt_svg(plan, 1))


@pytest.mark.parametrize(("action", "times"), [("Weld", 1), ("Weld it", 0)])
def test_a_role_that_its_one_action_says_has_no_caption_of_its_own(action: str, times: int) -> None:
    """The role Weld is written over an action of other words, and not over one of the same, which stands in its bar."""
    instance = worded(mission([Part("Weld", "a", [work(20)])]), [action])
    words = all_words(gantt_svg(planned(instance, Fleet((robots("a"),))), 1))
    assert (words.count("Weld"), words.count(action)) == (1, 1)
    assert len([word for word in words if word.startswith("Weld")]) == 2 - times


def test_arrows_of_one_moment_that_go_up_and_down_stand_side_by_side() -> None:
    """At 5 s b-1 goes on after a-1, and a-1 after b-1: one line with a head at both ends would say neither."""
    parts = [Part("A", "a", [work(5)]), Part("C", "b", [work(5)]), Part("B", "b", [work(3)]), Part("D", "a", [work(2)])]
    root = parsed(gantt_svg(planned(mission(parts, [("A", "B"), ("C", "D")]), Fleet((robots("a"), robots("b")))), 1))
    lines = [
        path.get("d", "")
        for path in root.iter(f"{SVG}path")
        if path.get("class") in {"mt-link mt-line", "mt-critical mt-line"} and path.get("pointer-events") is None
    ]
    begin = sorted(float(line.split()[0].removeprefix("M")) for line in lines)
    down, up = (x for x in reversed(begin) if x > axis_of(root)[0])  # what is left of the axis stands in the legend
    assert down - up >= 3


def test_words_that_do_not_fit_are_numbered_and_listed() -> None:
    """An action of 1 s in 100 s is a hundredth of the axis: a few pixels, followed at once by the next."""
    instance = worded(
        mission([Part("A", "a", [work(1), work(99)])]), ["A long report to everybody who listens", "Rest"]
    )
    root = parsed(gantt_svg(planned(instance, Fleet((robots("a"),))), 1))
    words = [one.text for one in words_in(root)]
    short = instance.tree.action(min(bars_in(root))).text
    assert "1" in words
    assert f"{short} (0 to 1 s)" in words


def test_an_action_without_duration_is_seen() -> None:
    instance = mission([Part("A", "a", [work(0), work(50), work(0)])])
    bars = bars_in(parsed(gantt_svg(planned(instance, Fleet((robots("a"),))), 1)))
    widths = [bars[leaf].right - bars[leaf].left for leaf in sorted(bars)]
    assert widths[0] == widths[2] == MIN_BAR
    assert widths[1] > 500


def test_where_nothing_takes_time_the_order_is_told_in_words() -> None:
    instance = mission([Part("A", "a", [work(0), work(0)])])
    words = all_words(gantt_svg(planned(instance, Fleet((robots("a"),))), 1))
    assert "Alternative 1: no action takes time, as far as is known; only the order can be told" in words
    assert "a-1: A.0, then A.1" in words


def without(status: str, *reasons: Reason) -> Plan:
    plan = two_robots()
    claim = "proven" if status == "infeasible" else "unproven"
    schedule = Schedule(
        rank=1,
        status=status,  # type: ignore[arg-type]
        certificate=Certificate(claim=claim, method="by_hand", detail="It was tried."),  # type: ignore[arg-type]
        reasons=reasons,
    )
    return replace(plan, schedules=(schedule,))


def test_an_infeasible_schedule_is_a_picture_of_its_reasons() -> None:
    reason = Reason(rule="deadlock", message="A waits for B, and B for A.", hint="Drop one of the links.")
    assert sorted(all_words(gantt_svg(without("infeasible", reason), 1))) == [
        "A waits for B, and B for A. Drop one of the links.",
        "Alternative 1 cannot be scheduled, which is proven",
        "Test the chart",
    ]


def test_a_schedule_that_was_not_found_is_not_said_to_be_impossible() -> None:
    words = all_words(gantt_svg(without("unknown"), 1))
    assert "No schedule of alternative 1 was found, and none is excluded" in words
    assert "It was tried." in words


def test_an_alternative_that_there_is_not_has_a_picture_that_says_so() -> None:
    assert "There is no schedule of an alternative 7" in all_words(gantt_svg(two_robots(), 7))


def test_a_plan_that_points_past_its_tree_is_refused() -> None:
    plan = two_robots()
    stray = ScheduledAction(leaf=99, robot="a-1", start_s=0, end_s=1)
    broken = replace(plan, schedules=(replace(plan.schedules[0], actions=(stray,)),))
    with pytest.raises(InputError, match="node 99"):
        gantt_svg(broken, 1)


def test_a_robot_that_the_fleet_does_not_have_is_drawn_all_the_same() -> None:
    plan = two_robots()
    moved = tuple(replace(one, robot="stranger") for one in plan.schedules[0].actions if one.start_s == 0)
    svg = gantt_svg(replace(plan, schedules=(replace(plan.schedules[0], actions=moved, legs=()),)), 1)
    assert "stranger" in all_words(svg)


def test_names_are_never_markup() -> None:
    hostile = "<script>\x1b[31malert('&')</script>\u202e]]>"
    instance = worded(mission([Part("A", "a", [work(5)])]), [hostile])
    plan = planned(instance, Fleet((robots("a", label=hostile),)))
    svg = gantt_svg(plan, 1)
    root = parsed(svg)
    assert "<script" not in svg
    assert "\x1b" not in svg
    assert {element.tag.removeprefix(SVG) for element in root.iter()} <= {
        *("svg", "title", "desc", "defs", "pattern", "g", "rect", "path", "text")
    }
    assert not {name for element in root.iter() for name in element.attrib if name.startswith("on") or "href" in name}


def test_the_picture_says_what_it_is_to_whoever_cannot_see_it() -> None:
    root = parsed(gantt_svg(two_robots(), 1))
    assert root.get("role") == "img"
    ids = {element.get("id"): element for element in root.iter() if element.get("id")}
    title, description = (ids[name] for name in (root.get("aria-labelledby") or "").split())
    assert title.text == "Test the chart: schedule of alternative 1"
    assert "b-1: B, 80 s to 100 s." in (description.text or "")
    assert "The critical chain runs through a-1, b-1." in (description.text or "")


def test_ids_are_unique_and_all_that_is_asked_for_is_there() -> None:
    svg = gantt_svg(crowd(30, 2), 1)
    root = parsed(svg)
    ids = [element.get("id") for element in root.iter() if element.get("id")]
    assert len(ids) == len(set(ids))
    asked = {value[5:-1] for element in root.iter() for value in element.attrib.values() if value.startswith("url(#")}
    assert asked <= set(ids)
    assert len({one for one in asked if "-hue-" in one}) == 20  # robots 11 to 30 are hatched


def crowd(count: int, actions: int, each_s: float = 10) -> Plan:
    """As many robots, each with a role of so many actions."""
    parts = [Part(f"P{number}", "a", [work(each_s)] * actions) for number in range(count)]
    return planned(mission(parts), Fleet((robots("a", count),)))


def test_more_robots_are_packed_closer() -> None:
    heights = [  # from one row to the next
        min(after - before for before, after in pairwise(sorted({bar.top for bar in bars_in(root).values()})))
        for root in (parsed(gantt_svg(crowd(count, 1), 1)) for count in (10, 40, 200))
    ]
    assert heights[0] > 50
    assert 30 < heights[1] < 45
    assert heights[2] < 18


def test_beyond_two_hundred_robots_the_least_busy_ones_are_summed_up() -> None:
    """205 robots with 1 action, one of them longer: the makespan is its, so it is kept; five others are not drawn."""
    parts = [Part(f"P{number}", "a", [work(20 if number == 203 else 10)]) for number in range(205)]
    plan = planned(mission(parts), Fleet((robots("a", 205),)))
    root = parsed(gantt_svg(plan, 1))
    assert len(bars_in(root)) == 200
    longest = max(plan.schedules[0].actions, key=lambda one: one.end_s)
    assert longest.leaf in bars_in(root)
    words = [one.text for one in words_in(root)]
    assert "And 5 more robots with 5 actions, the least busy ones, which are not drawn." in words


def test_beyond_two_thousand_actions_the_short_ones_are_drawn_as_one() -> None:
    """Twenty robots with 150 actions of 1 s each are 3,000; each is a hundred-and-fiftieth of the axis, about six pixels."""
    plan = crowd(20, 150, 1)
    root = parsed(gantt_svg(plan, 1))
    assert len(bars_in(root)) <= 2000
    assert "Actions too short to tell apart are drawn as one bar." in [one.text for one in words_in(root)]
    assert any(title.startswith("150 actions, 0 s to 150 s\nP") for title in titles_in(root))


@given(plans(), st.sampled_from((480.0, 1100.0, 2000.0)))
@settings(max_examples=60)
def test_words_never_touch_or_leave_the_picture(plan: Plan, width: float) -> None:
    assert clashes(parsed(gantt_svg(plan, 1, width=width))) == []


@given(st.integers(1, 60), st.integers(1, 6), st.sampled_from((0.5, 7.0, 4_000.0)), st.sampled_from((480.0, 1100.0)))
@settings(max_examples=15)
def test_words_never_touch_in_a_crowd(count: int, actions: int, each_s: float, width: float) -> None:
    assert clashes(parsed(gantt_svg(crowd(count, actions, each_s), 1, width=width))) == []


@given(
    st.lists(st.lists(st.sampled_from((0, 0.2, 0.4, 1, 2, 30)), min_size=1, max_size=14), min_size=1, max_size=6),
    st.sampled_from((480.0, 1100.0)),
    st.sampled_from((1, 2)),
)
@settings(max_examples=80)
def test_words_of_short_actions_never_touch(durations: list[list[float]], width: float, count: int) -> None:
    """Short and long actions in all orders, in roles one after the other and beside each other."""
    parts = [Part(f"Part {number} of all", "a", [work(one) for one in each]) for number, each in enumerate(durations)]
    plan = planned(mission(parts), Fleet((robots("a", count),)))
    assert clashes(parsed(gantt_svg(plan, 1, width=width))) == []


def test_the_name_of_a_role_gives_way_to_the_one_before() -> None:
    """Roles at 0 and 50 s with 2 s between the second and the third: the second name has room on its left only, where the first is."""
    names = (
        "The first role of the mission, with a long name",
        "The second role, with a name that is longer than all the others",
        "The third",
    )
    instance = mission([Part(name, "a", [work(1 if name != "The third" else 47)]) for name in names])
    plan = planned(instance, Fleet((robots("a"),)))
    starts = {0: 0.0, 1: 50.0, 2: 53.0}
    moved = tuple(
        replace(one, start_s=starts[role], end_s=starts[role] + one.end_s - one.start_s)
        for one in plan.schedules[0].actions
        for role in (instance.tree.action(one.leaf).role,)
    )
    root = parsed(gantt_svg(replace(plan, schedules=(replace(plan.schedules[0], actions=moved),)), 1))
    assert clashes(root) == []
    assert {names[0], names[2]} <= {one.text for one in words_in(root)}


@given(plans())
@settings(max_examples=60)
def test_every_action_is_a_bar_in_its_place(plan: Plan) -> None:
    schedule = plan.schedules[0]
    svg = gantt_svg(plan, 1)
    assert svg == gantt_svg(plan, 1)
    root = parsed(svg)
    if not schedule.makespan_s:
        assert bars_in(root) == {}
        return
    left, right = axis_of(root)
    bars = bars_in(root)
    assert set(bars) == {one.leaf for one in schedule.actions}
    rows: dict[str, set[float]] = {}
    for one in schedule.actions:
        bar, per_s = bars[one.leaf], (right - left) / schedule.makespan_s
        assert bar.left == pytest.approx(left + one.start_s * per_s, abs=0.16)
        assert bar.right == pytest.approx(max(left + one.end_s * per_s, bar.left + MIN_BAR), abs=0.26)
        rows.setdefault(one.robot, set()).add(bar.top)
    assert all(len(tops) == 1 for tops in rows.values())
    assert len({tops.pop() for tops in rows.values()}) == len({one.robot for one in schedule.actions})


@given(plans())
@settings(max_examples=40)
def test_every_bar_has_its_exact_times_as_a_title(plan: Plan) -> None:
    root = parsed(gantt_svg(plan, 1))
    found = {
        int(rect.get("data-leaf", "")): rect.findtext(f"{SVG}title") or ""
        for rect in root.iter(f"{SVG}rect")
        if rect.get("data-leaf")
    }
    for one in plan.schedules[0].actions if plan.schedules[0].makespan_s else ():
        line = found[one.leaf].split("\n")[1]
        who, _, times = line.partition(", ")
        start, _, rest = times.partition(" s to ")
        end = rest.partition(" s (")[0]
        assert (who, float(start), float(end)) == (one.robot, one.start_s, one.end_s)


def test_a_robot_has_the_same_hue_in_every_alternative() -> None:
    instance: Instance = mission([Part("B", "b", [work(5)])])
    fleet = Fleet((robots("a"), robots("b")))
    plan = planned(instance, fleet)
    second = replace(plan.schedules[0], rank=2)
    both = replace(plan_of(instance, plan.schedules[0], fleet), schedules=(plan.schedules[0], second))
    for rank in (1, 2):
        assert f'class="mt-fill" fill="{HUES[1].fill}"' in gantt_svg(both, rank)
