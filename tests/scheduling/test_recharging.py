"""Robots that refill at chargers: levels are kept, detours are the shortest that are needed, and what cannot be is proven."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from benchmarks.campaign import luck
from benchmarks.schedule_cases import random_schedule_case
from benchmarks.scheduling_agreement import judge
from missiontree.mission.charger import Charger
from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.schedule import Schedule
from missiontree.mission.terms import Terms
from missiontree.scheduling import SCHEDULERS
from missiontree.scheduling.course import Course
from missiontree.scheduling.greedy import read_problem
from missiontree.scheduling.problem import FILLINGS, Problem
from missiontree.scheduling.replay import replay
from tests.scheduling.instances import Instance, Part, at, mission, robots, scene, times, work

CASES = [index for index in range(200) if "chargers" in random_schedule_case(luck(8, index)).features]
PLUG = Charger(id="plug", position=at(2), rate_per_s=10)
JOB: dict[str, Any] = work(10, at="p", uses={"energy_j": 60.0})


def battery(count: int = 1, **more: Any) -> RobotType:
    """Robots at 0 that go 1 m/s, hold 100 J and use 1 J a metre."""
    given = {"position": at(0), "limits": {"energy_j": 100.0}, "uses_per_m": {"energy_j": 1.0}} | more
    if "robots" in given:
        del given["position"]
    return robots("r", count, 1.0, **given)


def planned(
    made: Instance, *types: RobotType, chargers: tuple[Charger, ...] = (PLUG,), scheduler: str = "greedy", **terms: Any
) -> Schedule:
    """The schedule of an instance with chargers; p is at 0 and q at 30."""
    world = replace(scene(p=0, q=30), chargers=chargers)
    run = SCHEDULERS[scheduler]
    return run(made.tree, made.alternative, Fleet(types), world, Control(), Terms(chargers=chargers, **terms))


def visits(result: Schedule) -> list[tuple[str, float, float, float]]:
    return [(one.robot, one.start_s, one.end_s, round(one.amount, 6)) for one in result.recharges]


@pytest.mark.parametrize("scheduler", ["greedy", "cpsat", "auto"])
def test_two_jobs_of_sixty_joules_take_one_visit_to_the_charger(scheduler: str) -> None:
    """
    100 J, two jobs of 60 J and 10 s on the spot, a charger of 10 J/s 2 m away, 1 m/s, 1 J/m.

    First job 0 to 10 s, 40 J are left. Way to the charger 10 to 12 s, 38 J. Back it takes 2 J, the job 60 J: 62 J, so 24 J are taken in,
    in 2.4 s, 12 to 14.4 s. Way back to 16.4 s, second job to 26.4 s, nothing is left.
    """
    made = mission([Part("a", "r", [JOB]), Part("b", "r", [JOB])])
    result = planned(made, battery(), scheduler=scheduler)
    assert visits(result) == [("r-1", 12, 14.4, 24)]
    leg = result.recharges[0].leg
    assert leg is not None
    assert (leg.start_s, leg.end_s, leg.distance_m) == (10, 12, 2)
    assert sorted(times(made, result).values()) == [(0, 10), (16.4, 26.4)]
    assert (result.makespan_s, result.status) == (26.4, "feasible")
    assert result.certificate.bound == 24.2  # see test_refilling


def test_a_level_that_lasts_needs_no_charger() -> None:
    """A hundred joules for a job of 60 and the ways of 0 m: nobody refills, and that no schedule is shorter is proven."""
    made = mission([Part("a", "r", [JOB])])
    result = planned(made, battery())
    assert (result.recharges, result.makespan_s, result.status) == ((), 10, "optimal")


def test_a_robot_starts_at_its_own_level() -> None:
    """59 J are left at the start: 57 J at the charger, and 62 J are needed there; so 5 J in 0.5 s, and the job from 4.5 s on."""
    made = mission([Part("a", "r", [JOB])])
    low = battery(robots=(Robot(id="x", position=at(0), remaining={"energy_j": 59.0}),))
    result = planned(made, low)
    assert visits(result) == [("x", 2, 2.5, 5)]
    assert times(made, result) == {"a.0": (4.5, 14.5)}


def test_a_charger_with_room_for_one_lets_the_other_wait() -> None:
    """
    Two robots, four jobs of 60 J: each robot does two, and needs 24 J at the charger, 2.4 s. They come at 12 s; one is there until 14.4 s
    and done at 26.4 s, the other from 14.4 to 16.8 s, and done at 28.8 s. With room for two both are done at 26.4 s.
    """
    made = mission([Part(name, "r", [JOB]) for name in "abcd"])
    result = planned(made, battery(2))
    assert [(start, end) for _, start, end, _ in visits(result)] == [(12, 14.4), (14.4, 16.8)]
    assert result.makespan_s == 28.8
    wide = planned(made, battery(2), chargers=(replace(PLUG, capacity=2),))
    assert wide.makespan_s == 26.4


def test_a_robot_keeps_enough_for_the_way_to_a_charger() -> None:
    """
    A job of 60 J at 30 m first takes 30 + 60 J of 100 J; 10 J are left, and the charger at 2 m is 28 m away: the robot would be stranded.
    It cannot have more than 100 J there, so no schedule that goes on is found; with a charger at 35 m it goes on: 5 J for the way.
    """
    far = work(10, at="q", uses={"energy_j": 60.0})
    made = mission([Part("a", "r", [far]), Part("b", "r", [far])], [("a", "b")])
    assert planned(made, battery()).status == "unknown"
    near = planned(made, battery(), chargers=(replace(PLUG, position=at(35)),))
    # 30 s of way, 10 s of work, 5 m to the charger with 5 J left; 60 J and 5 J for the way back are needed: 65 - 5 = 60 J in 6 s
    assert visits(near) == [("r-1", 45, 51, 60)]
    assert times(made, near) == {"a.0": (30, 40), "b.0": (56, 66)}


def test_whose_tour_is_known_takes_in_what_the_rest_of_it_asks_for() -> None:
    """
    20 J, a charger of 1 J/s at 0, and three glances: at 10, then at -4, then at -9, 1 m/s and 1 J/m.

    After the first 10 J are left, too few for 14 m, so the robot is back at 10 + 10 = 20 s with none. Enough for the next, and to come back
    to the charger, are 8 J, 8 s; from -4, at 32 s, it comes back with none, 36 s, needs 9 J for the last, and is there at 54 s. For the
    rest of the tour 9 J do: it is done at 20 + 9 + 9 = 38 s. Filled up, in 20 s, it is done at 49 s.
    """
    made = mission([Part(name, "r", [work(0, at=name)]) for name in "abc"], [("a", "b"), ("b", "c")])
    world = replace(scene(a=10, b=-4, c=-9), chargers=(Charger(id="plug", position=at(0), rate_per_s=1),))
    fleet = Fleet((battery(limits={"energy_j": 20.0, "max_speed_mps": 1.0}),))
    problem = read_problem(made.tree, made.alternative, fleet, world, Terms(chargers=world.chargers))
    assert isinstance(problem, Problem)
    course = Course(dict.fromkeys((0, 1, 2), "r-1"), {"r-1": [0, 1, 2]})
    ends = {}
    for filling in FILLINGS:
        draft = replay(problem, course, (filling,))
        assert draft is not None
        ends[filling] = draft.makespan
    assert ends == {"enough": 54_000, "rest": 38_000, "full": 49_000}
    best = replay(problem, course)
    assert best is not None
    assert best.makespan == 38_000


def test_chargers_in_a_row_carry_a_robot_far() -> None:
    """250 m with 100 J at 1 J/m: chargers at 90 and 180 m, each fills it up; 90 m, 9 s, 90 m, 9 s, 70 m."""
    chargers = (Charger(id="one", position=at(90), rate_per_s=10), Charger(id="two", position=at(180), rate_per_s=10))
    made = mission([Part("a", "r", [work(1, at="end")])])
    world = replace(scene(end=250), chargers=chargers)
    run = SCHEDULERS["greedy"]
    result = run(made.tree, made.alternative, Fleet((battery(),)), world, Control(), Terms(chargers=chargers))
    # at the second one it takes in what is missing of the 70 J: 10 J are left of the first filling
    assert visits(result) == [("r-1", 90, 99, 90), ("r-1", 189, 195, 60)]
    assert times(made, result) == {"a.0": (265, 266)}


def test_a_robot_that_goes_home_refills_for_the_way() -> None:
    """Work of 80 J at 10 m: 90 J of 100 J, and 10 m home: 10 J. It lasts. With 81 J it does not: 2 m before home there is the charger."""
    for uses, expected in ((80.0, []), (81.0, [("r-1", 28, 28.1, 1.0)])):
        made = mission([Part("a", "r", [work(10, at="p", uses={"energy_j": uses})])])
        world = replace(scene(p=10), chargers=(PLUG,))
        terms = Terms(chargers=(PLUG,), return_home=True)
        result = SCHEDULERS["greedy"](made.tree, made.alternative, Fleet((battery(),)), world, Control(), terms)
        assert visits(result) == expected
        assert [leg.destination.x_m for leg in result.returns] == [0]


def test_more_than_a_full_store_within_one_role_is_proven_impossible() -> None:
    made = mission([Part("a", "r", [work(10, at="p", uses={"energy_j": 101.0}, uses_at_least={"energy_j": 101.0})])])
    result = planned(made, battery())
    assert (result.status, result.certificate.method) == ("infeasible", "budget_bound")
    assert result.reasons[0].message == (
        "'a' uses at least 101 of energy_j, more than the 100 that a full robot of type 'r' holds, and nobody refills within a role."
    )


def test_a_place_too_far_from_every_charger_is_proven_impossible() -> None:
    """From the start 30 m, from the charger 28 m: at 4 J/m at least 112 J, more than 100 J."""
    made = mission([Part("a", "r", [work(1, at="q")])])
    result = planned(made, battery(uses_per_m={"energy_j": 4.0}))
    assert (result.status, result.reasons[0].rule) == ("infeasible", "budget_exceeded")
    assert "uses at least 112 of energy_j with the shortest way to it" in result.reasons[0].message


def test_a_charger_for_others_refills_nothing() -> None:
    """Two jobs of 60 J with 100 J, and a charger that serves another type: proven impossible, as it is without one."""
    job = work(10, at="p", uses={"energy_j": 60.0}, uses_at_least={"energy_j": 60.0})
    made = mission([Part("a", "r", [job]), Part("b", "r", [job])])
    result = planned(made, battery(), chargers=(replace(PLUG, types=("other",)),))
    assert (result.status, result.certificate.method) == ("infeasible", "budget_bound")
    assert planned(made, battery()).status == "feasible"


def test_refilling_keeps_to_when_a_robot_is_there() -> None:
    """As in the first test the second job ends at 26.4 s; a robot that leaves at 26 s does not get it done."""
    made = mission([Part("a", "r", [JOB]), Part("b", "r", [JOB])])
    assert planned(made, battery(available_until_s=26.4)).makespan_s == 26.4
    assert planned(made, battery(available_until_s=26)).status == "unknown"


def test_a_bound_counts_the_charger_as_a_place_to_come_from() -> None:
    """
    x may begin at 40 s, anywhere, and takes 20 J; y, afterwards and at 30 m, is reached from the start in 30 s, from a charger at 29 m
    in 1 s.

    With 29 J the robot gets to the charger, fills up before x, and is at y 1 s after it: 41 + 1 + 1 s. So no bound may claim the 30 s of
    way after x.
    """
    made = mission(
        [Part("x", "r", [work(1, uses={"energy_j": 20.0})]), Part("y", "r", [work(1, at="q")])], [("x", "y")]
    ).timed(x=(40, None))
    plug = replace(PLUG, position=at(29))
    low = battery(robots=(Robot(id="r1", position=at(0), remaining={"energy_j": 29.0}),))
    result = planned(made, low, chargers=(plug,))
    assert visits(result) == [("r1", 29, 39, 100)]
    assert (result.makespan_s, result.certificate.bound) == (43, 43)


def test_a_robot_that_may_wait_at_a_charger_is_left_to_the_quick_scheduler() -> None:
    """Two jobs that may be done anywhere, and return: the model says nothing of them, and the schedule says so."""
    made = mission(
        [Part("a", "r", [work(10, uses={"energy_j": 60.0})]), Part("b", "r", [work(10, uses={"energy_j": 60.0}), JOB])],
        [("a", "b")],
    )
    result = planned(made, battery(limits={"energy_j": 130.0}), scheduler="cpsat")
    assert result.status == "feasible"
    assert "Constraint programming was not asked: robots may refill while they wait" in result.certificate.detail


@pytest.mark.parametrize("index", CASES[:24])
def test_random_missions_with_chargers_keep_all_rules_and_claim_nothing_false(index: int) -> None:
    """Both checkers pass what is scheduled; with levels that last for ever nothing is shorter than what is called optimal."""
    assert judge(8, index).violations == ()
