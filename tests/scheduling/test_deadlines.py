"""Release times and deadlines: kept by schedules, proven out of reach only where they are."""

from __future__ import annotations

from hypothesis import HealthCheck, given, settings

from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet
from missiontree.scheduling.greedy import greedy
from tests.scheduling.brute_force import least_makespan
from tests.scheduling.instances import Group, Instance, Part, at, mission, move, robots, scene, schedule, times, work
from tests.scheduling.strategies import fleets, instances, plane, timed
from tests.scheduling.test_serial import stands_still
from tests.scheduling.validator import faults

SLOW = settings(max_examples=400, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)


@SLOW
@given(instances().flatmap(timed), fleets())
def test_claims_under_times_agree_with_brute_force(instance: Instance, fleet: Fleet) -> None:
    """Schedules keep all times; bound <= optimum <= makespan; what is called infeasible is."""
    result = greedy(instance.tree, instance.alternative, fleet, plane(), Control())
    optimum = least_makespan(instance, fleet, plane())
    if result.status == "infeasible":
        assert optimum is None or (result.reasons[0].rule == "cycle" and stands_still(instance))
    elif result.status != "unknown":  # a late try proves nothing
        assert faults(instance, fleet, plane(), result) == []
        assert optimum is not None
        assert result.certificate.bound is not None
        assert round(result.certificate.bound * 1000) <= optimum <= round(result.makespan_s * 1000)
        assert result.status != "optimal" or round(result.makespan_s * 1000) == optimum


def test_nothing_below_a_node_starts_before_its_release_time() -> None:
    """Two roles of 2 s below a group from 5 s, one of 1 s beside it: 0-1 and twice 5-7; the bound is 7."""
    made = mission([Group("G", [Part("a", "r", [work(2)]), Part("b", "r", [work(2)])]), Part("c", "r", [work(1)])])
    result = schedule(made.timed(G=(5, None)), robots("r", 3))
    assert times(made, result) == {"a.0": (5, 7), "b.0": (5, 7), "c.0": (0, 1)}
    assert (result.status, result.certificate.bound) == ("optimal", 7)


def test_a_robot_may_be_on_its_way_before_the_release_time() -> None:
    """10 m at 1 m/s, from the start: there at 10 s, and waits until 12 s."""
    made = mission([Part("a", "r", [work(3, at="p")])]).timed(a=(12, None))
    result = schedule(made, robots("r", 1, 1.0, position=at(0)), world=scene(p=10))
    assert times(made, result) == {"a.0": (12, 15)}
    assert [(leg.start_s, leg.end_s) for leg in result.legs] == [(0, 10)]


def test_a_move_is_an_action_and_waits_for_its_release_time() -> None:
    made = mission([Part("a", "r", [move("p")])]).timed(a=(12, None))
    assert times(made, schedule(made, robots("r", 1, 1.0, position=at(0)), world=scene(p=10))) == {"a.0": (12, 22)}


def test_what_is_due_first_goes_first() -> None:
    """One robot, 5 s and 3 s: the longer would go first by the way still to go, and the shorter is due by 4 s."""
    made = mission([Part("a", "r", [work(5)]), Part("b", "r", [work(3)])])
    assert times(made, schedule(made, robots("r")))["a.0"] == (0, 5)
    assert times(made, schedule(made.timed(b=(0, 4)), robots("r"))) == {"a.0": (3, 8), "b.0": (0, 3)}


def test_a_robot_waits_for_what_is_due_first_and_not_released_yet() -> None:
    """a, 5 s, would begin at once; b, 3 s, from 2 s until 5 s, has no other robot."""
    made = mission([Part("a", "r", [work(5)]), Part("b", "r", [work(3)])]).timed(b=(2, 5))
    assert times(made, schedule(made, robots("r"))) == {"a.0": (5, 10), "b.0": (2, 5)}


def test_the_chain_that_misses_a_deadline_is_told() -> None:
    """From 4 s on 3 + 10 m at 2 m/s + 6 s: 18 s at the earliest, 1.5 s after the deadline of the group."""
    steps = [work(3, at="p"), work(6, at="q")]
    made = mission([Group("G", [Part("a", "r", steps)])]).timed(G=(0, 16.5), a_0=(4, None))
    result = schedule(made, robots("r", 1, 2.0, position=at(0)), world=scene(p=0, q=10))
    assert (result.status, result.certificate.method) == ("infeasible", "deadline_bound")
    (reason,) = result.reasons
    assert reason.message == (
        "'G' must end by 16.5 s, and cannot before 18 s: nothing before 4 s, then 'a.0' 3 s, then 'a.1' 5 s on the way and 6 s."
    )
    assert (reason.rule, reason.node, reason.found, reason.needed) == ("deadline_missed", "G", "18 s", "by 16.5 s")
    assert reason.hint.startswith("Move the deadline by 1.5 s or more")


def test_too_much_work_for_the_robots_in_a_span_is_a_proof() -> None:
    """Three roles of 4 s between 2 s and 7 s: 12 s of work, and two robots have 10 s. Each alone would be in time."""
    made = mission([Group("G", [Part(name, "r", [work(4)]) for name in "abc"])]).timed(G=(2, 7))
    result = schedule(made, robots("r", 2))
    assert (result.status, result.certificate.method) == ("infeasible", "deadline_bound")
    assert "'a', 'b', 'c' need 12 s of robots' time; 2 robots of type r have 10 s" in result.reasons[0].message
    assert schedule(made, robots("r", 3)).status == "optimal"


def test_a_late_try_is_no_proof_but_trying_everything_is() -> None:
    """
    Two roles of 3 s by one robot that starts in the middle, 5 m from each: 5 + 3 + 10 + 3 = 21 s whichever goes first.

    The longest path is 8 s, and the load 5 + 3 + 5 + 3 = 16 s, with the least way into each place: so of 20 s no bound proves anything.
    """
    made = mission([Part("a", "r", [work(3, at="p")]), Part("b", "r", [work(3, at="q")])]).timed(root=(0, 20))
    result = schedule(made, robots("r", 1, 1.0, position=at(0)), world=scene(p=5, q=-5))
    assert (result.status, result.certificate.method) == ("infeasible", "enumeration")
    assert [reason.rule for reason in result.reasons] == ["no_schedule", "deadline_missed"]
    assert result.reasons[1].message == "The mission must end by 20 s; the best try ended with 'b.0' at 21 s."
    assert (
        schedule(made.timed(root=(0, 21)), robots("r", 1, 1.0, position=at(0)), world=scene(p=5, q=-5)).makespan_s == 21
    )


def test_joint_work_starts_with_the_last_release_and_ends_by_the_first_deadline() -> None:
    made = mission([Part("a", "r", [work(2, sync=0)]), Part("b", "r", [work(3, sync=0)])])
    both = schedule(made.timed(a=(4, None), b=(0, 7)), robots("r", 2))
    assert times(made, both) == {"a.0": (4, 7), "b.0": (4, 7)}
    assert schedule(made.timed(a=(4.5, None), b=(0, 7)), robots("r", 2)).status == "infeasible"


def test_a_deadline_of_a_tick_less_is_missed() -> None:
    made = mission([Part("a", "r", [work(2)])])
    assert schedule(made.timed(a=(0, 2)), robots("r")).status == "optimal"
    assert schedule(made.timed(a=(0, 1.999)), robots("r")).status == "infeasible"
