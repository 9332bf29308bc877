"""Shared resources in pictures of a schedule: who holds them, who waits for them, and what that makes of the critical chain."""

from __future__ import annotations

from dataclasses import replace

from missiontree.mission.fleet import Fleet
from missiontree.mission.plan import Plan
from missiontree.mission.scene import Scene
from missiontree.mission.shared_resource import SharedResource
from missiontree.reporting.critical.bonds import Bonds, Event
from missiontree.reporting.critical.chain import critical_chain
from missiontree.reporting.gantt.reading import content_of
from missiontree.reporting.gantt.view import gantt_svg
from missiontree.reporting.gantt.waits import why_waited
from missiontree.reporting.text import render
from missiontree.reporting.timeline.view import timeline
from tests.reporting.charts import planned
from tests.scheduling.instances import Instance, Part, at, mission, robots, scene, work


def made(*resources: SharedResource, first_s: float = 1) -> tuple[Instance, Plan]:
    """Robot a-1 works a while and then 4 s at the door, b-1 works 1 s and then 4 s at the door."""
    instance = mission(
        [
            Part("A", "a", [work(first_s), work(4, holds=["door"])]),
            Part("B", "b", [work(1), work(4, holds=["door"])]),
        ]
    )
    world = Scene(resources=resources)
    plan = planned(instance, Fleet((robots("a"), robots("b"))), world)
    return instance, replace(plan, brief=replace(plan.brief, scene=world))


DOOR = SharedResource(id="door", label="Fire Door")


def test_who_waits_for_a_resource_is_told_what_and_for_whom() -> None:
    """Both are there after 1 s; a-1 goes first, until 5 s, then b-1 until 9 s."""
    instance, plan = made(DOOR)
    bonds = Bonds(instance.tree, plan.schedules[0], plan.brief.scene)
    assert why_waited(bonds, instance.node["B.1"]) == "for Fire Door, which a-1 holds: A.1"
    assert why_waited(bonds, instance.node["A.1"]) == ""


def test_the_critical_chain_runs_through_the_resource() -> None:
    """A.0 0-1, A.1 1-5 and then, since the door is free, B.1 5-9; without the resources known the wait would be unexplained."""
    instance, plan = made(DOOR)
    chain = critical_chain(instance.tree, plan.schedules[0], plan.brief.scene)
    assert [(step.leaf, step.start_s, step.bond) for step in chain] == [
        (instance.node["A.0"], 0.0, "start"),
        (instance.node["A.1"], 1.0, "role"),
        (instance.node["B.1"], 5.0, "resource"),
    ]
    assert "unexplained" in {step.bond for step in critical_chain(instance.tree, plan.schedules[0])}


def test_a_resource_with_room_left_holds_nobody_up() -> None:
    """Room for two: B.1 ends by chance when nobody waits for it."""
    instance, plan = made(SharedResource(id="door", capacity=2), first_s=5)
    bonds = Bonds(instance.tree, plan.schedules[0], plan.brief.scene)
    starts = [Event("start", leaf) for leaf in bonds.at]
    assert "resource" not in {cause.bond for start in starts for cause in bonds.causes(start)}


def test_every_resource_that_is_held_has_a_row_with_who_holds_it() -> None:
    _, plan = made(DOOR, SharedResource(id="unused"))
    (row,) = content_of(plan, plan.schedules[0]).shared
    assert (row.name, row.capacity, row.lanes) == ("Fire Door", 1, 1)
    assert [(hold.start_s, hold.end_s, hold.robot, hold.lane) for hold in row.holds] == [
        (1, 5, "a-1", 0),
        (5, 9, "b-1", 0),
    ]


def test_robots_that_hold_at_once_stand_in_lines_of_their_own() -> None:
    _, plan = made(replace(DOOR, capacity=2))
    (row,) = content_of(plan, plan.schedules[0]).shared
    assert [(hold.robot, hold.lane) for hold in row.holds] == [("a-1", 0), ("b-1", 1)]


def test_the_picture_tells_who_holds_what_in_words_and_titles() -> None:
    _, plan = made(DOOR)
    picture = gantt_svg(plan, 1)
    assert "Fire Door</text>" in picture
    assert "shared, room for 1</text>" in picture
    assert "<title>a-1 holds Fire Door\nA.1\n1 s to 5 s (4 s)</title>" in picture
    assert "Fire Door is held by b-1, 5 s to 9 s." in picture


def test_the_terminal_shows_when_a_resource_is_held() -> None:
    """9 s on 72 characters: 8 for each second, so the door is held from the 8th on, in turn by a-1 and b-1."""
    _, plan = made(DOOR)
    lines = render(timeline(plan.schedules[0], plan), 100).splitlines()
    (line,) = [line for line in lines if line.startswith("Fire Door")]
    assert line.removeprefix("Fire Door  ") == " " * 8 + "▒" * 32 + "░" * 32
    assert any("▒░ a shared resource is held" in line for line in lines)
    _, wide = made(replace(DOOR, capacity=2))
    (line,) = [
        line for line in render(timeline(wide.schedules[0], wide), 100).splitlines() if line.startswith("Fire Door")
    ]
    assert set(line.removeprefix("Fire Door")) == {" ", "2"}


def test_a_robot_that_stands_there_already_waits_in_the_list() -> None:
    """a-1 and b-1 stand at the bay, which has room for one: b-1 waits 4 s, and what it waits for is told; who is just idle is not."""
    bay = Scene(entities=scene(bay=0).entities, resources=(SharedResource(id="door", label="Fire Door"),))
    instance = mission(
        [
            Part("A", "a", [work(4, at="bay", holds=["door"])]),
            Part("B", "b", [work(4, at="bay", holds=["door"])]),
            Part("C", "c", [work(1, at="bay")]),
        ],
        [("A", "C")],
    )
    kinds = tuple(robots(name, speed=1.0, position=at(0)) for name in "abc")
    plan = planned(instance, Fleet(kinds), bay)
    plan = replace(plan, brief=replace(plan.brief, scene=bay))
    rows = {row.robot: row for row in content_of(plan, plan.schedules[0]).rows}
    assert [(wait.start_s, wait.end_s, wait.label) for wait in rows["b-1"].waits] == [
        (0.0, 4.0, "for Fire Door, which a-1 holds: A.0")
    ]
    assert not rows["a-1"].waits
    assert not rows["c-1"].waits
