"""A plan that points at what it does not hold is refused with the place, before anything tries to show it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest

from missiontree import plan, plan_text
from missiontree.errors import InputError
from missiontree.mission.alternative import Alternative
from missiontree.mission.entity import Entity
from missiontree.mission.plan import Plan
from missiontree.reporting.html.report import report_html
from missiontree.reporting.maps.motion import motion
from missiontree.reporting.maps.text import map_view
from missiontree.reporting.maps.view import map_svg
from missiontree.reporting.team.view import team_view
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


def with_first(made: Plan, **changes: object) -> Plan:
    """The plan with another first alternative."""
    assert made.ranking is not None
    first, *others = made.ranking.alternatives
    changed: Alternative = replace(first, **changes)  # type: ignore[arg-type]
    return replace(made, ranking=replace(made.ranking, alternatives=(changed, *others)))


def astray(made: Plan) -> Iterator[tuple[Plan, str]]:
    """Plans whose alternatives and schedules do not go with their tree, each with what is said of it."""
    assert made.ranking is not None
    assert made.grounding is not None
    first, schedule, roles = made.ranking.alternatives[0], made.schedules[0], len(made.grounding.tree.roles)
    choice, *rest = first.choices
    yield (
        with_first(made, choices=(replace(choice, xor=9999), *rest)),
        rf"choices: node {choice.child} is not below node 9999",
    )
    # the root below one of its own nodes: whoever follows it never comes to an end
    yield (
        with_first(made, choices=(replace(choice, child=0), *rest)),
        rf"choices: node 0 is not below node {choice.xor}",
    )
    yield with_first(made, choices=()), "choices: no child is chosen at node"
    yield with_first(made, rank=7), r"alternatives\[0\]\.rank: rank 7"
    yield with_first(made, roles=first.roles[:-1]), f"roles: nobody fills role {first.roles[-1].role}, which is reached"
    yield replace(made, schedules=(replace(schedule, rank=99),)), r"schedules\[0\]\.rank: rank 99"
    lost = replace(schedule, assignments=(replace(schedule.assignments[0], role=9999),))
    yield replace(made, schedules=(lost,)), rf"assignments\[0\]\.role: there is no role 9999(?s:.*)0 to {roles - 1}"


@pytest.mark.parametrize("number", range(7))
def test_whoever_follows_choices_refuses_those_that_lead_nowhere(made: Plan, number: int) -> None:
    damaged, said = list(astray(made))[number]
    for show in (team_view, report_html):
        with pytest.raises(InputError, match=said):
            show(damaged)


def test_somebody_who_stands_in_the_scene_and_again_in_the_tree_is_on_no_map() -> None:
    """The tree brings in a second red crate."""
    whole = plan(sample_file("site"))
    assert whole.tree is not None
    damaged = replace(whole, tree=replace(whole.tree, entities=(*whole.tree.entities, Entity(id="red_crate"))))
    for show in (map_svg, map_view, motion, lambda one, _: team_view(one), lambda one, _: report_html(one)):
        with pytest.raises(InputError, match="red_crate"):
            show(damaged, 1)
