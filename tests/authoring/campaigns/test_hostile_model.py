"""A sample of the campaign of hostile models, and whether its audit would see a plan that breaks a rule."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from typing import Any

import pytest

from benchmarks.campaign import luck, made
from benchmarks.campaign_audit import plan_breaches, tree_breaches
from benchmarks.campaign_history import asked_of
from benchmarks.campaign_missions import random_mission
from benchmarks.campaign_player import HostileModel
from benchmarks.hostile_model import CAMPAIGN
from missiontree.authoring.author import author_tree
from missiontree.briefing import Request
from missiontree.llm.scripted import ScriptedModel, Turn
from missiontree.mission.area import Zone
from missiontree.mission.brief import MissionBrief
from missiontree.mission.control import Control
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.plan import Plan
from missiontree.mission.scene import Scene
from missiontree.mission.tree import Link, MissionNode
from missiontree.planner import plan_authored
from missiontree.routines.library import built_in
from tests.builders import brief_of, flat_tree, people, routine_node

SAMPLE = 500


def test_a_sample_shows_nothing_that_must_never_be() -> None:
    state = made(CAMPAIGN, 1, 0, SAMPLE)
    assert state.violations == {}
    total = sum((Counter(row) for row in state.rows.values()), Counter())
    assert total["runs"] == SAMPLE
    assert total["plan delivered"] > SAMPLE / 5, "the players are to get somewhere, or nothing is shown"
    assert total["calls"] > total["calls accepted"] > total["calls"] / 4
    assert all(total[end] for end in ("complete", "cannot_be_done", "incomplete", "exhausted", "provider_failed"))


def test_what_the_full_campaign_once_found_stays_mended() -> None:
    """In run 548 a box was carried by two robots to itself, and the checker refused the plan."""
    verdict = CAMPAIGN.judge(1, 548)
    assert (verdict.counts["complete"], verdict.violations) == (1, ())


def test_the_players_call_every_function_and_some_that_are_none() -> None:
    called: Counter[str] = Counter()
    for number in range(120):
        rng = luck(3, number)
        brief = random_mission(rng)
        called.update(call.name for call in asked_of(author_tree(brief, HostileModel(rng, brief)).transcript))
    assert len(called) > 13
    assert called["approve"] + called["addRobot"] + called["runPlan"]


TEXT = "Find ann, then bring the box to the gate"


@pytest.fixture(scope="module")
def plan() -> Plan:
    """Search(ann), then Transport(box, gate), by a team of two types."""
    scene = Scene(places=(Entity(id="gate", kind="place"),), entities=(*people("ann"), Entity(id="box", mass_kg=5)))
    fleet = Fleet(
        (
            RobotType(id="scout", capabilities={"search": 1.0}, count=1),
            RobotType(id="hauler", capabilities={"carry": 1.0, "search": 0.2}, limits={"payload_kg": 9.0}, count=1),
        )
    )
    brief = MissionBrief(text=TEXT, fleet=fleet, routines=built_in(), scene=scene)
    trees: dict[str, Any] = {
        "parentString": TEXT,
        "treeNames": ["SearchTree", "TransportTree"],
        "treeArguments": [["ann"], ["box", "gate"]],
        "LogicalConstraint": "AND",
        "constraintPairs": [[0, 1]],
    }
    script: list[Turn] = [[("HierarchicalTree_init", {"objective": TEXT}), ("attachMultiSubTrees", trees)]]
    return plan_authored(Request(brief=brief, k=1), author_tree(brief, ScriptedModel(script)), Control())


def test_a_sound_plan_has_no_breach(plan: Plan) -> None:
    assert (plan.outcome, list(plan_breaches(plan))) == ("delivered", [])


def with_type(plan: Plan, **changes: object) -> Plan:
    """The plan with the hauler as it is not."""
    scout, hauler = plan.brief.fleet.types
    return replace(plan, brief=replace(plan.brief, fleet=Fleet((scout, replace(hauler, **changes)))))  # type: ignore[arg-type]


def test_what_a_robot_may_not_do_is_seen(plan: Plan) -> None:
    assert plan.tree is not None
    heavy = with_type(plan, limits={"payload_kg": 4.0})  # the box has 5 kg
    assert any("limits" in breach for breach in plan_breaches(heavy))
    assert any("by carry" in breach for breach in plan_breaches(with_type(plan, capabilities={"search": 0.2})))
    renamed = replace(plan.brief, fleet=Fleet((plan.brief.fleet.types[0],)))
    assert any("hauler-1 does" in breach for breach in plan_breaches(replace(plan, brief=renamed)))
    root, search, transport = plan.tree.nodes
    scouts = replace(plan.tree, nodes=(root, search, replace(transport, resources=("scout",))))
    assert any("is for ('scout',)" in breach for breach in plan_breaches(replace(plan, tree=scouts)))
    scene = plan.brief.scene
    assert scene is not None
    away = replace(
        scene, zones=(Zone(id="yard"), Zone(id="hall")), entities=(*people("ann"), Entity(id="box", zone="hall"))
    )
    scout, hauler = plan.brief.fleet.types
    zoned = replace(plan.brief, scene=away, fleet=Fleet((scout, replace(hauler, zones=("yard",)))))
    shut = replace(plan, brief=zoned)
    assert any("in zone hall" in breach for breach in plan_breaches(shut))


def test_two_things_at_once_and_a_broken_order_are_seen(plan: Plan) -> None:
    assert plan.tree is not None
    (schedule,) = plan.schedules
    at_once = replace(
        schedule,
        actions=tuple(replace(done, robot="hauler-1", start_s=0.0, end_s=5.0) for done in schedule.actions),
    )
    found = list(plan_breaches(replace(plan, schedules=(at_once,))))
    assert any("at once" in breach for breach in found)
    assert any("precedence" in breach for breach in found)
    _, search, transport = plan.tree.nodes
    same = replace(plan.tree, links=(Link(search.id, transport.id, "same_robot"),))
    assert any("same_robot" in breach for breach in plan_breaches(replace(plan, tree=same)))


def test_strangers_in_a_tree_are_seen() -> None:
    brief = brief_of("Find ann", scene=Scene(entities=people("ann")))
    sound = flat_tree(routine_node("s", "Search", agent="ann"))
    assert list(tree_breaches(sound, brief, ())) == []
    for wrong in (
        flat_tree(routine_node("s", "Fly", agent="ann")),
        flat_tree(routine_node("s", "Search", agent="bob")),
        flat_tree(routine_node("s", "Search", agent="bob"), entities=people("bob")),  # nobody introduced bob
        flat_tree(routine_node("s", "Search", agent="ann", resources=("drone",))),
        flat_tree(routine_node("s", "Search", whom="ann")),
        flat_tree(MissionNode(id="open", label="Open")),
    ):
        assert list(tree_breaches(wrong, brief, ())), wrong
