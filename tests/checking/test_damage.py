"""Damage done to sound plans, kind by kind and place by place: all of it is caught, and the expected rule names it."""

from __future__ import annotations

import random
from itertools import islice

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from missiontree.checking import RULES, check
from missiontree.mission.plan import Plan
from tests.checking.damages import DAMAGES, Damage
from tests.checking.plans import PLANS

MOST_PLACES = 5


def spread(damage: Damage, plan: Plan) -> list[Plan]:
    """The plan damaged at up to five places, spread over the first hundred that there are."""
    found = list(islice(damage(plan), 100))
    return found[:: -(-len(found) // MOST_PLACES)] if found else []


def codes(findings: object) -> set[str]:
    assert isinstance(findings, tuple)
    return {finding.rule for finding in findings}


@pytest.mark.parametrize("name", PLANS)
def test_sound_plans_have_no_findings(name: str) -> None:
    """The base of everything below: what missiontree plans, the checker passes."""
    assert check(PLANS[name]()) == ()


@pytest.mark.parametrize(("rule", "damage"), DAMAGES, ids=[damage.__name__ for _, damage in DAMAGES])
def test_damage_is_caught_and_named(rule: str, damage: Damage) -> None:
    """Every kind of damage, at up to five places of every plan that has such places."""
    places = 0
    for name, plan in PLANS.items():
        for place, damaged in enumerate(spread(damage, plan())):
            places += 1
            assert rule in codes(check(damaged)), (
                f"{damage.__name__} at place {place} of plan {name}: {codes(check(damaged))}"
            )
    assert places > 0, "no plan has a place for this damage"


def test_every_rule_is_broken_by_some_damage() -> None:
    """No rule is listed that nothing can break."""
    assert {rule.__name__ for rule in RULES} == {rule for rule, _ in DAMAGES}


@settings(max_examples=80, deadline=None)
@given(st.sampled_from(sorted(PLANS)), st.integers(0, 2**32), st.integers(1, 4))
def test_several_damages_at_once_are_findings_never_exceptions(name: str, seed: int, count: int) -> None:
    """Whatever is done, and however often, the checker answers with findings."""
    rng = random.Random(seed)  # noqa: S311 - variation, not secrecy
    plan, done = PLANS[name](), 0
    for _ in range(count):
        _, damage = rng.choice(DAMAGES)
        try:
            damaged = list(islice(damage(plan), 30))
        except (ValueError, KeyError, IndexError, AssertionError):
            continue  # the plan is too broken by now for this damage to be done to it
        if damaged:
            plan, done = rng.choice(damaged), done + 1
    if done:
        assert check(plan)
