"""One number per robot type and capability, as in the paper's Table I, with the type's models of duration and cost."""

from __future__ import annotations

from missiontree.mission.estimate import Estimate
from missiontree.mission.fleet import Capability


def working_s(capability: Capability, nominal_s: float) -> float:
    """
    How long an action takes a type, in seconds, travel excluded: plus_s + scale * nominal_s.

    Parameters
    ----------
    capability
        What the type declares for the capability that rates the action.
    nominal_s
        The routine's duration of the action, at least 0.
    """
    return capability.duration.plus_s + capability.duration.scale * nominal_s


class TableEstimator:
    """
    The estimator of the paper: quality is the number in the table, whatever the action and wherever it is done.

    Duration is the working time (:func:`working_s`) plus the travel. Cost is
    nominal_cost + fixed + per_s * duration + per_m * travel_m.
    """

    def estimate(
        self,
        capability: Capability,
        nominal_s: float | None,
        nominal_cost: float = 0.0,
        travel_m: float = 0.0,
        travel_s: float = 0.0,
        *,
        robot_type: str = "",
        action: str = "",
        rating: str = "",
        at: str = "",
    ) -> Estimate:
        """Look the action up; see :meth:`missiontree.estimation.estimator.Estimator.estimate`. Who, what and where are not needed."""
        duration_s = travel_s + (0.0 if nominal_s is None else working_s(capability, nominal_s))
        model = capability.cost
        cost = nominal_cost + model.fixed + model.per_s * duration_s + model.per_m * travel_m
        return Estimate(capability.quality, duration_s, cost)
