"""Small plans written by hand, sound but for one thing; the numbers of the findings are derived beside them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from missiontree.checking import check
from missiontree.formats.inputs import input_digests
from missiontree.mission.alternative import Alternative, Assignment, Choice, Ranking, RoleType
from missiontree.mission.brief import MissionBrief
from missiontree.mission.certificate import Certificate
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.grounded import GroundedTree, Grounding
from missiontree.mission.plan import Plan, Provenance
from missiontree.mission.position import Position
from missiontree.mission.reason import Reason
from missiontree.mission.scene import Entity, Scene
from missiontree.mission.schedule import Schedule, ScheduledAction, TravelLeg
from missiontree.routines.library import built_in
from tests.builders import and_, grounded, leaf, xor_

PROVEN = Certificate(claim="proven", method="enumeration")
BOUNDED = Certificate(claim="bounded", method="critical_path", bound=0.0)
HERE, THERE, FAR = Position(0, 0), Position(10, 0), Position(10, 20)
SCENE = Scene(
    places=(Entity(id="there", kind="place", position=THERE), Entity(id="far", kind="place", position=FAR)),
    entities=(Entity(id="box", position=THERE, max_speed_mps=1.0),),
)


def team(count: int = 2, **changes: Any) -> Fleet:
    """Robots r-1, r-2, ... at the origin, 2 m/s."""
    fields: dict[str, Any] = {
        "capabilities": {"any": 1.0},
        "limits": {"max_speed_mps": 2.0},
        "position": HERE,
        **changes,
    }
    return Fleet((RobotType(id="r", count=count, **fields),))


def times(*spans: tuple[int, str, float, float]) -> tuple[ScheduledAction, ...]:
    """Scheduled actions from (leaf, robot, start, end)."""
    made = (ScheduledAction(leaf=leaf, robot=robot, start_s=start, end_s=end) for leaf, robot, start, end in spans)
    return tuple(sorted(made, key=lambda done: (done.start_s, done.leaf)))


def leg(
    leaf: int, start_s: float, end_s: float, origin: Position, goal: Position, metres: float, robot: str = "r-1"
) -> TravelLeg:
    return TravelLeg(
        robot=robot, leaf=leaf, start_s=start_s, end_s=end_s, origin=origin, destination=goal, distance_m=metres
    )


def plan_of(
    tree: GroundedTree,
    actions: tuple[ScheduledAction, ...],
    *legs: TravelLeg,
    fleet: Fleet | None = None,
    scene: Scene | None = None,
) -> Plan:
    """A plan of a tree without choices, whose roles go to the robots that the actions name."""
    brief = MissionBrief(text="By hand", fleet=fleet or team(), routines=built_in(), scene=scene)
    utility = sum(node.action.estimate.quality for node in tree.nodes if node.action is not None)
    robots = {tree.action(done.leaf).role: done.robot for done in actions}
    alternative = Alternative(
        rank=1,
        utility=utility,
        choices=(),
        roles=tuple(RoleType(role, "r") for role in sorted(robots)),
        certificate=PROVEN,
    )
    schedule = Schedule(
        rank=1,
        status="feasible",
        certificate=BOUNDED,
        assignments=tuple(Assignment(role, robots[role]) for role in sorted(robots)),
        actions=actions,
        legs=legs,
        makespan_s=max(done.end_s for done in actions),
    )
    return Plan(
        outcome="delivered",
        brief=brief,
        grounding=Grounding(tree=tree),
        ranking=Ranking(alternatives=(alternative,), status="exact", certificate=PROVEN),
        schedules=(schedule,),
        digests=input_digests(brief, None),
        provenance=Provenance(author="given"),
    )


def only(plan: Plan) -> Reason:
    """The one finding."""
    findings = check(plan)
    assert len(findings) == 1, [finding.rule for finding in findings]
    return findings[0]


def rules(plan: Plan) -> list[str]:
    return [finding.rule for finding in check(plan)]


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


def test_an_open_end_lasts_until_the_other_node_ends() -> None:
    """a until b, b from 0 to 4: a ends at 4, whatever its own 3 s."""
    tree = grounded(and_(leaf("a", duration_s=3, open_ended=True), leaf("b", duration_s=4)), [("a", "b", "until")])
    assert check(plan_of(tree, times((1, "r-1", 0, 4), (2, "r-2", 0, 4)))) == ()
    assert only(plan_of(tree, times((1, "r-1", 0, 3), (2, "r-2", 0, 4)))).needed == "4 s"
    # Started at 6, after b has ended: it ends at once.
    assert check(plan_of(tree, times((1, "r-1", 6, 6), (2, "r-2", 0, 4)))) == ()


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


def by_start(*legs: TravelLeg) -> list[TravelLeg]:
    return sorted(legs, key=lambda one: (one.start_s, one.leaf, one.robot))


def test_what_is_brought_caps_the_speed_and_is_at_the_new_place_afterwards() -> None:
    assert check(plan_of(BRING, BROUGHT, *by_start(TO_BOX, WITH_BOX, TO_FAR), scene=SCENE)) == ()
    light = replace(SCENE, entities=(replace(SCENE.entities[0], max_speed_mps=0.5),))
    # At 0.5 m/s the 20 m take 40 s.
    assert only(plan_of(BRING, BROUGHT, *by_start(TO_BOX, WITH_BOX, TO_FAR), scene=light)).needed == "at least 40 s"


def test_nobody_uses_a_moved_thing_where_it_was() -> None:
    stale = leg(3, 0, 26, HERE, THERE, 10, "r-2")
    finding = only(plan_of(BRING, BROUGHT, *by_start(TO_BOX, WITH_BOX, stale), scene=SCENE))
    assert (finding.rule, finding.robot) == ("leg_destination_wrong", "r-2")


def test_the_leg_of_a_move_has_the_time_of_the_move() -> None:
    early = replace(WITH_BOX, start_s=5.5)
    assert only(plan_of(BRING, BROUGHT, *by_start(TO_BOX, early, TO_FAR), scene=SCENE)).rule == "leg_at_wrong_time"


def test_a_robot_that_starts_nobody_knows_where_travels_in_no_time() -> None:
    """No leg to the first place, then one from there: 20 m at 2 m/s."""
    tree = grounded(and_(leaf("a", role="x", at="there", duration_s=3), leaf("b", role="x", at="far", duration_s=1)))
    fleet = team(position=None)
    actions = times((1, "r-1", 0, 3), (2, "r-1", 13, 14))
    assert check(plan_of(tree, actions, leg(2, 3, 13, THERE, FAR, 20), fleet=fleet, scene=SCENE)) == ()
    assert only(plan_of(tree, actions, fleet=fleet, scene=SCENE)).rule == "leg_missing"


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
    assert check(plan_of(tree, actions, fleet=team(total_limits={"paint_l": 7}))) == ()
    # Even by what allocation knows, no robots fit into 6.
    assert rules(plan_of(tree, actions, fleet=team(total_limits={"paint_l": 6}))) == [
        "alternative_unstaffable", "claim_refuted", "total_budget_exceeded",
    ]  # fmt: skip


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
