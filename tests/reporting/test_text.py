"""What a person reads first: outcome, alternatives, schedule, remarks; harmless whatever the names."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from missiontree import plan, plan_text
from missiontree.mission.area import Area, Zone
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.position import Position
from missiontree.mission.reason import Reason
from missiontree.mission.scene import Scene
from missiontree.mission.ways import Road, RoadGraph
from missiontree.reporting.text import reason_line, render, said_once, seconds
from missiontree.samples.catalogue import sample_file

FLEET = Fleet(
    (
        RobotType(
            id="bad",
            label="[red]\x1b[31m\u202eevil\nnext line[/red]",
            count=1,
            capabilities={"search": 1.0},
        ),
    )
)


@pytest.mark.parametrize(
    ("time_s", "text"), [(0, "0.0 s"), (95.49, "95.5 s"), (599.94, "599.9 s"), (600, "0:10:00"), (3723, "1:02:03")]
)
def test_times_are_for_people(time_s: float, text: str) -> None:
    assert seconds(time_s) == text


def test_names_of_users_are_words_and_nothing_else() -> None:
    text = plan_text(plan("Find the keys", fleet=FLEET))
    assert "[red]" in text  # shown as written, not obeyed
    assert "\x1b" not in text
    assert "\u202e" not in text
    assert "\nnext line" not in text


def test_no_line_is_wider_than_asked_or_ends_in_blanks() -> None:
    text = plan_text(plan(sample_file("site")), width=80)
    lines = text.splitlines()
    assert max(map(len, lines)) <= 80
    assert all(line == line.rstrip() for line in lines)


def test_a_reason_shows_its_mark_and_what_to_do() -> None:
    line = render(reason_line(Reason(rule="x", message="It is too heavy.", hint="Take a stronger robot.")))
    assert line == "✗ It is too heavy. Take a stronger robot.\n"
    part = render(reason_line(Reason(rule="x", message="It is too heavy.", hint="take a stronger robot")))
    assert part == line  # hints of every part of missiontree read alike


def test_every_robot_that_works_has_a_bar_and_a_list() -> None:
    made = plan(sample_file("site"))
    text = plan_text(made)
    for robot in {assignment.robot for assignment in made.schedules[0].assignments}:
        # One line with the bar, one with the first entry of the list.
        assert sum(line.lstrip().startswith(f"{robot} ") for line in text.splitlines()) == 2


def test_a_plan_that_is_declined_shows_why_and_no_schedule(tmp_path: Path) -> None:
    text = plan_text(plan(sample_file("restaurants")))
    assert text.startswith("Cannot be done: Recommend")
    assert "recommend" in text
    assert "Schedule" not in text


def test_a_reason_that_sums_up_does_not_repeat_what_stands_below_it() -> None:
    heavy = Reason(rule="limit_too_low", message="The porter carries 80 kg.")
    whole = Reason(rule="impossible", message="It cannot be done. The porter carries 80 kg. Reword it.")
    assert [reason.message for reason in said_once([whole, heavy])] == [
        "It cannot be done. Reword it.",
        "The porter carries 80 kg.",
    ]
    assert said_once([]) == []
    assert said_once([heavy, heavy]) == [heavy, heavy]


def test_why_a_mission_cannot_be_done_is_said_once() -> None:
    """A refusal that stands under Why does not stand under Not offered again."""
    depot = Entity(id="depot", kind="place", position=Position(0, 0))
    island = Entity(id="island", kind="place", position=Position(9, 0))
    fleet = Fleet((RobotType(id="walker", count=1, capabilities={"reach": 1.0}, place="depot"),))
    roads = RoadGraph(roads=(Road(ends=("depot", "island"), blocked=True),))
    made = plan("Reach the island", fleet=fleet, scene=Scene(places=(depot, island), roads=roads))
    assert made.outcome == "cannot_be_done"
    text = " ".join(plan_text(made).split())
    assert text.count("is blocked") == 1
    assert "Not offered" not in text


def test_what_is_refused_twice_alike_is_told_once() -> None:
    """Two goals of the same words: the crawler may enter the attic for neither."""
    attic = Entity(id="attic", kind="place", position=Position(5, 0))
    zone = Zone(id="upstairs", area=Area(corners=((4, -1), (6, -1), (6, 1), (4, 1))))
    kinds = [
        RobotType(id=name, count=1, capabilities={"reach": 1.0}, position=Position(0, 0))
        for name in ("walker", "crawler")
    ]
    fleet = Fleet((kinds[0], replace(kinds[1], zones=())))
    made = plan("Reach the attic. Reach the attic.", fleet=fleet, scene=Scene(places=(attic,), zones=(zone,)))
    assert made.grounding is not None
    assert len(made.grounding.not_offered) == 2
    assert " ".join(plan_text(made).split()).count("crawler cannot do") == 1


def test_a_long_team_is_told_by_what_sets_it_apart_from_the_best() -> None:
    """Seven searches, more than six; walkers are better than crawlers, so that the second best swaps one of them."""
    types = [
        RobotType(id="walker", count=7, capabilities={"search": 1.0}),
        RobotType(id="crawler", count=1, capabilities={"search": 0.9}),
    ]
    names = ["Ada", "Ben", "Cleo", "Dora", "Emil", "Fritz", "Gina"]
    made = plan(", ".join(f"find {name}" for name in names), fleet=Fleet(tuple(types)), k=2)
    text = plan_text(made)
    first, second = text.partition("as 1, but")[::2]
    second = second.partition("Schedule of")[0]
    assert all(f"Search({name}): walker" in first for name in names)
    assert second.count("Search(") == 1
    assert second.count(": crawler") == 1


def test_a_short_team_is_told_whole() -> None:
    assert "as 1" not in plan_text(plan(sample_file("site")))


@pytest.mark.parametrize(("searches", "title"), [(1, ": 67.0 s, optimal"), (9, ": 0:10:03 (603.0 s), optimal")])
def test_from_ten_minutes_on_the_title_counts_in_seconds_as_well(searches: int, title: str) -> None:
    """One robot, a search of 67 s after the other: 9 * 67 s = 603 s, and the lists count in seconds."""
    fleet = Fleet((RobotType(id="walker", count=1, capabilities={"search": 1.0}),))
    names = ["Ada", "Ben", "Cleo", "Dora", "Emil", "Fritz", "Gina", "Hugo", "Ida"][:searches]
    assert title in plan_text(plan(", then ".join(f"find {name}" for name in names), fleet=fleet))
