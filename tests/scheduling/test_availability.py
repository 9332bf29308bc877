"""Robots that come late or leave early."""

from __future__ import annotations

import pytest
from hypothesis import HealthCheck, given, settings

from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet, Robot
from missiontree.scheduling.greedy import greedy
from tests.scheduling.brute_force import least_makespan
from tests.scheduling.instances import Instance, Part, at, mission, move, robots, scene, schedule, times, work
from tests.scheduling.strategies import fleets, instances, plane, shifts
from tests.scheduling.test_serial import stands_still
from tests.scheduling.validator import faults

SLOW = settings(max_examples=300, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)


@SLOW
@given(instances(), fleets().flatmap(shifts))
def test_claims_about_robots_that_come_and_go_agree_with_brute_force(instance: Instance, fleet: Fleet) -> None:
    """Nobody works before it comes or after it has left; bound <= optimum <= makespan; what is called infeasible is."""
    result = greedy(instance.tree, instance.alternative, fleet, plane(), Control())
    optimum = least_makespan(instance, fleet, plane())
    if result.status == "infeasible":
        assert optimum is None or (result.reasons[0].rule == "cycle" and stands_still(instance))
    elif result.status != "unknown":
        assert faults(instance, fleet, plane(), result) == []
        assert optimum is not None
        assert result.certificate.bound is not None
        assert round(result.certificate.bound * 1000) <= optimum <= round(result.makespan_s * 1000)
        assert result.status != "optimal" or round(result.makespan_s * 1000) == optimum


def test_a_robot_sets_out_when_it_comes() -> None:
    """From 5 s, 10 m at 2 m/s, 3 s: 10 to 13 s; as a move it starts at 5 s."""
    fleet = robots("r", 1, 2.0, position=at(0), available_from_s=5)
    made = mission([Part("a", "r", [work(3, at="p")])])
    result = schedule(made, fleet, world=scene(p=10))
    assert (times(made, result), result.status) == ({"a.0": (10, 13)}, "optimal")
    assert [(leg.start_s, leg.end_s) for leg in result.legs] == [(5, 10)]
    going = mission([Part("a", "r", [move("p")])])
    assert times(going, schedule(going, fleet, world=scene(p=10))) == {"a.0": (5, 10)}


def test_a_named_robots_own_times_go_before_its_types() -> None:
    """The type comes at 9 s; one of its robots is there from 2 s on."""
    two = robots("r", robots=(Robot(id="x"), Robot(id="y", available_from_s=2)), available_from_s=9)
    made = mission([Part("a", "r", [work(1)]), Part("b", "r", [work(4)])])
    result = schedule(made, two)
    assert max(end for _, end in times(made, result).values()) == 7


def test_who_leaves_too_early_is_passed_over() -> None:
    """Work of 5 s: x leaves at 4 s, y stays."""
    two = robots("r", robots=(Robot(id="x", available_until_s=4), Robot(id="y")))
    made = mission([Part("a", "r", [work(5)])])
    result = schedule(made, two)
    assert [one.robot for one in result.assignments] == ["y"]


def test_a_type_that_has_left_is_a_proof() -> None:
    made = mission([Part("a", "r", [work(5)])])
    result = schedule(made, robots("r", 2, available_until_s=4.999))
    assert (result.status, result.certificate.method) == ("infeasible", "deadline_bound")
    assert result.reasons[0].message == "'a.0' cannot end before 5 s, and the last robot of type r leaves at 4.999 s."
    assert schedule(made, robots("r", 2, available_until_s=5)).status == "optimal"


def test_who_leaves_too_early_for_the_second_of_two_is_named() -> None:
    """Two roles of 10 s for one robot that stays for 15 s: nobody is held, and yet the second finds nobody. Each alone would be done."""
    made = mission([Part("a", "r", [work(10)]), Part("b", "r", [work(10)])])
    result = schedule(made, robots("r", available_until_s=15))
    assert result.status == "infeasible"
    (reason,) = {one for one in result.reasons if one.rule == "robot_away"}
    assert reason.message == "'b.0' finds no robot that is there long enough: r-1 leaves at 15 s."


def test_a_robot_that_leaves_before_it_comes_is_refused() -> None:
    with pytest.raises(ValueError, match="robot 'x' is available from 5 s until 4 s"):
        Robot(id="x", available_from_s=5, available_until_s=4)
    with pytest.raises(ValueError, match="robot 'x' is available from 5 s until 4 s"):
        robots("r", robots=(Robot(id="x", available_until_s=4),), available_from_s=5)
