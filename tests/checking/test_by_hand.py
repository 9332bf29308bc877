"""Small plans written by hand, sound but for one thing; the numbers of the findings are derived beside them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from missiontree.checking import check, taken_on_trust
from missiontree.checking.case import Case
from missiontree.checking.lower_bound import least_makespan
from missiontree.mission.alternative import Choice
from missiontree.mission.certificate import Certificate
from missiontree.mission.charger import Charger
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.limit_use import LimitUse
from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason
from missiontree.mission.schedule import Recharge, Schedule
from missiontree.mission.shared_resource import SharedResource
from missiontree.mission.tree import LinkKind
from tests.builders import and_, grounded, leaf, xor_
from tests.checking.by_hand import (
    FAR,
    HERE,
    PROVEN,
    SCENE,
    THERE,
    by_start,
    guessing,
    leg,
    only,
    plan_of,
    rules,
    team,
    times,
)

# Nodes are numbered in preorder: the AND is 0, its leaves 1, 2, ...
TWO = grounded(and_(leaf("a", duration_s=3), leaf("b", duration_s=4)))
ORDERED = grounded(and_(leaf("a", duration_s=3), leaf("b", duration_s=4)), [("a", "b")])


def test_work_in_parallel_by_two_robots_is_sound() -> None:
    assert check(plan_of(TWO, times((1, "r-1", 0, 3), (2, "r-2", 0, 4)))) == ()


def test_one_robot_does_one_thing_at_a_time() -> None:
    """b from 2 to 6 while a lasts until 3: an overlap of actions, and so of roles."""
    assert rules(plan_of(TWO, times((1, "r-1", 0, 3), (2, "r-1", 2, 6)))) == ["robot_overlap", "holding_broken"]


def test_one_tick_is_tolerated_two_are_not() -> None:
    """a ends at 3 s; b may start at 2.999 s."""
    assert check(plan_of(ORDERED, times((1, "r-1", 0, 3), (2, "r-2", 2.999, 6.999)))) == ()
    finding = only(plan_of(ORDERED, times((1, "r-1", 0, 3), (2, "r-2", 2.998, 6.998))))
    assert (finding.rule, finding.node, finding.found, finding.needed) == (
        "precedence_broken", "b [2]", "2.998 s", "at least 3 s",
    )  # fmt: skip


def test_precedence_reaches_all_leaves_below_a_node() -> None:
    """end(left) = max(3, 5) = 5, so c may start at 5 and not at 4."""
    tree = grounded(
        and_(and_(leaf("a", duration_s=3), leaf("b", duration_s=5), label="left"), leaf("c", duration_s=1)),
        [("left", "c")],
    )
    assert check(plan_of(tree, times((2, "r-1", 0, 3), (3, "r-2", 0, 5), (4, "r-1", 5, 6)))) == ()
    assert only(plan_of(tree, times((2, "r-1", 0, 3), (3, "r-2", 0, 5), (4, "r-1", 4, 5)))).needed == "at least 5 s"


def test_a_robot_is_held_between_the_actions_of_a_role() -> None:
    """Role x lasts from 0 to 9 with a pause from 3 to 8; role y from 4 to 8 is done in the pause."""
    tree = grounded(
        and_(leaf("a", role="x", duration_s=3), leaf("b", role="y", duration_s=4), leaf("c", role="x", duration_s=1))
    )
    assert only(plan_of(tree, times((1, "r-1", 0, 3), (2, "r-1", 4, 8), (3, "r-1", 8, 9)))).rule == "holding_broken"
    assert check(plan_of(tree, times((1, "r-1", 0, 3), (2, "r-2", 4, 8), (3, "r-1", 8, 9)))) == ()


def test_an_action_that_takes_no_time_is_no_excuse_within_a_role() -> None:
    """b takes 0 s at 5 s, strictly within role x."""
    tree = grounded(and_(leaf("a", role="x", duration_s=3), leaf("b", role="y"), leaf("c", role="x", duration_s=1)))
    assert only(plan_of(tree, times((1, "r-1", 0, 3), (2, "r-1", 5, 5), (3, "r-1", 8, 9)))).rule == "holding_broken"
    assert check(plan_of(tree, times((1, "r-1", 0, 3), (2, "r-1", 9, 9), (3, "r-1", 8, 9)))) == ()


def test_durations_are_rounded_up_to_milliseconds() -> None:
    """1.0004 s take 1.001 s; 1.001 - 1 tick is tolerated, 1.003 s is a tick too long."""
    tree = grounded(and_(leaf("a", duration_s=1.0004)))
    assert check(plan_of(tree, times((1, "r-1", 0, 1.001)))) == ()
    assert only(plan_of(tree, times((1, "r-1", 0, 1.003)))).rule == "duration_wrong"


def test_joint_actions_take_the_longest_of_their_durations() -> None:
    """max(3, 4) = 4 s for both."""
    tree = grounded(
        and_(leaf("a", role="x", duration_s=3, sync=0), leaf("b", role="y", duration_s=4, sync=0)),
        teams={"x": 0, "y": 0},
    )
    assert check(plan_of(tree, times((1, "r-1", 0, 4), (2, "r-2", 0, 4)))) == ()
    assert rules(plan_of(tree, times((1, "r-1", 0, 3), (2, "r-2", 0, 4)))) == ["duration_wrong", "joint_broken"]
    assert only(plan_of(tree, times((1, "r-1", 1, 5), (2, "r-2", 0, 4)))).rule == "joint_broken"


FOLLOW = grounded(and_(leaf("a", duration_s=3, open_ended=True), leaf("b", duration_s=4)), [("a", "b", "until")])


def test_an_open_end_lasts_until_the_other_node_ends() -> None:
    """a until b, b from 0 to 4: a ends at 4, whatever its own 3 s."""
    assert check(plan_of(FOLLOW, times((1, "r-1", 0, 4), (2, "r-2", 0, 4)))) == ()
    finding = only(plan_of(FOLLOW, times((1, "r-1", 0, 3), (2, "r-2", 0, 4))))
    assert (finding.rule, finding.found, finding.needed) == ("until_broken", "0 s to 3 s", "before 4 s, until 4 s")


def test_following_takes_a_tick_at_least() -> None:
    """b ends at 4: from 3.999 s a follows for one tick, from 4 s for none, from 6 s after it is all over."""
    assert check(plan_of(FOLLOW, times((1, "r-1", 3.999, 4), (2, "r-2", 0, 4)))) == ()
    assert only(plan_of(FOLLOW, times((1, "r-1", 4, 4), (2, "r-2", 0, 4)))).found == "4 s to 4 s"
    assert only(plan_of(FOLLOW, times((1, "r-1", 6, 6), (2, "r-2", 0, 4)))).found == "6 s to 6 s"


def test_following_several_lasts_until_the_last_of_them_ends() -> None:
    """b ends at 4 and c at 9, so a lasts until 9; it may start at 5, when b is over and c is not."""
    tree = grounded(
        and_(leaf("a", duration_s=3, open_ended=True), leaf("b", duration_s=4), leaf("c", duration_s=9)),
        [("a", "b", "until"), ("a", "c", "until")],
    )
    others = ((2, "r-2", 0.0, 4.0), (3, "r-3", 0.0, 9.0))
    assert check(plan_of(tree, times((1, "r-1", 5, 9), *others), fleet=team(3))) == ()
    assert only(plan_of(tree, times((1, "r-1", 0, 4), *others), fleet=team(3))).needed == "before 9 s, until 9 s"


AT = grounded(and_(leaf("a", at="there", duration_s=3)))


def test_an_approach_takes_distance_by_speed() -> None:
    """10 m at 2 m/s: 5 s."""
    assert check(plan_of(AT, times((1, "r-1", 5, 8)), leg(1, 0, 5, HERE, THERE, 10), scene=SCENE)) == ()
    finding = only(plan_of(AT, times((1, "r-1", 4, 7)), leg(1, 0, 4, HERE, THERE, 10), scene=SCENE))
    assert (finding.rule, finding.needed) == ("leg_too_fast", "at least 5 s")


def test_a_detour_takes_its_own_metres() -> None:
    """12 m at 2 m/s: 6 s, not the 5 s of the straight way."""
    assert check(plan_of(AT, times((1, "r-1", 6, 9)), leg(1, 0, 6, HERE, THERE, 12), scene=SCENE)) == ()
    assert (
        only(plan_of(AT, times((1, "r-1", 5, 8)), leg(1, 0, 5, HERE, THERE, 12), scene=SCENE)).needed == "at least 6 s"
    )


def test_metres_are_not_understated() -> None:
    finding = only(plan_of(AT, times((1, "r-1", 5, 8)), leg(1, 0, 5, HERE, THERE, 9.9), scene=SCENE))
    assert (finding.rule, finding.found, finding.needed) == ("leg_understated", "9.9 m", "at least 10 m")


def test_a_robot_does_not_jump() -> None:
    assert only(plan_of(AT, times((1, "r-1", 5, 8)), scene=SCENE)).rule == "leg_missing"


def test_a_robot_leaves_when_it_is_free() -> None:
    """a ends at 3; the way to b may not begin at 2."""
    tree = grounded(and_(leaf("a", duration_s=3), leaf("b", at="there", duration_s=1)))
    actions = times((1, "r-1", 0, 3), (2, "r-1", 8, 9))
    assert check(plan_of(tree, actions, leg(2, 3, 8, HERE, THERE, 10), scene=SCENE)) == ()
    assert only(plan_of(tree, actions, leg(2, 2, 8, HERE, THERE, 10), scene=SCENE)).rule == "leg_at_wrong_time"


# The box is brought from there to far: 20 m, at its own 1 m/s 20 s.
BRING = grounded(
    and_(
        leaf("grip", role="x", at="box", duration_s=1),
        leaf("bring", role="x", at="far", moves=True, brings=("box",)),
        leaf("use", role="y", at="box", duration_s=2),
    ),
    [("bring", "use")],
)
BROUGHT = times((1, "r-1", 5, 6), (2, "r-1", 6, 26), (3, "r-2", 26, 28))
TO_BOX, WITH_BOX = leg(1, 0, 5, HERE, THERE, 10), leg(2, 6, 26, THERE, FAR, 20)
# From (0, 0) to (10, 20): sqrt(500) = 22.3607 m, at 2 m/s 11.1804 s.
TO_FAR = leg(3, 0, 26, HERE, FAR, 22.361, "r-2")


def test_what_is_brought_caps_the_speed_and_is_at_the_new_place_afterwards() -> None:
    assert check(plan_of(BRING, BROUGHT, *by_start(TO_BOX, WITH_BOX, TO_FAR), scene=SCENE)) == ()
    light = replace(SCENE, entities=(replace(SCENE.entities[0], max_speed_mps=0.5),))
    # At 0.5 m/s the 20 m take 40 s.
    assert only(plan_of(BRING, BROUGHT, *by_start(TO_BOX, WITH_BOX, TO_FAR), scene=light)).needed == "at least 40 s"


def test_nobody_uses_a_moved_thing_where_it_was() -> None:
    stale = leg(3, 0, 26, HERE, THERE, 10, "r-2")
    finding = only(plan_of(BRING, BROUGHT, *by_start(TO_BOX, WITH_BOX, stale), scene=SCENE))
    assert (finding.rule, finding.robot) == ("leg_destination_wrong", "r-2")


def test_joint_actions_begin_before_either_has_moved_anything() -> None:
    """
    At 5 s r-1 looks at the box, and r-2, who is where the box is to be, brings it there: both in no time, and jointly.

    So r-1 looks where the box was, at 10 m, and is in the far corner after 20 m more, at 15 s.
    """
    tree = grounded(
        and_(
            leaf("look", role="x", at="box", sync=0, duration_s=0),
            leaf("bring", role="y", at="here", moves=True, brings=("box",), sync=0, duration_s=0),
            leaf("rest", role="x", at="far", duration_s=1),
        )
    )
    scene = replace(SCENE, places=(*SCENE.places, Entity(id="here", kind="place", position=HERE)))
    actions = times((1, "r-1", 5, 5), (2, "r-2", 5, 5), (3, "r-1", 15, 16))
    legs = (leg(1, 0, 5, HERE, THERE, 10), leg(2, 5, 5, HERE, HERE, 0, "r-2"), leg(3, 5, 15, THERE, FAR, 20))
    assert rules(plan_of(tree, actions, *by_start(*legs), scene=scene)) == []
    beside = (*legs[:2], leg(3, 5, 16.181, HERE, FAR, 22.361))
    late = times((1, "r-1", 5, 5), (2, "r-2", 5, 5), (3, "r-1", 16.181, 17.181))
    assert "leg_origin_wrong" in rules(plan_of(tree, late, *by_start(*beside), scene=scene))


def test_what_a_robot_moves_in_no_time_is_where_it_took_it_when_it_goes_on() -> None:
    """
    At 0 s r-1, who is where the box is to be, brings it there in no time, and is at it from then on: it is held in one role at a time.

    So it sets out for the far corner from there, sqrt(500) m at 2 m/s.
    """
    tree = grounded(
        and_(
            leaf("bring", role="x", at="here", moves=True, brings=("box",), duration_s=0),
            leaf("watch", role="y", at="box", duration_s=3),
            leaf("rest", role="z", at="far", duration_s=1),
        )
    )
    scene = replace(SCENE, places=(*SCENE.places, Entity(id="here", kind="place", position=HERE)))
    actions = times((1, "r-1", 0, 0), (2, "r-1", 0, 3), (3, "r-1", 14.181, 15.181))
    legs = (leg(1, 0, 0, HERE, HERE, 0), leg(3, 3, 14.181, HERE, FAR, 22.361))
    assert rules(plan_of(tree, actions, *by_start(*legs), scene=scene)) == []


def test_the_leg_of_a_move_has_the_time_of_the_move() -> None:
    early = replace(WITH_BOX, start_s=5.5)
    assert only(plan_of(BRING, BROUGHT, *by_start(TO_BOX, early, TO_FAR), scene=SCENE)).rule == "leg_at_wrong_time"


def test_a_robot_that_starts_nobody_knows_where_travels_in_no_time() -> None:
    """No leg to the first place, then one from there: 20 m at 2 m/s."""
    tree = grounded(and_(leaf("a", role="x", at="there", duration_s=3), leaf("b", role="x", at="far", duration_s=1)))
    fleet = team(position=None)
    actions = times((1, "r-1", 0, 3), (2, "r-1", 13, 14))
    way = leg(2, 3, 13, THERE, FAR, 20)
    assert check(guessing(plan_of(tree, actions, way, fleet=fleet, scene=SCENE), "r-1")) == ()
    assert only(guessing(plan_of(tree, actions, fleet=fleet, scene=SCENE), "r-1")).rule == "leg_missing"
    # Where r-1 starts is taken for granted, and that must be said, in the schedule and in the plan's own list.
    finding = only(plan_of(tree, actions, way, fleet=fleet, scene=SCENE))
    assert (finding.rule, finding.node, finding.robot) == ("assumption_missing", "a [1]", "r-1")
    said = guessing(plan_of(tree, actions, way, fleet=fleet, scene=SCENE), "r-1")
    assert only(replace(said, assumptions=())).rule == "note_dropped"


def test_a_robot_at_a_place_that_nobody_knows_is_nowhere_known_afterwards() -> None:
    """From there it gets to "far" in no time, and a move takes its nominal 60 s; no way from its old place is any good."""
    scene = replace(SCENE, entities=(*SCENE.entities, Entity(id="lost")))
    tree = grounded(
        and_(leaf("a", role="x", at="lost", duration_s=3), leaf("b", role="y", at="far", duration_s=1)), [("a", "b")]
    )
    actions = times((1, "r-1", 0, 3), (2, "r-1", 3, 4))
    assert check(guessing(plan_of(tree, actions, scene=scene), "r-1")) == ()
    assert only(plan_of(tree, actions, scene=scene)).rule == "assumption_missing"
    # From (0, 0) to (10, 20): 22.361 m, at 2 m/s 11.181 s.
    later = times((1, "r-1", 0, 3), (2, "r-1", 14.181, 15.181))
    way = leg(2, 3, 14.181, HERE, FAR, 22.361)
    assert only(guessing(plan_of(tree, later, way, scene=scene), "r-1")).rule == "leg_extra"
    tree = grounded(and_(leaf("a", role="x", at="lost"), leaf("go", role="x", at="far", moves=True, duration_s=60)))
    assert check(guessing(plan_of(tree, times((1, "r-1", 0, 0), (2, "r-1", 0, 60)), scene=scene), "r-1")) == ()
    short = times((1, "r-1", 0, 0), (2, "r-1", 0, 11.181))
    assert only(guessing(plan_of(tree, short, scene=scene), "r-1")).rule == "move_too_short"


def test_a_speed_that_nobody_knows_is_an_assumption_of_the_type() -> None:
    """10 m in no time."""
    fleet = team(limits={})
    plan = plan_of(AT, times((1, "r-1", 0, 3)), leg(1, 0, 0, HERE, THERE, 10), fleet=fleet, scene=SCENE)
    assert check(guessing(plan, "r")) == ()
    assert (only(plan).rule, only(plan).robot) == ("assumption_missing", "r")


def test_a_move_has_its_leg_even_if_it_leads_nowhere() -> None:
    """The robot is at "there" already: 0 m in 0 s."""
    tree = grounded(
        and_(leaf("a", role="x", at="there", duration_s=3), leaf("go", role="x", at="there", moves=True, duration_s=60))
    )
    actions, first = times((1, "r-1", 5, 8), (2, "r-1", 8, 8)), leg(1, 0, 5, HERE, THERE, 10)
    assert check(plan_of(tree, actions, first, leg(2, 8, 8, THERE, THERE, 0), scene=SCENE)) == ()
    assert (only(plan_of(tree, actions, first, scene=SCENE)).rule, only(plan_of(tree, actions, first, scene=SCENE)).node) == (
        "leg_missing", "go [2]",
    )  # fmt: skip


def test_a_move_to_nobody_knows_where_takes_its_nominal_duration() -> None:
    tree = grounded(and_(leaf("go", at="lost", moves=True, duration_s=60)))
    scene = replace(SCENE, entities=(*SCENE.entities, Entity(id="lost")))
    assert check(plan_of(tree, times((1, "r-1", 0, 60)), scene=scene)) == ()
    assert only(plan_of(tree, times((1, "r-1", 0, 59)), scene=scene)).rule == "move_too_short"


def test_budgets_are_charged_for_actions_and_metres() -> None:
    """7 for the action and 0.5 * 10 m: 12."""
    tree = grounded(and_(leaf("a", at="there", duration_s=3, uses={"energy_j": 7}, uses_at_least={})))
    actions, way = times((1, "r-1", 5, 8)), leg(1, 0, 5, HERE, THERE, 10)
    limits = {"max_speed_mps": 2.0, "energy_j": 12.0}
    common: dict[str, Any] = {"uses_per_m": {"energy_j": 0.5}}
    assert check(plan_of(tree, actions, way, fleet=team(limits=limits, **common), scene=SCENE)) == ()
    short = team(limits={**limits, "energy_j": 11.9}, **common)
    assert only(plan_of(tree, actions, way, fleet=short, scene=SCENE)).found == "energy_j 12"


def test_totals_are_charged_over_all_robots_of_a_type() -> None:
    """3 + 4 = 7."""
    tree = grounded(and_(leaf("a", uses={"paint_l": 3}), leaf("b", uses={"paint_l": 4})))
    actions = times((1, "r-1", 0, 0), (2, "r-2", 0, 0))
    said = (LimitUse("type", "r", "paint_l", 7.0, 7.0),)
    assert check(plan_of(tree, actions, fleet=team(total_limits={"paint_l": 7}), uses=said)) == ()
    # Even by what allocation knows, no robots fit into 6.
    said = (LimitUse("type", "r", "paint_l", 7.0, 6.0),)
    assert rules(plan_of(tree, actions, fleet=team(total_limits={"paint_l": 6}), uses=said)) == [
        "alternative_unstaffable", "claim_refuted", "total_budget_exceeded",
    ]  # fmt: skip


def test_what_is_used_of_limits_is_told_as_the_actions_give_it() -> None:
    """3 + 4 = 7 of 2 * 5 that two robots have, of 8 of the type, of 9 of the fleet; the stock of 9.5 is looser and not told."""
    tree = grounded(and_(leaf("a", uses={"paint_l": 3}), leaf("b", uses={"paint_l": 4})))
    actions = times((1, "r-1", 0, 0), (2, "r-2", 0, 0))
    fleet = replace(team(limits={"paint_l": 5}, total_limits={"paint_l": 8}), total_limits={"paint_l": 9.0})
    scene = replace(SCENE, stock={"paint_l": 9.5})
    said = (
        LimitUse("robots", "r", "paint_l", 7.0, 10.0),
        LimitUse("type", "r", "paint_l", 7.0, 8.0),
        LimitUse("mission", "", "paint_l", 7.0, 9.0),
    )
    assert check(plan_of(tree, actions, fleet=fleet, scene=scene, uses=said)) == ()
    for number, use in enumerate(said):
        without = (*said[:number], *said[number + 1 :])
        fault = only(plan_of(tree, actions, fleet=fleet, scene=scene, uses=without))
        assert (fault.rule, fault.robot, fault.needed) == ("limit_use_missing", use.who, f"paint_l 7 of {use.limit:g}")
    stock = LimitUse("stock", "", "paint_l", 7.0, 9.5)
    assert only(plan_of(tree, actions, fleet=fleet, scene=scene, uses=(*said, stock))).rule == "limit_use_wrong"


@pytest.mark.parametrize(("kind", "sound"), [("same_robot", "r-1"), ("different_robot", "r-2")])
def test_links_between_robots(kind: Any, sound: str) -> None:
    tree = grounded(and_(leaf("a", duration_s=3), leaf("b", duration_s=4)), [("a", "b", kind)])
    other = {"r-1": "r-2", "r-2": "r-1"}[sound]
    assert check(plan_of(tree, times((1, "r-1", 0, 3), (2, sound, 3, 7)))) == ()
    assert only(plan_of(tree, times((1, "r-1", 0, 3), (2, other, 3, 7)))).rule == f"{kind}_broken"


def test_a_team_needs_different_robots() -> None:
    tree = grounded(and_(leaf("a", role="x", duration_s=3), leaf("b", role="y", duration_s=4)), teams={"x": 3, "y": 3})
    assert only(plan_of(tree, times((1, "r-1", 0, 3), (2, "r-1", 3, 7)))).rule == "team_shares_robot"


def test_a_false_claim_of_being_best_is_refuted() -> None:
    """The XOR offers 1 and 2; the plan takes 1 and calls it the proven best."""
    tree = grounded(and_(leaf("a", duration_s=3)))
    choosing = grounded(and_(xor_(leaf("a", quality=1.0, duration_s=3), leaf("b", quality=2.0, duration_s=3))))
    plan = plan_of(tree, times((1, "r-1", 0, 3)))
    assert check(plan) == ()
    fleet = Fleet((RobotType(id="r", count=1, capabilities={"any": 1.0}, position=HERE),))
    assert len(choosing.nodes) == 4
    plan = plan_of(choosing, times((2, "r-1", 0, 3)), fleet=fleet)
    assert plan.ranking is not None
    chosen = replace(plan.ranking.alternatives[0], choices=(Choice(1, 2),), utility=1.0)
    plan = replace(plan, ranking=replace(plan.ranking, alternatives=(chosen,)))
    # b claims quality 2 where the fleet states 1; that is a finding of its own.
    assert rules(plan) == ["quality_differs", "claim_refuted"]


def test_nothing_overflows() -> None:
    """Times of 1e300 s and weights that make utilities infinite are findings."""
    plan = plan_of(TWO, times((1, "r-1", 0, 1e300), (2, "r-2", 0, 4)))
    assert "duration_wrong" in rules(plan)
    brief = replace(plan.brief, weights=replace(plan.brief.weights, alpha=1e308))
    assert "utility_wrong" in rules(replace(plan, brief=brief))


def claiming(plan: Plan, status: Any, claim: Any, method: str, bound: float | None) -> Plan:
    """The plan with another claim about its schedule."""
    certificate = Certificate(claim=claim, method=method, bound=bound)
    return replace(plan, schedules=(replace(plan.schedules[0], status=status, certificate=certificate),))


def test_optimal_is_believed_where_the_checker_comes_to_the_same_bound() -> None:
    """a (3 s) before b (4 s): 7 s are the least. With b put off by 1 s the schedule takes 8 s, and nothing shows that it must."""
    plan = plan_of(ORDERED, times((1, "r-1", 0, 3), (2, "r-2", 3, 7)))
    best = claiming(plan, "optimal", "proven", "critical_path", 7)
    assert (check(best), taken_on_trust(best)) == ((), ())
    assert only(claiming(plan, "optimal", "proven", "magic", 7)).rule == "claim_unfounded"
    late = plan_of(ORDERED, times((1, "r-1", 0, 3), (2, "r-2", 4, 8)))
    finding = only(claiming(late, "optimal", "proven", "critical_path", 8))
    assert (finding.rule, finding.found, finding.needed) == ("claim_unfounded", "8 s", "at most 7 s")
    assert only(claiming(late, "feasible", "bounded", "critical_path", 7.5)).needed == "at most 7 s"


def test_travel_counts_in_the_bound() -> None:
    """10 m at 2 m/s and 3 s of work: 8 s; the far robot of the two, at (10, 20), has 20 m to go and does not count."""
    optimal = claiming(
        plan_of(AT, times((1, "r-1", 5, 8)), leg(1, 0, 5, HERE, THERE, 10), scene=SCENE),
        "optimal",
        "proven",
        "critical_path",
        8,
    )
    assert (check(optimal), taken_on_trust(optimal)) == ((), ())
    robots = tuple(Robot(id=name, position=spot) for name, spot in (("r-1", HERE), ("r-2", FAR)))
    kind = RobotType(id="r", capabilities={"any": 1.0}, limits={"max_speed_mps": 2.0}, robots=robots)
    farther = replace(
        plan_of(AT, times((1, "r-2", 10, 13)), leg(1, 0, 10, FAR, THERE, 20, "r-2"), fleet=Fleet((kind,)), scene=SCENE)
    )
    # 13 s are not the least; with travel about, the scheduler may know more than the checker, which says so.
    claimed = claiming(farther, "optimal", "proven", "critical_path", 13)
    assert check(claimed) == ()
    (notice,) = taken_on_trust(claimed)
    assert (notice.rule, notice.severity, notice.found, notice.needed) == ("bound_on_trust", "notice", "13 s", "8 s")


def test_one_robot_does_all_roles_of_its_type_one_after_the_other() -> None:
    """3 s and 4 s by the only robot: 7 s, in either order."""
    plan = plan_of(TWO, times((1, "r-1", 0, 3), (2, "r-1", 3, 7)), fleet=team(1))
    best = claiming(plan, "optimal", "proven", "load", 7)
    assert (check(best), taken_on_trust(best)) == ((), ())


def test_impossible_needs_a_proof() -> None:
    """A doable mission, given up with an invented reason: no ranking, or one whose schedules are not all excluded."""
    plan = plan_of(TWO, times((1, "r-1", 0, 3), (2, "r-2", 0, 4)))
    why = Reason(rule="too_hard", message="It is too hard.")
    given_up = replace(plan, outcome="cannot_be_done", ranking=None, schedules=(), reasons=(why,))
    assert rules(given_up) == ["impossibility_unproven", "reason_invented"]
    excluded = Certificate(claim="proven", method="reachability")
    schedule = Schedule(rank=1, status="infeasible", certificate=excluded, reasons=(why,))
    impossible = replace(plan, outcome="cannot_be_done", schedules=(schedule,), reasons=(why,))
    assert check(impossible) == ()
    assert [notice.rule for notice in taken_on_trust(impossible)] == ["infeasibility_on_trust"]
    assert plan.ranking is not None
    # The ranking says that there may be more, of utility 1 at most; there are none, but it has to say that.
    open_end = replace(plan.ranking, certificate=replace(PROVEN, bound=1.0))
    assert rules(replace(impossible, ranking=open_end)) == ["impossibility_unproven"]


def test_a_ranking_that_claims_to_be_complete_is_refuted_by_one_more_alternative() -> None:
    """The XOR offers a and b, equal in utility; a alone is listed, and nothing is said to be left."""
    tree = grounded(and_(xor_(leaf("a", duration_s=3), leaf("b", duration_s=3))))
    plan = plan_of(tree, times((2, "r-1", 0, 3)))
    assert plan.ranking is not None
    chosen = replace(plan.ranking.alternatives[0], choices=(Choice(1, 2),), utility=1.0)
    complete = replace(plan, ranking=replace(plan.ranking, alternatives=(chosen,)))
    assert only(complete).found == "no bound on what is not listed"
    rest = replace(PROVEN, bound=1.0)
    assert check(replace(plan, ranking=replace(plan.ranking, alternatives=(chosen,), certificate=rest))) == ()


def held_by_two(first_s: float, second_s: float, capacity: int = 1, lasts_s: float = 4) -> Plan:
    """Two actions of 4 s (or as long as given) by two robots, each of which holds the door."""
    tree = grounded(
        and_(*(leaf(f"pass{number}", role=f"R{number}", duration_s=lasts_s, holds=("door",)) for number in range(2)))
    )
    scene = replace(SCENE, resources=(SharedResource(id="door", capacity=capacity),))
    spans = times((1, "r-1", first_s, first_s + lasts_s), (2, "r-2", second_s, second_s + lasts_s))
    return plan_of(tree, spans, scene=scene)


def test_a_door_is_held_by_one_at_a_time() -> None:
    """0-4 and 4-8 are sound, and 0-4 and 3.999-7.999 within a tick; at 3 s two would be in it."""
    assert rules(held_by_two(0, 4)) == []
    assert rules(held_by_two(0, 3.999)) == []
    assert rules(held_by_two(0, 3, capacity=2)) == []
    fault = only(held_by_two(0, 3))
    assert (fault.rule, fault.found, fault.needed, fault.robot) == (
        "resource_overfull",
        "2 at once",
        "at most 1",
        "r-2",
    )
    assert "at 3 s door is held by r-1 in pass0 [1], r-2 in pass1 [2]" in fault.message


def test_what_takes_no_time_is_not_inside_what_fills_the_door() -> None:
    """One action of 4 s, 0-4, and one of no time: at 0 s or 4 s it is sound, at 2 s not."""
    tree = grounded(
        and_(
            leaf("stay", role="R0", duration_s=4, holds=("door",)),
            leaf("pass", role="R1", duration_s=0, holds=("door",)),
        )
    )
    scene = replace(SCENE, resources=(SharedResource(id="door"),))
    for moment, expected in ((0, []), (4, []), (2, ["resource_overfull"])):
        assert rules(plan_of(tree, times((1, "r-1", 0, 4), (2, "r-2", moment, moment)), scene=scene)) == expected


def relay(take_s: float, *, at: str = "box", kind: LinkKind = "hand_over") -> Plan:
    """Robot r-1 works 5 s at the box, until 10 s, and hands over to r-2, which takes 2 s there; both are there from the start."""
    tree = grounded(
        and_(
            and_(leaf("give", role="R0", duration_s=5, at="box"), label="giver"),
            and_(leaf("take", role="R1", duration_s=2, at=at), label="taker"),
        ),
        (("giver", "taker", kind),),
    )
    spans = times((2, "r-1", 5, 10), (4, "r-2", take_s, take_s + 2))
    return plan_of(tree, spans, fleet=team(position=THERE), scene=SCENE)


def test_who_takes_over_starts_just_when_who_hands_over_ends() -> None:
    """The giver ends at 10 s; a tick more or less is the clock's."""
    assert rules(relay(10)) == []
    assert rules(relay(10.001)) == []
    fault = only(relay(12))
    assert (fault.rule, fault.found, fault.needed, fault.robot) == ("hand_over_missed", "12 s", "10 s", "r-2")
    assert rules(relay(12, kind="precedence")) == []


def test_who_takes_over_is_where_who_hands_over_is() -> None:
    """The place "there" is where the box is; but whoever takes over there might find the box gone."""
    assert rules(relay(10, at="there")) == ["hand_over_unfit"]


def test_what_must_be_taken_in_at_chargers_counts_in_the_bound_that_claims_it() -> None:
    """
    Two jobs of 10 s and 60 J, and 100 J: 20 J are lacking, 2 s at 10 J/s; with 20 s of jobs none is shorter than 22 s.

    With two robots that hold 50 J each it is the charger that both need: 2 s, and a job after it, 12 s; shared evenly they have 11 s to do.
    """
    uses = {"energy_j": 60.0}
    tree = grounded(and_(leaf("a", duration_s=10, uses=uses), leaf("b", duration_s=10, uses=uses)))
    plug = Charger(id="plug", position=HERE, rate_per_s=10)
    scene = replace(SCENE, chargers=(plug,))
    alone = team(1, position=None, limits={"energy_j": 100.0})
    plan = plan_of(tree, times((1, "r-1", 0, 10), (2, "r-1", 12, 22)), fleet=alone, scene=scene)
    visit = Recharge(robot="r-1", charger="plug", start_s=10, end_s=12, amount=20)
    plan = replace(plan, schedules=(replace(plan.schedules[0], recharges=(visit,)),))
    assert least(claiming(plan, "optimal", "proven", "refill_load", 22)) == 22_000
    assert least(claiming(plan, "optimal", "proven", "load", 20)) == 20_000
    assert "claim_unfounded" not in rules(claiming(plan, "feasible", "bounded", "refill_load", 22))
    assert "claim_unfounded" in rules(claiming(plan, "feasible", "bounded", "refill_load", 22.5))
    low = tuple(Robot(id=f"r-{number}", remaining={"energy_j": 50.0}) for number in (1, 2))
    two = RobotType(id="r", capabilities={"any": 1.0}, limits={"energy_j": 100.0}, robots=low)
    plan = plan_of(tree, times((1, "r-1", 0, 10), (2, "r-2", 12, 22)), fleet=Fleet((two,)), scene=scene)
    assert least(claiming(plan, "feasible", "bounded", "refill_load", 12)) == 12_000


@pytest.mark.parametrize(("moves", "seconds"), [(False, 17), (True, 15)])
def test_ways_into_roles_count_in_the_bound(moves: bool, seconds: int) -> None:
    """
    One robot at the origin, 2 m/s, has to be at (10, 0) and at (10, 20), a second of work at each, or no more than a move there.

    To (10, 0) it comes from no nearer than the origin, 5 s; to (10, 20) from no nearer than (10, 0), 10 s. With the work 17 s, which
    it can do; the checker's bound is as long whether the ways are before actions or actions themselves.
    """
    more = {"moves": True} if moves else {"duration_s": 1}
    tree = grounded(and_(leaf("a", role="x", at="there", **more), leaf("b", role="y", at="far", **more)))
    actions = times((1, "r-1", 0, 5), (2, "r-1", 5, 15)) if moves else times((1, "r-1", 5, 6), (2, "r-1", 16, 17))
    second = 5 if moves else 6
    legs = (leg(1, 0, 5, HERE, THERE, 10), leg(2, second, second + 10, THERE, FAR, 20))
    plan = plan_of(tree, actions, *legs, fleet=team(1), scene=SCENE)
    assert check(plan) == ()
    assert least(plan) == 1000 * seconds


def least(plan: Plan) -> int | None:
    """The checker's own bound of the only schedule."""
    case = Case(plan)
    return least_makespan(case, case.timetables[0])
