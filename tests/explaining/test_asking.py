"""Questions about a plan: answers by hand, against all alternatives written out, and names as people type them."""

from __future__ import annotations

from functools import cache

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from missiontree.allocation.exhaustive import Exhaustive
from missiontree.allocation.flat import flatten
from missiontree.authoring.author import authored_from_tree
from missiontree.briefing import Request
from missiontree.checking import check
from missiontree.errors import InputError
from missiontree.explaining.asking import why_not, why_not_by, without
from missiontree.explaining.pinned import without_nodes
from missiontree.mission.alternative import selected_leaves
from missiontree.mission.brief import MissionBrief
from missiontree.mission.control import Control
from missiontree.mission.fleet import RobotType
from missiontree.mission.plan import Plan
from missiontree.mission.tree import MissionTree
from missiontree.planner import plan_authored
from missiontree.scheduling import SCHEDULERS
from tests.builders import brief_of, rescue_tree
from tests.checking.missions import random_mission, ruled_mission


def planned(tree: MissionTree, brief: MissionBrief) -> Plan:
    return plan_authored(Request(brief=brief), authored_from_tree(tree, brief), Control())


@cache
def rescue() -> Plan:
    return planned(rescue_tree(), brief_of(rescue_tree()))


def test_a_robot_that_does_it_less_well_costs_the_difference_in_quality() -> None:
    """A search is three actions: 3 × 1.0 by the Tele-Robot, 3 × 0.3 by the Transportation Robot; 2.1 less."""
    answer = why_not(rescue(), "Transportation Robot for Search(cat)")
    assert (answer.verdict, answer.claim) == ("worse", "proven")
    assert (answer.utility, answer.asked_utility) == (8.6, 6.5)
    assert "Quality of search: Transportation Robot 0.3, Tele-Robot 1." in answer.words
    assert [(one.node, one.before, one.after, one.utility_change) for one in answer.moved] == [
        ("cat", "Tele-Robot", "Transportation Robot", -2.1)
    ]
    assert answer.plan is not None
    assert check(answer.plan) == ()
    assert answer.plan.ranking is not None
    assert answer.plan.ranking.status == "partial"  # the best of those asked for, and not of all


@pytest.mark.parametrize(
    "question",
    [
        "transportation_robot for cat",
        "Why not use the transportation robot for the Search(cat)?",
        "SearchTree(cat) by Transportation-Robot",
        "transportation for search(CAT)",
        "transportation_robot-1 on Search(cat)",
        "Why is the transportation robot not doing Search(cat)?",
    ],
)
def test_questions_are_understood_as_people_type_them(question: str) -> None:
    assert why_not(rescue(), question).moved == why_not_by(rescue(), "transportation_robot", "cat").moved


def test_a_part_may_be_named_by_what_it_is_about_or_by_who_does_it() -> None:
    assert why_not(rescue(), "transportation_robot for the firefighter").moved[0].node == "firefighter"
    assert why_not(rescue(), "social_robot instead of transportation_robot").question == (
        "Why not Social Robot for ReachAndTransport(cat, safe_area)?"
    )


def test_what_tasks_lose_adds_up_to_what_the_alternative_loses() -> None:
    answer = why_not(planned(rescue_tree(), brief_of(rescue_tree(), check_kinds=False)), "7")
    assert answer.asked_utility is not None
    assert answer.utility is not None
    assert answer.asked_utility - answer.utility == pytest.approx(sum(one.utility_change for one in answer.moved))


def test_what_a_rule_forbids_is_told_with_the_rule_for_each_way() -> None:
    answer = why_not(rescue(), "social_robot for bring")
    assert (answer.verdict, answer.claim, answer.plan) == ("refused", "proven", None)
    assert {(reason.rule, reason.robot) for reason in answer.reasons} == {
        ("capability_missing", "social_robot"),
        ("kind_refused", ""),
    }


def test_a_robot_that_does_it_already_is_named() -> None:
    answer = why_not(rescue(), "tele_robot for Search(cat)")
    assert answer.verdict == "same"
    assert "Tele-Robot does Search(cat) in alternative 1 already" in answer.words[0]


def test_rules_for_the_whole_mission_can_forbid_what_a_robot_is_able_to_do() -> None:
    """Both searchers are required, and there are two searches: neither is left for anybody else."""
    tree = rescue_tree()
    plan = planned(tree, brief_of(tree, require=("tele_robot-1", "tele_robot-2")))
    answer = why_not(plan, "transportation_robot for Search(firefighter)")
    assert (answer.verdict, answer.claim, answer.asked_utility) == ("impossible", "proven", None)
    assert answer.words == (
        "Transportation Robot is able to do Search(firefighter), and no plan with that keeps all limits and times; proven.",
    )


def test_an_alternative_is_told_by_what_it_loses_task_by_task() -> None:
    answer = why_not(rescue(), "alternative 4")
    assert (answer.verdict, answer.utility, answer.asked_utility) == ("worse", 8.6, 4.4)
    assert [one.utility_change for one in answer.moved] == [-2.1, -2.1]
    assert answer.asked_makespan_s is not None
    assert answer.makespan_s is not None
    assert answer.asked_makespan_s - answer.makespan_s == 67  # one robot does both searches


def test_equal_alternatives_differ_by_the_order_of_choices_alone() -> None:
    assert (
        why_not(planned(rescue_tree(), brief_of(rescue_tree(), check_kinds=False)), "2")
        .words[1]
        .startswith("Both are worth")
    )


def test_there_are_no_more_alternatives_than_there_are() -> None:
    with pytest.raises(InputError) as refusal:
        why_not(rescue(), "9")
    assert refusal.value.accepted == "1 to 4: there are 4 alternatives"


def test_without_one_of_two_equal_robots_the_other_does_both() -> None:
    answer = without(rescue(), ["tele_robot-1"])
    assert (answer.verdict, answer.asked_utility) == ("as_good", 8.6)
    assert [(one.before, one.after) for one in answer.moved] == [("tele_robot-1", "tele_robot-2")]
    assert answer.plan is not None
    assert answer.plan.brief.without == ("tele_robot-1",)


def test_without_the_only_robot_that_can_what_is_left_is_told() -> None:
    answer = without(rescue(), ["transportation robot"])
    assert (answer.verdict, answer.claim, answer.asked_utility) == ("part_only", "proven", 6.0)
    assert "2 of 3 routines can be done. Proven: no larger part can." in answer.words
    assert answer.plan is not None
    assert answer.plan.outcome == "partial"


def test_without_a_robot_that_is_required_the_mission_cannot_be_stated() -> None:
    tree = rescue_tree()
    answer = without(planned(tree, brief_of(tree, require=("tele_robot",))), ["tele_robot"])
    assert (answer.verdict, answer.reasons[0].rule) == ("refused", "without_refused")


@pytest.mark.parametrize(
    ("question", "accepted", "hint"),
    [
        ("teler_robot for cat", "robots are", "tele_robot"),
        ("tele_robot for Serch(cat)", "Search(cat)", "Search(cat)"),
        ("Search(cat)", "'TYPE for Search(cat)'", ""),
        ("", "Tele-Robot for Search(cat)", ""),
    ],
)
def test_what_is_not_understood_is_refused_with_what_is_meant(question: str, accepted: str, hint: str) -> None:
    with pytest.raises(InputError) as refusal:
        why_not(rescue(), question)
    assert accepted in refusal.value.accepted
    assert hint in refusal.value.hint


def test_a_plan_that_is_not_delivered_is_not_asked_about() -> None:
    tree = rescue_tree()
    with pytest.raises(InputError, match="its outcome is cannot be done"):
        why_not(planned(tree, brief_of(tree, without=("transportation_robot",))), "3")


def test_what_is_forbidden_keeps_all_numbers_of_the_tree() -> None:
    grounding = rescue().grounding
    assert grounding is not None
    tree = grounding.tree
    pruned = without_nodes(tree, tree.children[1][:1])
    assert pruned.nodes[: len(tree.nodes)] == tree.nodes
    assert [(node.parent, node.kind) for node in pruned.nodes[len(tree.nodes) :]] == [(tree.children[1][0], "xor")]


def with_types(plan: Plan, node: str, kind: RobotType) -> float | None:
    """The greatest utility of an alternative in which the type works at a node, and which the plan's scheduler can schedule."""
    assert plan.grounding is not None
    assert plan.tree is not None
    brief, tree = plan.brief, plan.grounding.tree
    flat = flatten(tree, brief.fleet, brief.weights, brief.terms)
    scene = brief.world.extended(plan.tree.entities)
    for alternative in Exhaustive()(flat, brief.fleet, brief.weights, 10_000, Control()).alternatives:
        leaves = [leaf for leaf in selected_leaves(tree, alternative.choices) if tree.nodes[leaf].source == node]
        if kind.id in {tree.action(leaf).robot_type for leaf in leaves}:
            made = SCHEDULERS["greedy"](tree, alternative, brief.fleet, scene, Control(), brief.terms)
            if made.status in {"optimal", "feasible"}:
                return alternative.utility
    return None


@settings(max_examples=8, deadline=None)
@given(st.integers(0, 2**20), st.booleans(), st.data())
def test_the_price_of_a_robot_is_that_of_the_best_alternative_with_it(
    seed: int, ruled: bool, data: st.DataObject
) -> None:
    """Differential: all alternatives written out."""
    tree, brief = (ruled_mission if ruled else random_mission)(seed)
    authored = authored_from_tree(tree, brief)
    if authored.status != "complete":
        return
    plan = plan_authored(Request(brief=brief), authored, Control())
    if plan.outcome != "delivered":
        return
    node = data.draw(st.sampled_from([one for one in tree.nodes if one.routine is not None]))
    kind = data.draw(st.sampled_from(brief.fleet.types))
    answer = why_not_by(plan, kind.id, node.id)
    best = with_types(plan, node.id, kind)
    if answer.verdict == "same":
        assert best == answer.utility
    elif answer.verdict != "undecided":
        assert answer.asked_utility == best


def test_where_the_objective_is_time_the_fastest_plan_that_is_as_asked_for_is_set_beside_the_chosen_one() -> None:
    """One robot for both searches ends 67 s later; that utility falls, too, does not make the verdict."""
    tree = rescue_tree()
    plan = planned(tree, brief_of(tree, objective="makespan", without=("tele_robot-2",)))
    answer = why_not(plan, "transportation_robot for Search(cat)")
    assert answer.plan is not None
    assert answer.plan.chosen is not None
    assert answer.plan.chosen.option.certificate.claim == "unproven"  # the fastest of those asked for, and not of all
    assert check(answer.plan) == ()
    assert why_not(plan, "1").words == ("Alternative 1 is what the objective chooses.",)


def test_a_part_of_a_mission_is_chosen_by_its_objective_as_well() -> None:
    tree = rescue_tree()
    answer = without(planned(tree, brief_of(tree, objective="makespan")), ["transportation_robot"])
    assert answer.plan is not None
    assert answer.plan.outcome == "partial"
    assert answer.plan.chosen is not None
    assert check(answer.plan) == ()
