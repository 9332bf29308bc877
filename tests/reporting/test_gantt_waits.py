"""What a waiting robot is said to wait for."""

from dataclasses import replace

from missiontree.mission.fleet import Fleet
from missiontree.mission.plan import Plan
from missiontree.reporting.critical.bonds import Bonds
from missiontree.reporting.gantt.reading import content_of
from missiontree.reporting.gantt.waits import why_waited
from tests.reporting.charts import planned
from tests.scheduling.instances import Instance, Part, at, mission, move, robots, scene, work


def reason(instance: Instance, plan: Plan, action: str) -> str:
    return why_waited(Bonds(instance.tree, plan.schedules[0]), instance.node[action])


def test_what_comes_first_is_told_with_its_robot() -> None:
    instance = mission([Part("A", "a", [work(9)]), Part("B", "b", [work(1), work(1)])], [("A", "B.1")])
    assert reason(instance, planned(instance, Fleet((robots("a"), robots("b")))), "B.1") == "for a-1: A.0"


def test_a_joint_partner_that_comes_late_is_told_and_one_that_waits_itself_is_not() -> None:
    """A is ready after 9 s, B after 1 s: B waits for A, A waits for nobody."""
    instance = mission([Part("A", "a", [work(9), work(1, sync=0)]), Part("B", "b", [work(1), work(1, sync=0)])])
    plan = planned(instance, Fleet((robots("a"), robots("b"))))
    assert reason(instance, plan, "B.1") == "for a-1, to do it together"
    assert reason(instance, plan, "A.1") == ""


def test_who_still_needs_a_thing_is_told() -> None:
    instance = mission([Part("A", "a", [work(6, at="box")]), Part("B", "b", [move("box"), move("q", "box")])])
    fleet = Fleet((robots("a", position=at(2)), robots("b", speed=1.0, position=at(0))))
    assert reason(instance, planned(instance, fleet, scene(q=8, box=2)), "B.1") == "for a-1: A.0"


def test_what_must_be_under_way_first_is_told() -> None:
    """F begins after 5 s and must be under way when W.1 of 1 s ends; W.0 is over after 2 s, so that W.1 waits to end at 5.001 s."""
    instance = mission(
        [Part("F", "a", [work(5), work(1, open_ended=True)]), Part("W", "b", [work(2), work(1)])],
        [("F.1", "W.1", "until")],
    )
    plan = planned(instance, Fleet((robots("a"), robots("b"))))
    assert [(one.start_s, one.end_s) for one in plan.schedules[0].actions if one.leaf == instance.node["W.1"]] == [
        (4.001, 5.001)
    ]
    assert reason(instance, plan, "W.1") == "until a-1 has begun: F.1"


def test_waiting_until_an_action_may_start_is_shown_and_what_is_merely_idle_is_not() -> None:
    """B may start at 20 s, where its robot has had nothing to do since 5 s; C comes after B, and its robot is free till then."""
    instance = mission(
        [Part("A", "a", [work(5)]), Part("B", "a", [work(1)]), Part("C", "c", [work(1)])], [("A", "B"), ("B", "C")]
    )
    nodes = [
        replace(node, release_s=20.0) if index == instance.node["B"] else node
        for index, node in enumerate(instance.tree.nodes)
    ]
    released = Instance(replace(instance.tree, nodes=tuple(nodes)), instance.alternative, instance.node)
    plan = planned(released, Fleet((robots("a"), robots("c"))))
    rows = {row.robot: row for row in content_of(plan, plan.schedules[0]).rows}
    assert [(wait.start_s, wait.end_s, wait.label) for wait in rows["a-1"].waits] == [
        (5.0, 20.0, "until it may start, at 20 s")
    ]
    assert list(rows["c-1"].waits) == []
