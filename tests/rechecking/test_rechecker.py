"""The second checker: no sound plan is refused, every damage is, and it needs no help from the first."""

from __future__ import annotations

import random
from dataclasses import replace
from itertools import islice

import pytest
from hypothesis import given
from hypothesis import strategies as st

from benchmarks.campaign import made
from benchmarks.damaged_plans import CAMPAIGN, breaks
from benchmarks.plan_damages import WAYS, Way, with_its_digests
from missiontree.checking import check, checker
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.rechecking import CORE_RULES, recheck
from tests.builders import brief_of, flat_tree, routine_node
from tests.checking.damages import DAMAGES, with_brief, with_kind, with_leg, with_schedule
from tests.checking.plans import PLANS, looking
from tests.checking.plans import made as plan_made

MOST_PLACES = 3


def spread(way: Way, plan: Plan) -> list[Plan]:
    """The plan damaged at up to three places, spread over the first sixty that there are."""
    found = list(islice(way.damage(plan), 60))
    return found[:: -(-len(found) // MOST_PLACES)] if found else []


@pytest.mark.parametrize("name", PLANS)
def test_sound_plans_are_passed_by_the_second_checker(name: str) -> None:
    assert recheck(PLANS[name]()) == []


@pytest.mark.parametrize("way", WAYS, ids=[way.name for way in WAYS])
def test_each_damage_is_refused_by_both_checkers(way: Way) -> None:
    """Wherever it is done; the rule that is broken is named by each at one place at least, where no other hides it."""
    first, second, places = set(), set(), 0
    for plan in PLANS.values():
        for damaged in map(with_its_digests, spread(way, plan())):
            places += 1
            told, told_again = breaks(damaged), {one.rule for one in recheck(damaged)}
            assert told
            assert told_again
            first |= told
            second |= told_again
    assert places > 0, "no plan has a place for this damage"
    assert way.rule in first
    assert way.core_rule in second


def test_every_core_rule_is_broken_by_some_damage_and_no_other_is_told() -> None:
    assert {way.core_rule for way in WAYS} == set(CORE_RULES)


def test_the_campaign_of_damage_finds_nothing_that_passes() -> None:
    """Each way once; the full campaign has a thousand of each."""
    seen = made(CAMPAIGN, 7, 0, len(WAYS))
    assert seen.violations == {}
    assert {row: counts["damaged plans"] for row, counts in seen.rows.items()} == {way.name: 1 for way in WAYS}


def test_the_last_word_is_the_second_checkers_where_the_first_is_silent(monkeypatch: pytest.MonkeyPatch) -> None:
    """With all rules of the first taken away, a plan whose makespan is half a second short is refused all the same."""
    plan = PLANS["reunite"]()
    monkeypatch.setattr(checker, "RULES", ())
    assert check(plan) == ()
    damaged = next(way for way in WAYS if way.name == "makespan changed").damage(plan)
    assert "core_makespan" in {one.rule for one in check(next(damaged))}


def test_a_visit_to_a_charger_that_is_listed_twice_is_two_at_one_time() -> None:
    """Even where the charger has room for two, and the robot for twice as much."""
    plan = PLANS["upstairs"]()
    scene = plan.brief.scene
    assert scene is not None
    roomy = with_brief(plan, scene=replace(scene, chargers=tuple(replace(one, capacity=2) for one in scene.chargers)))
    large = with_kind(roomy, "rover", limits={"max_speed_mps": 1.0, "energy_j": 1000.0})
    assert recheck(large) == []
    twice = with_schedule(large, 0, recharges=large.schedules[0].recharges * 2)
    assert "core_refill" in {one.rule for one in recheck(twice)}


def test_a_way_ends_after_it_starts_whatever_the_speed() -> None:
    """A robot of no known speed looks at a pump from 10 s on: the way to it takes no time that is known, and not less."""
    eye = RobotType(id="eye", count=1, capabilities={"look": 1.0}, position=Position(0, 0))
    scene = Scene(entities=(Entity(id="pump", position=Position(20, 0)),))
    tree = flat_tree(replace(routine_node("see", "Look", agent="pump"), release_s=10.0))
    plan = plan_made(tree, brief_of(tree, Fleet((eye,)), looking(0.0), scene=scene))
    assert recheck(plan) == []
    assert {one.rule for one in recheck(with_leg(plan, 0, 0, start_s=5.0, end_s=4.0))} == {"core_travel"}


@given(st.sampled_from(sorted(PLANS)), st.integers(0, 2**32), st.integers(1, 4))
def test_several_damages_at_once_are_findings_never_exceptions(name: str, seed: int, count: int) -> None:
    """Damage of any kind, also such as only the first checker minds: the second answers, and raises nothing."""
    rng = random.Random(seed)  # noqa: S311 - variation, not secrecy
    plan = PLANS[name]()
    for _ in range(count):
        _, damage = rng.choice(DAMAGES)
        try:
            damaged = list(islice(damage(plan), 30))
        except (ValueError, KeyError, IndexError, AssertionError):
            continue  # the plan is too broken by now for this damage to be done to it
        plan = rng.choice(damaged) if damaged else plan
    assert {one.rule for one in recheck(plan)} <= set(CORE_RULES)
