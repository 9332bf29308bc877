"""What is used of limits, against what is allowed."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree.mission.fleet import Fleet, Robot
from missiontree.mission.limit_use import LimitUse as Promised
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.reporting.team.limits import LimitUse, limits_of
from tests.reporting.map_plans import Doing, by_hand, place, walker

A, B = Position(0, 0), Position(30, 0)
SCENE = Scene(places=(place("a", 0, 0), place("b", 30, 0)))
ENERGY = {"energy_j": 1000.0, "payload_kg": 5.0}
THERE = Doing("walker-1", 0, 30, "b", moves=True, leg=(0, 30, A, B, 30))
BACK = Doing("walker-1", 30, 60, "a", moves=True, leg=(30, 60, B, A, 30))


def made(fleet: Fleet, uses: float = 0.0) -> Plan:
    """Out 30 m and back 30 m, every action using as much."""
    plan = by_hand(SCENE, fleet, (THERE, BACK))
    assert plan.grounding is not None
    tree = plan.grounding.tree
    nodes = tuple(
        node if node.action is None else replace(node, action=replace(node.action, uses={"energy_j": uses}))
        for node in tree.nodes
    )
    return replace(plan, grounding=replace(plan.grounding, tree=replace(tree, nodes=nodes)))


def told(plan: Plan, *, scheduled: bool = True) -> tuple[LimitUse, ...]:
    assert plan.ranking is not None
    return limits_of(plan, plan.ranking.alternatives[0], plan.schedules[0] if scheduled else None)


def fleet(**others: object) -> Fleet:
    kind = walker(2, place="a")
    return Fleet((replace(kind, limits=ENERGY, uses_per_m={"energy_j": 2.0}, **others),))  # type: ignore[arg-type]


def test_a_schedule_uses_what_is_done_and_every_metre() -> None:
    """Two actions of 50 J and 60 m of 2 J: 220 of 1000. Nothing uses payload, and the second robot rests."""
    assert told(made(fleet(), 50)) == (LimitUse("walker-1", "energy_j", 220, 1000, at_least=False),)
    assert told(made(fleet(), 50))[0].share == pytest.approx(0.22)


def test_what_is_left_of_a_robot_is_what_it_may_use() -> None:
    robots = (Robot(id="walker-1", place="a", remaining={"energy_j": 240}),)
    kind = replace(walker(place=None), count=None, robots=robots, limits=ENERGY, uses_per_m={"energy_j": 2.0})
    assert told(made(Fleet((kind,)), 50)) == (LimitUse("walker-1", "energy_j", 220, 240, at_least=False),)


def test_limits_of_all_robots_of_a_type_are_told_together() -> None:
    limits = told(made(fleet(total_limits={"energy_j": 400.0}), 50))
    assert limits[-1] == LimitUse("all of Walker", "energy_j", 220, 400, at_least=False)


def test_limits_of_the_whole_mission_are_told_last() -> None:
    """220 J of 900 for the fleet, and of 800 in the scene."""
    plan = made(replace(fleet(), total_limits={"energy_j": 900.0}), 50)
    scene = replace(SCENE, stock={"energy_j": 800.0, "kits": 3.0})
    limits = told(replace(plan, brief=replace(plan.brief, scene=scene)))
    assert limits[1:] == (
        LimitUse("the whole mission", "energy_j", 220, 900, at_least=False),
        LimitUse("stock of the scene", "energy_j", 220, 800, at_least=False),
    )


def test_without_a_schedule_the_least_that_allocation_knows_is_told() -> None:
    """How far it travels is not known."""
    plan = made(fleet(), 50)
    assert plan.ranking is not None
    known = (
        Promised("robot", "walker-2", "energy_j", 100, 1000),
        Promised("robots", "walker", "energy_j", 100, 2000),
        Promised("type", "walker", "energy_j", 100, 400),
        Promised("mission", "", "energy_j", 100, 900),
        Promised("stock", "", "energy_j", 100, 800),
        Promised("stock", "", "kits", 0, 3),
    )
    told = limits_of(plan, replace(plan.ranking.alternatives[0], uses=known), None)
    assert [(one.who, one.allowed, one.at_least) for one in told] == [
        ("walker-2", 1000, True),
        ("all of Walker", 2000, True),
        ("all of Walker", 400, True),
        ("the whole mission", 900, True),
        ("stock of the scene", 800, True),
    ]


def test_something_of_nothing_is_all_of_it() -> None:
    assert LimitUse("x", "energy_j", 1, 0, at_least=False).share == 1
    assert LimitUse("x", "energy_j", 0, 0, at_least=False).share == 0
