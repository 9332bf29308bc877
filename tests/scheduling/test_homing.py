"""Robots that go home: the way back counts, is paid for, and is proven impossible where it is."""

from __future__ import annotations

from typing import Any

import pytest

from benchmarks.campaign import luck
from benchmarks.schedule_cases import ScheduleCase, random_schedule_case
from benchmarks.schedule_oracle import TooMuchError, least_makespan
from missiontree.mission.control import Control
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.mission.terms import Terms
from missiontree.mission.ways import Road, RoadGraph, RoadNode
from missiontree.scheduling import SCHEDULERS
from missiontree.scheduling.enumeration.trying import Trying
from missiontree.scheduling.greedy import read_problem
from missiontree.scheduling.horizon import horizon_of
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.replay import replay
from tests.scheduling.instances import Instance, Part, at, mission, move, robots, scene, work

HOME = Terms(return_home=True)
HOME_CASES = [
    index for index in range(200) if {"home", "chargers"} & random_schedule_case(luck(3, index)).features == {"home"}
]


def home(
    made: Instance, *types: RobotType, world: Scene | None = None, scheduler: str = "greedy", **terms: Any
) -> Schedule:
    """The schedule of an instance whose robots go home."""
    asked = Terms(return_home=True, **terms)
    run = SCHEDULERS[scheduler]
    return run(made.tree, made.alternative, Fleet(types), world or scene(p=10, q=4), Control(), asked)


@pytest.mark.parametrize("scheduler", ["greedy", "cpsat"])
def test_the_makespan_ends_at_home(scheduler: str) -> None:
    """10 m at 2 m/s, 3 s of work, 10 m back: 5 + 3 + 5 s, which a chain of these proves."""
    made = mission([Part("a", "r", [work(3, at="p")])])
    result = home(made, robots("r", 1, 2.0, position=at(0)), scheduler=scheduler)
    assert (result.makespan_s, result.status, result.certificate.bound) == (13, "optimal", 13)
    assert [(leg.robot, leg.start_s, leg.end_s, leg.distance_m) for leg in result.returns] == [("r-1", 8, 13, 10)]


@pytest.mark.parametrize("scheduler", ["greedy", "cpsat"])
def test_who_ends_at_home_or_does_nothing_has_no_way_home(scheduler: str) -> None:
    """One goes to p and back to where it started, as its own last move; its twin stands idle."""
    made = mission([Part("a", "r", [move("p"), move("start")])])
    result = home(made, robots("r", 2, 2.0, position=at(0)), world=scene(p=10, start=0), scheduler=scheduler)
    assert (result.makespan_s, result.returns) == (10, ())


def test_the_order_of_roles_counts_the_way_home() -> None:
    """One robot at 0, a second of work at 4 and at 10, nobody else: out 10 m and home 10 m, 20 + 2 s, whichever comes first."""
    made = mission([Part("a", "r", [work(1, at="p")]), Part("b", "r", [work(1, at="q")])])
    result = home(made, robots("r", 1, 1.0, position=at(0)), scheduler="cpsat")
    assert (result.makespan_s, result.status) == (22, "optimal")


def test_each_robot_goes_to_its_own_start() -> None:
    """x at 0 and y at 20: work of 6 s at 10 and at 4 m. x to q: 4 + 6 + 4; y to p: 10 + 6 + 10 = 26 s."""
    two = robots("r", speed=1.0, robots=(Robot(id="x", position=at(0)), Robot(id="y", position=at(20))))
    made = mission([Part("a", "r", [work(6, at="p")]), Part("b", "r", [work(6, at="q")])])
    result = home(made, two, scheduler="cpsat")
    assert (result.makespan_s, result.status) == (26, "optimal")
    assert {leg.robot: (leg.origin.x_m, leg.destination.x_m) for leg in result.returns} == {"x": (4, 0), "y": (10, 20)}


@pytest.mark.parametrize(("energy", "status"), [(20.0, "optimal"), (19.9, "infeasible")])
def test_energy_must_last_for_the_way_home(energy: float, status: str) -> None:
    """10 m out and 10 m back at 1 J/m: 20 J are enough, less are proven too few."""
    made = mission([Part("a", "r", [work(3, at="p")])])
    kind = robots("r", 1, 1.0, position=at(0), limits={"energy_j": energy}, uses_per_m={"energy_j": 1.0})
    result = home(made, kind)
    assert result.status == status
    if status == "infeasible":
        assert result.certificate.method == "budget_bound"
        assert result.reasons[0].message == (
            "No robot of type 'r' can get to p, do its part there and come home: that takes at least 20 of energy_j, and the "
            "nearest to it has 19.9."
        )


def test_a_robot_is_home_before_it_leaves() -> None:
    """13 s with the way home, 8 without: who leaves at 12 s is passed over, and if nobody stays that is a proof."""
    made = mission([Part("a", "r", [work(3, at="p")])])
    two = (Robot(id="x", position=at(0), available_until_s=12), Robot(id="y", position=at(0)))
    result = home(made, robots("r", speed=2.0, robots=two))
    assert [one.robot for one in result.assignments] == ["y"]
    alone = home(made, robots("r", speed=2.0, robots=two[:1]))
    assert (alone.status, alone.certificate.method) == ("infeasible", "deadline_bound")
    assert alone.reasons[0].message == (
        "After 'a.0' nobody can be home before 13 s, and the last robot of type r leaves at 12 s."
    )


def test_all_must_be_home_by_the_missions_deadline() -> None:
    made = mission([Part("a", "r", [work(3, at="p")])])
    kind = robots("r", 1, 2.0, position=at(0))
    late = home(made, kind, home_by_s=12.9)
    assert (late.status, late.certificate.method) == ("infeasible", "deadline_bound")
    assert late.reasons[0].message == "All robots must be home by 12.9 s, and cannot before 13 s."
    assert home(made, kind, home_by_s=13).status == "optimal"


def test_a_one_way_road_is_no_way_home() -> None:
    """The road leads to p and not back: proven, and told."""
    world = Scene(
        places=(Entity(id="p", kind="place", position=Position(10, 0)),),
        roads=RoadGraph(
            nodes=(RoadNode(id="n", position=Position(0, 0)),), roads=(Road(ends=("n", "p"), one_way=True),)
        ),
    )
    made = mission([Part("a", "r", [work(3, at="p")])])
    result = home(made, robots("r", 1, 1.0, position=at(0)), world=world)
    assert (result.status, result.certificate.method) == ("infeasible", "reachability")
    assert result.reasons[0].rule == "no_way_home"


def test_an_unknown_home_is_an_assumption() -> None:
    made = mission([Part("a", "r", [work(3, at="p")])])
    result = home(made, robots("r", 1, 1.0))
    assert (result.makespan_s, result.returns) == (3, ())
    assert {one.rule for one in result.assumptions} == {"start_unknown", "home_unknown"}


def claims(case: ScheduleCase, result: Schedule, truth: int | None) -> None:
    """What a schedule says is true: bound <= least <= makespan, optimal is least, and infeasible is."""
    if result.status == "infeasible":
        assert truth is None
    elif result.status != "unknown":
        assert truth is not None
        assert result.certificate.bound is not None
        assert round(result.certificate.bound * 1000) <= truth <= round(result.makespan_s * 1000)
        assert result.status != "optimal" or round(result.makespan_s * 1000) == truth


@pytest.mark.parametrize("index", HOME_CASES[:40])
def test_random_missions_agree_with_an_oracle(index: int) -> None:
    """The quick scheduler's claims, and everything tried out, against an oracle of its own; some twelve with cpsat, too."""
    case = random_schedule_case(luck(3, index))
    try:
        truth = least_makespan(case)
    except TooMuchError:
        return
    names = ("greedy", "cpsat") if index % 4 == 0 else ("greedy",)
    for name in names:
        claims(
            case, SCHEDULERS[name](case.tree, case.alternative, case.fleet, case.scene, Control(), case.terms), truth
        )
    problem = read_problem(case.tree, case.alternative, case.fleet, case.scene, case.terms)
    if isinstance(problem, Problem):
        horizon = horizon_of(problem)
        assert truth is None or truth <= horizon
        tried = Trying(problem, horizon, 20_000, lambda: False)()
        draft = None if tried.course is None else replay(problem, tried.course)
        assert not tried.complete or (None if draft is None else draft.makespan) == truth
