"""The critical chain: contiguous from the start to the end of a mission, each step there for a reason that holds."""

from dataclasses import replace
from itertools import pairwise
from random import Random

import pytest
from hypothesis import given, settings

from benchmarks.schedule_cases import random_schedule_case
from missiontree.mission.chain import Step
from missiontree.mission.charger import Charger
from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet, Robot
from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule
from missiontree.mission.terms import Terms
from missiontree.reporting.critical.chain import chain_of, critical_chain
from missiontree.reporting.critical.spans import ms
from missiontree.scheduling.greedy import greedy
from tests.reporting.charts import plan_of, planned, plans
from tests.scheduling.instances import Instance, Part, at, mission, move, robots, scene, work


def chain(plan: Plan) -> tuple[Step, ...]:
    assert plan.grounding is not None
    return critical_chain(plan.grounding.tree, plan.schedules[0], fleet=plan.brief.fleet)


def told(plan: Plan) -> list[tuple[str, str, str, float, float, str]]:
    """The chain as kind, action, robot, start, end and bond."""
    assert plan.grounding is not None
    tree = plan.grounding.tree
    return [(one.kind, tree.action(one.leaf).text, one.robot, one.start_s, one.end_s, one.bond) for one in chain(plan)]


def test_one_robot_after_the_other_is_a_chain_by_order() -> None:
    """A takes 2 + 3 s, B starts when A has ended and takes 4 s; C takes 1 s beside them."""
    instance = mission(
        [Part("A", "a", [work(2), work(3)]), Part("B", "b", [work(4)]), Part("C", "c", [work(1)])], [("A", "B")]
    )
    plan = planned(instance, Fleet((robots("a"), robots("b"), robots("c"))))
    assert told(plan) == [
        ("action", "A.0", "a-1", 0, 2, "start"),
        ("action", "A.1", "a-1", 2, 5, "role"),
        ("action", "B.0", "b-1", 5, 9, "order"),
    ]


def test_a_busy_robot_binds_what_it_does_next() -> None:
    """One robot, two roles of 3 s each that nothing orders: the second waits for the robot."""
    instance = mission([Part("A", "a", [work(3)]), Part("B", "a", [work(3)])])
    plan = planned(instance, Fleet((robots("a"),)))
    assert [(step[0], step[3], step[4], step[5]) for step in told(plan)] == [
        ("action", 0, 3, "start"),
        ("action", 3, 6, "robot"),
    ]


def test_the_way_to_an_action_is_a_step_of_its_own() -> None:
    """6 m at 2 m/s take 3 s before the work at p of 5 s."""
    instance = mission([Part("A", "a", [work(5, at="p")])])
    plan = planned(instance, Fleet((robots("a", speed=2.0, position=at(0)),)), scene(p=6))
    assert told(plan) == [
        ("travel", "A.0", "a-1", 0, 3, "start"),
        ("action", "A.0", "a-1", 3, 8, "travel"),
    ]


def test_a_move_is_an_action_and_no_way_besides() -> None:
    instance = mission([Part("A", "a", [move("p"), work(1, at="p")])])
    plan = planned(instance, Fleet((robots("a", speed=2.0, position=at(0)),)), scene(p=6))
    assert told(plan) == [("action", "A.0", "a-1", 0, 3, "start"), ("action", "A.1", "a-1", 3, 4, "role")]


def test_joint_work_waits_for_the_later_partner() -> None:
    """B comes after 7 s, A after 2 s; what they do together starts at 7 s because of B."""
    instance = mission([Part("A", "a", [work(2), work(3, sync=0)]), Part("B", "b", [work(7), work(3, sync=0)])])
    plan = planned(instance, Fleet((robots("a"), robots("b"))))
    assert told(plan) == [
        ("action", "B.0", "b-1", 0, 7, "start"),
        ("action", "A.1", "a-1", 7, 10, "partner"),
    ]


def test_who_is_brought_binds_what_is_done_with_them() -> None:
    """The box is at p (2 m) and is taken to q (8 m) at 1 m/s: there 8 s after the start; then it is worked on where it is."""
    instance = mission(
        [Part("A", "a", [move("box"), move("q", "box")]), Part("B", "b", [work(4, at="box")])], [("A", "B")]
    )
    plan = planned(
        instance, Fleet((robots("a", speed=1.0, position=at(0)), robots("b", position=at(8)))), scene(q=8, box=2)
    )
    steps = told(plan)
    assert [step[:5] for step in steps] == [
        ("action", "A.0", "a-1", 0, 2),
        ("action", "A.1", "a-1", 2, 8),
        ("action", "B.0", "b-1", 8, 12),
    ]
    assert steps[-1][5] == "order"  # that the box is there then is true as well; the link is what people wrote


def test_who_still_needs_a_thing_holds_back_who_takes_it_away() -> None:
    """A works on the box for 6 s; B is there after 2 s and takes it 6 m to q at 1 m/s, which it can from 6 s on."""
    instance = mission([Part("A", "a", [work(6, at="box")]), Part("B", "b", [move("box"), move("q", "box")])])
    plan = planned(
        instance, Fleet((robots("a", position=at(2)), robots("b", speed=1.0, position=at(0)))), scene(q=8, box=2)
    )
    assert told(plan) == [
        ("action", "A.0", "a-1", 0, 6, "start"),
        ("action", "B.1", "b-1", 6, 12, "entity"),
    ]


def test_an_open_ended_action_hands_the_chain_on_to_what_ends_it() -> None:
    """F follows until W has ended after 6 s; only then its robot reports, for 2 s."""
    instance = mission(
        [Part("F", "a", [work(1, open_ended=True), work(2)]), Part("W", "b", [work(6)])], [("F", "W", "until")]
    )
    plan = planned(instance, Fleet((robots("a"), robots("b"))))
    assert told(plan) == [
        ("action", "W.0", "b-1", 0, 6, "start"),
        ("until", "F.0", "a-1", 6, 6, "until"),
        ("action", "F.1", "a-1", 6, 8, "role"),
    ]


def test_what_must_be_under_way_holds_back_what_it_lasts_for() -> None:
    """F starts after 5 s of its robot's work and must be under way when W ends; W takes 1 s, so it ends at 5.001 s at the earliest."""
    instance = mission(
        [Part("F", "a", [work(5), work(1, open_ended=True)]), Part("W", "b", [work(1)])], [("F.1", "W", "until")]
    )
    plan = planned(instance, Fleet((robots("a"), robots("b"))))
    assert plan.schedules[0].makespan_s == 5.001
    assert [(step[0], step[1], step[3], step[4]) for step in told(plan)] == [
        ("action", "F.0", 0, 5),
        ("under_way", "F.1", 5, 5.001),
        ("until", "F.1", 5.001, 5.001),  # W.0 ends, and with it F.1
    ]


def test_a_wait_without_a_reason_is_said_to_be_one() -> None:
    """By hand, the second action starts a second late: the chain has that second, unexplained."""
    instance = mission([Part("A", "a", [work(2), work(3)])])
    plan = planned(instance, Fleet((robots("a"),)))
    schedule = plan.schedules[0]
    late = tuple(
        replace(one, start_s=one.start_s + 1, end_s=one.end_s + 1) if one.start_s == 2 else one
        for one in schedule.actions
    )
    plan = replace(plan, schedules=(replace(schedule, actions=late, makespan_s=6.0),))
    assert told(plan) == [
        ("action", "A.0", "a-1", 0, 2, "start"),
        ("wait", "A.1", "a-1", 2, 3, "role"),
        ("action", "A.1", "a-1", 3, 6, "unexplained"),
    ]


def test_a_late_start_of_everything_is_a_wait_from_the_beginning() -> None:
    instance = mission([Part("A", "a", [work(2)])])
    plan = planned(instance, Fleet((robots("a"),)))
    late = tuple(replace(one, start_s=4.0, end_s=6.0) for one in plan.schedules[0].actions)
    plan = replace(plan, schedules=(replace(plan.schedules[0], actions=late, makespan_s=6.0),))
    assert [(step[0], step[3], step[4]) for step in told(plan)] == [("wait", 0, 4), ("action", 4, 6)]


def test_where_nothing_takes_time_there_is_no_chain() -> None:
    instance = mission([Part("A", "a", [work(0), work(0)])])
    plan = planned(instance, Fleet((robots("a"),)))
    assert chain(plan) == ()
    assert critical_chain(instance.tree, replace(plan.schedules[0], actions=(), legs=())) == ()


@given(plans())
def test_the_chain_runs_without_a_gap_from_the_start_to_the_end(plan: Plan) -> None:
    schedule = plan.schedules[0]
    steps = chain(plan)
    assert bool(steps) == bool(schedule.makespan_s)
    if steps:
        assert steps[0].start_s == 0
        assert steps[-1].end_s == schedule.makespan_s
        assert all(before.end_s == after.start_s for before, after in pairwise(steps))
        assert "wait" not in {step.kind for step in steps}  # our schedules never wait without a reason


@given(plans())
@settings(max_examples=60)
def test_every_step_is_in_the_schedule(plan: Plan) -> None:
    assert plan.grounding is not None
    tree, schedule = plan.grounding.tree, plan.schedules[0]
    actions = {(one.leaf, one.robot, one.start_s, one.end_s) for one in schedule.actions}
    legs = {(leg.leaf, leg.robot, leg.start_s, leg.end_s) for leg in schedule.legs}
    robot = {one.leaf: one.robot for one in schedule.actions}
    for step in chain(plan):
        if step.kind == "action":
            assert (step.leaf, step.robot, step.start_s, step.end_s) in actions
        elif step.kind == "travel":
            assert (step.leaf, step.robot, step.start_s, step.end_s) in legs
            assert not tree.action(step.leaf).moves
        else:
            assert tree.action(step.leaf).open_ended
            assert ms(step.end_s) - ms(step.start_s) == (1 if step.kind == "under_way" else 0)
            assert step.robot == robot[step.leaf]


@given(plans())
@settings(max_examples=60)
def test_every_bond_holds(plan: Plan) -> None:
    """Read off the tree anew, without the code that finds the bonds."""
    assert plan.grounding is not None
    tree, schedule = plan.grounding.tree, plan.schedules[0]
    checks = Checks(plan, schedule)
    for before, after in pairwise(chain(plan)):
        one, other = tree.action(before.leaf), tree.action(after.leaf)
        if after.bond == "role":
            assert one.role == other.role
        elif after.bond == "robot":
            assert before.robot == after.robot
        elif after.bond == "travel":
            assert (before.kind, before.leaf) == ("travel", after.leaf)
        elif after.bond == "order":
            assert checks.ordered(before.leaf, after.leaf)
        elif after.bond == "entity":
            assert {*one.brings} & {other.at, *other.brings} or one.at in other.brings
        elif after.bond == "partner":
            assert other.sync is not None
        elif after.bond == "until":
            assert after.kind == "until"
            assert checks.below_until(after.leaf)
        else:
            assert after.bond == "under_way"


class Checks:
    """What the tree says about two leaves."""

    def __init__(self, plan: Plan, schedule: Schedule) -> None:
        assert plan.grounding is not None
        self.tree = plan.grounding.tree
        self.scheduled = {one.leaf for one in schedule.actions}

    def above(self, leaf: int) -> set[int]:
        found, node = set(), leaf
        while node >= 0:
            found.add(node)
            node = self.tree.nodes[node].parent
        return found

    def ordered(self, first: int, second: int) -> bool:
        """Some precedence leads from a node over the first, or over what the first ends, to one over the second."""
        return any(
            link.kind == "precedence" and link.second in self.above(second) and link.first in self.above(first)
            for link in self.tree.links
        )

    def below_until(self, leaf: int) -> bool:
        return any(link.kind == "until" and link.first in self.above(leaf) for link in self.tree.links)


def test_a_long_chain_is_found_without_recursion_and_in_time_that_grows_with_its_length() -> None:
    """Three thousand actions of one role, 1 s each: a chain of as many steps."""
    instance: Instance = mission([Part("A", "a", [work(1)] * 3000)])
    plan = planned(instance, Fleet((robots("a"),)))
    assert len(chain(plan)) == 3000


def test_a_release_time_begins_the_chain() -> None:
    """A, 2 s, from 4 s on, and B after it: nothing before 4 s explains the length."""
    instance = mission([Part("A", "a", [work(2)]), Part("B", "a", [work(3)])], [("A", "B")]).timed(A=(4, None))
    assert told(planned(instance, Fleet((robots("a"),)))) == [
        ("wait", "A.0", "a-1", 0, 4, "start"),
        ("action", "A.0", "a-1", 4, 6, "release"),
        ("action", "B.0", "a-1", 6, 9, "order"),
    ]


def test_a_robot_that_comes_late_begins_the_chain() -> None:
    """The robot takes part from 7 s on and needs 3 s for the way to p, 6 m at 2 m/s, and 5 s for the work: 15 s."""
    instance = mission([Part("A", "a", [work(5, at="p")])])
    late = robots("a", speed=2.0, position=at(0), available_from_s=7.0)
    plan = planned(instance, Fleet((late,)), scene(p=6))
    assert told(plan) == [
        ("wait", "A.0", "a-1", 0, 7, "start"),
        ("travel", "A.0", "a-1", 7, 10, "available"),
        ("action", "A.0", "a-1", 10, 15, "travel"),
    ]


def test_the_later_of_two_robots_that_come_late_is_the_one_that_counts() -> None:
    """Joint work of 2 s; a comes at 3 s, b at 5 s."""
    instance = mission([Part("A", "a", [work(2, sync=0)]), Part("B", "b", [work(2, sync=0)])])
    fleet = Fleet((robots("a", available_from_s=3.0), robots("b", available_from_s=5.0)))
    steps = told(planned(instance, fleet))
    assert [(step[0], step[3], step[4], step[5]) for step in steps] == [
        ("wait", 0, 5, "start"),
        ("action", 5, 7, "available"),
    ]


def test_what_two_ends_wait_for_is_found_through_what_lasts_until_them() -> None:
    """
    G lasts until F ends, and F until W does. G begins when its robot has worked 6 s; so F ends at 6.001 s at the earliest, and W, 1 s, with
    it: it is G's robot that makes it late, though G does not last until W.
    """
    instance = mission(
        [
            Part("X", "a", [work(6), work(0, open_ended=True)]),
            Part("F", "b", [work(2, open_ended=True)]),
            Part("W", "c", [work(1)]),
        ],
        [("X.1", "F", "until"), ("F", "W", "until")],
    )
    plan = planned(instance, Fleet((robots("a"), robots("b"), robots("c"))))
    assert plan.schedules[0].makespan_s == 6.001
    assert [(step[0], step[1], step[3], step[4]) for step in told(plan)][:2] == [
        ("action", "X.0", 0, 6),
        ("under_way", "X.1", 6, 6.001),
    ]


@pytest.mark.parametrize("seed", range(0, 9000, 60))
def test_a_chain_adds_up_to_the_makespan_and_explains_all_of_it_under_every_rule(seed: int) -> None:
    """Release times, robots that come late, things, shared resources, joint work, until links, limits: whatever schedules keep."""
    case = random_schedule_case(Random(seed))  # noqa: S311 - reproducible draws
    schedule = greedy(case.tree, case.alternative, case.fleet, case.scene, Control(seed=seed), case.terms)
    plan = plan_of(Instance(case.tree, case.alternative, {}), schedule, case.fleet)
    found = chain_of(replace(plan, brief=replace(plan.brief, scene=case.scene)), schedule)
    lengths = [ms(step.end_s) - ms(step.start_s) for step in found.steps]
    assert sum(lengths) == ms(schedule.makespan_s)
    assert ms(found.work_s) + ms(found.travel_s) + ms(found.waiting_s) == ms(schedule.makespan_s)
    assert all(before.end_s == after.start_s for before, after in pairwise(found.steps))
    assert "unexplained" not in {step.bond for step in found.steps}


def test_a_visit_to_a_charger_before_all_else_is_on_the_chain() -> None:
    """
    With 10 of 100 J at the start, the robot needs 60 J for a job at 0 and is 5 m from the charger: there at 5 s with 5 J, 60 + 5 J less
    those 5 are taken in, 60 J in 6 s, back at 16 s, done at 26 s. Nothing is waited for.
    """
    instance = mission([Part("A", "r", [work(10, at="p", uses={"energy_j": 60.0})])])
    plug = Charger(id="plug", position=at(5), rate_per_s=10)
    kind = robots(
        "r",
        speed=1.0,
        robots=(Robot(id="x", position=at(0), remaining={"energy_j": 10.0}),),
        limits={"energy_j": 100.0},
        uses_per_m={"energy_j": 1.0},
    )
    world = replace(scene(p=0), chargers=(plug,))
    terms = Terms(chargers=(plug,))
    result = greedy(instance.tree, instance.alternative, Fleet((kind,)), world, Control(), terms)
    steps = critical_chain(instance.tree, result, world, Fleet((kind,)))
    assert [(step.kind, step.start_s, step.end_s, step.bond) for step in steps] == [
        ("refill", 0.0, 11.0, "start"),
        ("travel", 11.0, 16.0, "refill"),
        ("action", 16.0, 26.0, "travel"),
    ]
