"""Numbers so large that two utilities could no longer be told apart."""

from __future__ import annotations

from missiontree.mission.estimate import Estimate, Weights
from missiontree.mission.fleet import Capability, Fleet
from missiontree.mission.routine import RoutineLibrary

MOST = 1e9


def refuse_huge(fleet: Fleet, routines: RoutineLibrary, weights: Weights) -> None:
    """
    Refuse numbers with which one action could count for more than a thousand million units of utility, travel aside.

    Utilities are sums of millionths, written as floating-point numbers. Up to 2^53 millionths, about nine thousand million
    units, every sum has a number of its own; beyond it, alternatives that differ would look equal.

    Raises
    ------
    ValueError
        With the robot type and the capability.
    """
    steps = [
        step
        for routine in routines.routines
        for branch in routine.branches
        for role in branch.roles
        for step in role.actions
    ]
    longest_s = max((step.duration_s for step in steps), default=0.0)
    dearest = max((step.cost for step in steps), default=0.0)
    for robot_type in fleet.types:
        for name in robot_type.capabilities:
            capability = robot_type.capability(name)
            if capability is not None and not _counts(capability, longest_s, dearest, weights) <= MOST:
                raise ValueError(
                    f"capability {name!r} of robot type {robot_type.id!r} counts for more than {MOST:,.0f} in one action: "
                    "its quality, its duration or its cost, or a weight, is too large."
                )


def counts_too_much(estimate: Estimate, weights: Weights) -> bool:
    """Whether an action could count for more than that, whatever the sign of its parts."""
    parts = (
        weights.alpha * estimate.quality,
        weights.beta * estimate.duration_s,
        weights.gamma * estimate.cost,
    )
    return not sum(parts) <= MOST


def _counts(capability: Capability, longest_s: float, dearest: float, weights: Weights) -> float:
    """The most that an action may count for, whatever the sign of its parts."""
    duration_s = capability.duration.plus_s + capability.duration.scale * longest_s
    cost = dearest + capability.cost.fixed + capability.cost.per_s * duration_s
    return weights.alpha * capability.quality + weights.beta * duration_s + weights.gamma * cost
