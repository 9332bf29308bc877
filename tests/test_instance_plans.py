"""Schedules of instances as plans: the same actions, ways and names, and a critical chain that adds up."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import pytest

from missiontree.formats.importers.coalitions import coalitions_of
from missiontree.formats.importers.fjsp import shop_of
from missiontree.formats.reader import parse
from missiontree.instances import Instance, plan_of_instance, schedule_instance
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control
from missiontree.mission.plan import Plan
from missiontree.mission.tree_schedule import TreeSchedule
from missiontree.reporting.critical.chain import chain_of
from missiontree.reporting.critical.spans import ms
from missiontree.reporting.gantt.view import gantt_svg
from tests.formats.test_coalitions import GOOD
from tests.scheduling.coalitions import drawn as coalitions
from tests.scheduling.joint import small_trees

SHOP = "3 2\n2 2 0 3 1 5 1 1 2\n2 2 0 4 1 3 1 0 2\n1 2 0 6 1 4\n"


def planned(instance: Instance, title: str = "an instance") -> Plan:
    schedule = schedule_instance(instance, Control(time_limit_s=5), solver=False)
    return plan_of_instance(instance, schedule, title)


def adds_up(plan: Plan) -> None:
    """The chain explains every second, and a chart can be drawn."""
    schedule = plan.schedules[0]
    steps = chain_of(plan, schedule).steps
    assert "unexplained" not in {step.bond for step in steps}
    assert sum(ms(step.end_s) - ms(step.start_s) for step in steps) == ms(schedule.makespan_s)


def test_a_shop_keeps_its_machines_and_times() -> None:
    """Machine 1 does 3 s + 4 s + 2 s one after the other; that is the chain."""
    plan = planned(shop_of(SHOP, "shop.txt"), "shop.txt")
    schedule = plan.schedules[0]
    assert schedule.makespan_s == 9
    assert set(plan.brief.fleet.robots) == {"machine-0", "machine-1"}
    chain = chain_of(plan, schedule)
    assert [(step.robot, step.start_s, step.end_s, step.bond) for step in chain.steps] == [
        ("machine-1", 0, 3, "start"),
        ("machine-1", 3, 7, "robot"),
        ("machine-1", 7, 9, "robot"),
    ]
    title = ElementTree.fromstring(gantt_svg(plan, 1)).findtext("{http://www.w3.org/2000/svg}title")  # noqa: S314 - our own
    assert title == "shop.txt: schedule of alternative 1"
    assert "utility" not in gantt_svg(plan, 1)


def test_coalitions_travel_wait_and_get_to_the_end() -> None:
    """Robot 1: 5 s to task 1, 4 s there, 5 s to task 2, 2.5 s there, 10 s to the end; robot 0 goes home after task 1, 5 s."""
    plan = planned(coalitions_of(parse(json.dumps(GOOD), "mission.json")))
    schedule = plan.schedules[0]
    legs = [(leg.robot, leg.start_s, leg.end_s, leg.distance_m) for leg in schedule.legs]
    assert legs == [
        ("robot-0", 0, 5, 5.0),
        ("robot-1", 0, 5, 5.0),
        ("robot-1", 9, 14, 5.0),
        ("robot-0", 9, 14, 5.0),
        ("robot-1", 16.5, 26.5, 10.0),
    ]
    chain = chain_of(plan, schedule)
    assert (chain.work_s, chain.travel_s, chain.waiting_s) == (6.5, 20.0, 0.0)
    assert {step.robot for step in chain.steps} == {"robot-1"}


@pytest.mark.parametrize("seed", range(40))
def test_the_chain_of_any_instance_adds_up_to_its_makespan(seed: int) -> None:
    for instance in (coalitions.drawn(seed), small_trees.drawn(seed)):
        schedule = schedule_instance(instance, Control(time_limit_s=5), solver=False)
        if schedule.makespan_s:
            adds_up(plan_of_instance(instance, schedule, "an instance"))


def test_where_nothing_is_scheduled_there_is_no_plan() -> None:
    shop = shop_of(SHOP, str(Path("shop.txt")))
    none = TreeSchedule("infeasible", Certificate(claim="proven", method="selection"), {}, {}, {}, 0)
    with pytest.raises(ValueError, match="nothing to show"):
        plan_of_instance(shop, none, "shop")
    with pytest.raises(ValueError, match="nothing to show"):
        plan_of_instance(shop, replace(none, status="unknown"), "shop")
