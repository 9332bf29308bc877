"""Release times and deadlines: kept by schedules, proven out of reach only where they are."""

from __future__ import annotations

from hypothesis import HealthCheck, given, settings

from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet
from missiontree.scheduling.greedy import greedy
from tests.scheduling.brute_force import least_makespan
from tests.scheduling.instances import Instance
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
