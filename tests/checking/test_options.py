"""The options of fronts, and what is chosen, are held to what alternatives and schedules are held to."""

from __future__ import annotations

from dataclasses import replace

from missiontree.checking import check, taken_on_trust
from missiontree.mission.entity import Entity
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.schedule import ScheduledAction
from missiontree.rechecking import recheck
from tests.builders import brief_of, flat_tree, routine_node
from tests.checking.damages import with_chosen, with_options
from tests.checking.plans import PLANS, made, supplies


def hurried(actions: tuple[ScheduledAction, ...]) -> tuple[ScheduledAction, ...]:
    """The first action that takes time takes a second less."""
    long = next(place for place, done in enumerate(actions) if done.end_s - done.start_s > 1)
    one = replace(actions[long], end_s=actions[long].end_s - 1)
    return (*actions[:long], one, *actions[long + 1 :])


def test_a_hurried_action_in_an_option_is_found_by_both_checkers() -> None:
    plan = PLANS["trade"]()
    assert plan.front is not None
    last = plan.front.options[-1]
    hasty = replace(last, schedule=replace(last.schedule, actions=hurried(last.schedule.actions)))
    damaged = with_options(plan, [*plan.front.options[:-1], hasty])
    assert {(one.rule, one.message.partition(",")[0]) for one in check(damaged)} >= {("duration_wrong", "On the front")}
    assert "core_duration" in {one.rule for one in recheck(damaged)}


def test_a_hurried_action_in_the_choice_is_found_by_both_checkers() -> None:
    plan = PLANS["weighed"]()
    assert plan.chosen is not None
    schedule = plan.chosen.option.schedule
    damaged = with_chosen(plan, schedule=replace(schedule, actions=hurried(schedule.actions)))
    worth = replace(damaged, chosen=replace(damaged.chosen, worth=damaged.chosen.worth + 0.01))  # type: ignore[type-var, union-attr]
    assert {one.rule for one in check(worth)} >= {"duration_wrong"}
    assert "core_duration" in {one.rule for one in recheck(worth)}


def test_a_role_of_an_option_that_nobody_fills_is_found() -> None:
    plan = PLANS["trade"]()
    assert plan.front is not None
    first = plan.front.options[0]
    empty = replace(first, schedule=replace(first.schedule, assignments=first.schedule.assignments[1:]))
    assert "assignment_missing" in {one.rule for one in check(with_options(plan, [empty, *plan.front.options[1:]]))}


def trusted(plan: Plan) -> set[str]:
    return {one.rule for one in taken_on_trust(plan)}


def test_what_the_checker_sees_for_itself_is_not_taken_on_trust() -> None:
    """
    Of the four ways to send mule and runner three are shown.

    The fourth, the mule for the blankets, takes 5 s to ask, 20 s to load and 120.4 s to go at least: more than the 132.6 s of the fastest
    plan, and than the 145 s of the plan of the same utility.
    """
    assert trusted(PLANS["trade"]()) & {"choice_on_trust", "front_on_trust"} == set()


def test_what_it_does_not_see_is_told() -> None:
    """With a third errand, somebody goes twice in every plan, and the checker's quick bound does not know that robots are scarce."""
    tree, fleet, scene = supplies()
    tent = Entity(id="tent", kind="object", mass_kg=2.0, position=Position(60.0, 20.0))
    third = routine_node("third", "ReachAndTransport", agent="tent", location="clinic")
    larger = flat_tree(*tree.nodes[1:], third)
    world = replace(scene, entities=(*scene.entities, tent))
    brief = brief_of(larger, fleet, scene=world, objective="makespan")
    plan = made(larger, brief, k=1, scheduler="auto", front=True)
    assert check(plan) == ()
    assert trusted(plan) >= {"choice_on_trust", "front_on_trust", "bound_on_trust"}
    assert "choice_on_trust" in trusted(PLANS["weighed"]())


def test_another_objective_than_the_plans_own_is_told() -> None:
    """By utility and then makespan the mule alone would have been chosen."""
    plan = PLANS["trade"]()
    other = replace(plan, brief=replace(plan.brief, objective="utility-makespan"))
    assert "chosen_beaten" in {one.rule for one in check(other)}
    assert "core_best" in {one.rule for one in recheck(other)}
