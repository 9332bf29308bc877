"""Which robot would shorten the schedule of an instance from elsewhere, with numbers that can be derived by hand."""

from __future__ import annotations

import pytest

from missiontree.explaining.instance_length import instance_length
from missiontree.instances import Instance, plan_of_instance, schedule_instance
from missiontree.mission.chain import WhySoLong
from missiontree.mission.coalitions import CoalitionMission, CoalitionTask
from missiontree.mission.columns import AND, LEAF, XOR
from missiontree.mission.control import Control
from missiontree.reporting.critical.additions import addition_lines
from tests.scheduling.joint.small_trees import columns


def asked(instance: Instance, control: Control | None = None) -> tuple[WhySoLong, list[str]]:
    schedule = schedule_instance(instance, solver=False)
    plan = plan_of_instance(instance, schedule, "instance")
    why = instance_length(plan, instance, control or Control(), solver=False)
    return why, list(addition_lines(why, plan.schedules[0], plan.brief.fleet))


def test_one_more_of_the_busy_robot_halves_what_it_does_alone() -> None:
    """Two actions of 3 s by robot 0 and one of 1 s by robot 1: 6 s, and 3 s with two robots like robot 0; no other helps."""
    why, lines = asked(columns([AND, LEAF, LEAF, LEAF], [-1, 0, 0, 0], [0, 0, 0, 1], [0, 3, 3, 1]))
    assert [(dict(one.robots), one.verdict, one.makespan_s) for one in why.additions] == [
        ({"robot-0": 1}, "shorter", 3.0),
        ({"robot-1": 1}, "not_shorter", 6.0),
    ]
    assert lines == [
        "one more robot-0: 3 s instead of 6 s (proven shortest); without it that is impossible",
        "one more robot-1: no schedule is shorter than 6 s, proven by load",
    ]


def test_with_one_more_robot_another_way_is_taken() -> None:
    """
    Robot 0 works 4 s, and either 5 s more or robot 1 does 8 s instead: 8 s.

    A second robot like robot 0 does the 5 s beside the 4 s, which is 5 s; robot 1 is needed once at most.
    """
    tree = columns([AND, LEAF, XOR, LEAF, LEAF], [-1, 0, 0, 2, 2], [0, 0, 0, 0, 1], [0, 4, 0, 5, 8])
    why, _ = asked(tree)
    assert why.chain.makespan_s == 8
    assert next((dict(one.robots), one.verdict, one.makespan_s) for one in why.additions) == (
        {"robot-0": 1},
        "shorter",
        5.0,
    )


def test_where_order_makes_the_length_no_robot_helps_and_that_is_proven() -> None:
    why, lines = asked(columns([AND, LEAF, LEAF], [-1, 0, 0], [0, 0, 1], [0, 3, 4], [(1, 2)]))
    assert [one.verdict for one in why.additions] == ["not_shorter", "not_shorter"]
    assert lines[-1].startswith("No single one of these shortens it: no part of the chain waits for a busy robot;")


def test_equal_robots_are_one_more_of_their_type() -> None:
    """Three actions of 2 s by two equal robots: 4 s; by three: 2 s."""
    tree = columns([AND, LEAF, LEAF, LEAF], [-1, 0, 0, 0], [0] * 4, [0, 2, 2, 2], robots=1, count=[2])
    why, _ = asked(tree)
    assert [(dict(one.robots), one.verdict, one.makespan_s) for one in why.additions] == [
        ({"robot-0": 1}, "shorter", 2.0)
    ]


def coalitions(robots: int) -> CoalitionMission:
    """Two tasks of 10 s, 30 m to either side of the start, which is the end as well; all robots are alike."""
    tasks = tuple(CoalitionTask(needs=(0,), duration_s=10, x_m=x, y_m=0.0) for x in (-30.0, 30.0))
    return CoalitionMission(skills=((0,),) * robots, tasks=tasks, start=(0.0, 0.0), end=(0.0, 0.0))


def test_a_second_robot_does_the_other_task() -> None:
    """Alone: 30 + 10 + 60 + 10 + 30 = 140 s. Two: 30 + 10 + 30 = 70 s each."""
    why, _ = asked(coalitions(1))
    assert why.chain.makespan_s == 140
    assert [(dict(one.robots), one.verdict, one.makespan_s) for one in why.additions] == [
        ({"robot-0": 1}, "shorter", 70.0)
    ]


def test_a_team_that_is_as_large_as_it_may_be_gets_nobody_more() -> None:
    why, lines = asked(coalitions(12))
    assert why.additions == ()
    assert lines == ["No further robot was tried: a mission of coalitions has 12 at most."]


@pytest.mark.parametrize("looks", [0, 1])
def test_what_was_tried_before_a_stop_is_kept(looks: int) -> None:
    """Two types could be tried; with a stop before the first or the second, as many have been."""
    left = [looks]

    def stop() -> bool:
        left[0] -= 1
        return left[0] < 0

    tree = columns([AND, LEAF, LEAF], [-1, 0, 0], [0, 0, 1], [0, 3, 4], [(1, 2)])
    why, lines = asked(tree, Control(stop=stop))
    assert len(why.additions) == looks
    assert why.chain.makespan_s == 7
    several = ("2 further additions were", "1 further addition was")[looks]
    assert lines[looks:] == [
        f"{several} not tried, for want of time.",
        *["Nothing was found that shortens it."] * looks,
    ]


def test_nothing_is_tried_for_a_schedule_that_takes_no_time() -> None:
    why, _ = asked(columns([AND, LEAF], [-1, 0], [0, 0], [0, 0], robots=1))
    assert (why.chain.steps, why.additions) == ((), ())
