"""Robots that come late or leave early, release times and deadlines: drawn where they are, and told in the terminal."""

from missiontree.mission.fleet import Fleet, Robot
from missiontree.mission.plan import Plan
from missiontree.reporting.gantt.away import away_of
from missiontree.reporting.gantt.view import gantt_svg
from missiontree.reporting.text import plan_text
from tests.reporting.charts import SVG, axis_of, clashes, parsed, planned, titles_in
from tests.scheduling.instances import Part, mission, robots, work


def sample() -> Plan:
    """a takes part from 10 s to 40 s and works 20 s, from 10 s on; b works 15 s after it, until 45 s."""
    instance = mission([Part("A", "a", [work(20)]), Part("B", "b", [work(15)])], [("A", "B")])
    fleet = Fleet((robots("a", available_from_s=10.0, available_until_s=40.0), robots("b")))
    return planned(instance.timed(A=(5, 35), B=(12, 50)), fleet)


def test_the_times_in_which_a_robot_is_away_are_hatched_where_they_are() -> None:
    """From 0 to 10 s and from 40 s to the end at 45 s, in the row of a alone."""
    root = parsed(gantt_svg(sample(), 1))
    left, right = axis_of(root)
    spans = [
        (float(rect.get("x", "")), float(rect.get("width", "")), rect.findtext(f"{SVG}title"))
        for rect in root.iter(f"{SVG}rect")
        if (rect.get("fill") or "").endswith("-away)") and rect.find(f"{SVG}title") is not None
    ]
    second = (right - left) / 45
    assert [(round((x - left) / second, 1), round(wide / second, 1)) for x, wide, _ in spans] == [
        (0.0, 10.0),
        (40.0, 5.0),
    ]
    assert [title for _, _, title in spans] == ["a-1 takes part from 10 s on", "a-1 takes part until 40 s"]
    assert "the robot takes no part" in gantt_svg(sample(), 1)
    assert clashes(root) == []


def test_where_everybody_is_there_nothing_is_hatched() -> None:
    plan = planned(mission([Part("A", "a", [work(3)])]), Fleet((robots("a", available_until_s=3.0),)))
    assert "-away" not in gantt_svg(plan, 1)
    assert "takes no part" not in plan_text(plan)
    assert not any("takes part" in title for title in titles_in(parsed(gantt_svg(plan, 1))))


def test_a_robot_that_comes_after_the_end_is_away_for_all_of_it() -> None:
    fleet = Fleet((robots("a", robots=(Robot(id="ada", available_from_s=99.0),)),))
    assert [(away.start_s, away.end_s) for away in away_of(fleet, "ada", 7.0)] == [(0.0, 7.0)]
    assert away_of(fleet, "stranger", 7.0) == []


def test_the_terminal_tells_who_is_away_and_which_times_are_kept() -> None:
    """The release of A is over before its robot comes; that of B before A has ended."""
    lines = [" ".join(line.split()) for line in plan_text(sample()).splitlines()]
    assert "a-1 0.0 10.0 s not here yet" in lines
    assert "40.0 45.0 s left" in lines
    assert "◆ 10.0 30.0 s A.0, not before 5 s, due by 35 s" in lines
    assert "b-1 ◆ 30.0 45.0 s B.0, not before 12 s, due by 50 s" in lines
    bars = next(line for line in lines if line.startswith("a-1 ╱"))
    assert bars.endswith("╱")


def test_a_time_stands_at_the_action_that_has_to_keep_it() -> None:
    """The release at the first action of what has it, the deadline at the last; those of the whole mission at none."""
    instance = mission([Part("A", "a", [work(2), work(3), work(4)])]).timed(A=(1, 30), root=(0, 99))
    text = plan_text(planned(instance, Fleet((robots("a"),))))
    assert "A.0, not before 1 s\n" in text
    assert "A.1\n" in text
    assert "A.2, due by 30 s\n" in text
    assert "due by 99 s" in text.partition("Schedule of alternative")[2].splitlines()[0]
