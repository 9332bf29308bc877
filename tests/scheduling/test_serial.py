"""Every schedule keeps all rules, and no claim goes beyond what brute force confirms."""

from __future__ import annotations

from hypothesis import HealthCheck, given, settings

from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet
from missiontree.scheduling.greedy import greedy
from tests.scheduling.brute_force import least_makespan
from tests.scheduling.instances import Instance, Part, mission, robots, schedule, work
from tests.scheduling.strategies import fleets, instances, plane
from tests.scheduling.validator import faults

SLOW = settings(max_examples=150, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)


def stands_still(instance: Instance) -> bool:
    """Whether some action may take no time; cycles through such actions are refused though clocks could keep them."""
    actions = (node.action for node in instance.tree.nodes)
    return any(action is not None and action.moves for action in actions)


@SLOW
@given(instances(), fleets())
def test_claims_agree_with_brute_force(instance: Instance, fleet: Fleet) -> None:
    """The schedule is valid; bound <= optimum <= makespan; "optimal" is, and "infeasible" is too."""
    result = greedy(instance.tree, instance.alternative, fleet, plane(), Control())
    optimum = least_makespan(instance, fleet, plane())
    if result.status == "infeasible":
        assert optimum is None or (result.reasons[0].rule == "cycle" and stands_still(instance))
    elif result.status == "unknown":
        assert optimum is None  # at this size every binding is tried, nothing is missed
    else:
        assert faults(instance, fleet, plane(), result) == []
        assert optimum is not None
        assert result.certificate.bound is not None
        assert round(result.certificate.bound * 1000) <= optimum <= round(result.makespan_s * 1000)
        assert (result.status == "optimal") == (result.certificate.claim == "proven")
        assert result.status != "optimal" or round(result.makespan_s * 1000) == optimum


@SLOW
@given(instances(max_parts=5, things=True), fleets(budgets=True))
def test_schedules_with_moved_things_and_budgets_keep_all_rules(instance: Instance, fleet: Fleet) -> None:
    result = greedy(instance.tree, instance.alternative, fleet, plane(), Control())
    if result.status in ("optimal", "feasible"):
        assert faults(instance, fleet, plane(), result) == []
    else:
        assert result.reasons


def test_thousands_of_roles_wait_for_few_robots() -> None:
    """3,000 roles of 1, 2, 3 s in turn: 6,000 s of work for 4 robots is 1,500 s each, and a list schedule keeps them busy."""
    made = mission([Part(f"a{number}", "r", [work(number % 3 + 1)]) for number in range(3000)])
    result = schedule(made, robots("r", 4))
    assert (result.makespan_s, result.status, result.certificate.method) == (1500, "optimal", "load")


def test_ten_thousand_robots_are_no_trouble() -> None:
    """Each of 100 roles gets a robot of its own at once."""
    made = mission([Part(f"a{number}", "r", [work(1), work(2)]) for number in range(100)])
    result = schedule(made, robots("r", 10_000))
    assert (result.makespan_s, result.status) == (3, "optimal")
    assert len({one.robot for one in result.assignments}) == 100
