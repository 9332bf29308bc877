"""A plan that points at what it does not hold is refused with the place, before anything tries to show it."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree import plan, plan_text
from missiontree.errors import InputError
from missiontree.mission.plan import Plan
from missiontree.samples.catalogue import sample_file


@pytest.fixture(scope="module")
def made() -> Plan:
    return plan(sample_file("reunite"))


@pytest.mark.parametrize("leaf", [0, 9999], ids=["a task", "past the end"])
def test_a_schedule_of_an_action_that_is_not_there(made: Plan, leaf: int) -> None:
    first, *others = made.schedules
    actions = (replace(first.actions[0], leaf=leaf), *first.actions[1:])
    damaged = replace(made, schedules=(replace(first, actions=actions), *others))
    with pytest.raises(InputError, match=rf"schedules\[0\]\.actions\[0\]\.leaf: node {leaf} .* is not an action"):
        plan_text(damaged)


def test_an_alternative_with_a_role_that_is_not_there(made: Plan) -> None:
    assert made.ranking is not None
    first, *others = made.ranking.alternatives
    roles = (*first.roles[:-1], replace(first.roles[-1], role=9999))
    ranking = replace(made.ranking, alternatives=(replace(first, roles=roles), *others))
    with pytest.raises(InputError, match=r"alternatives\[0\]\.roles\[1\]\.role: there is no role 9999"):
        plan_text(replace(made, ranking=ranking))


def test_schedules_without_a_grounding(made: Plan) -> None:
    with pytest.raises(InputError, match="no grounding"):
        plan_text(replace(made, grounding=None))
