"""What a waiting robot is said to wait for."""

from missiontree.mission.fleet import Fleet
from missiontree.mission.plan import Plan
from missiontree.reporting.critical.bonds import Bonds
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
