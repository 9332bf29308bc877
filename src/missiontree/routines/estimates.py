"""What an estimator says of the actions of a role, with the travel of a robot type."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from missiontree.estimation.estimator import Estimator
from missiontree.mission.entity import Entity
from missiontree.mission.estimate import Estimate
from missiontree.mission.fleet import RobotType
from missiontree.routines.compose import FlatAction
from missiontree.routines.itinerary import Travel


class Said(NamedTuple):
    """
    What is said of one action.

    Parameters
    ----------
    estimate
        Quality, duration and cost with the travel that is known beforehand.
    alone_s
        Duration without travel; of a move, what it takes when positions are unknown.
    """

    estimate: Estimate
    alone_s: float


def said_of(
    flat: FlatAction, robot_type: RobotType, travel: Travel, entities: Mapping[str, Entity], estimator: Estimator
) -> Said:
    """Ask for one action, with its travel and without."""
    step = flat.step
    capability = robot_type.capability(flat.rating)
    assert capability is not None, "a type in a role has its ratings"
    target = step.goes_to or step.at
    at = "" if target is None else entities[target].id

    def asked(nominal_s: float | None, travel_m: float, travel_s: float) -> Estimate:
        return estimator.estimate(
            capability,
            nominal_s,
            step.cost,
            travel_m,
            travel_s,
            robot_type=robot_type.id,
            action=step.name,
            rating=flat.rating,
            at=at,
        )

    only_travel = step.goes_to is not None and travel.duration_s is not None
    whole = asked(None if only_travel else step.duration_s, travel.distance_m, travel.duration_s or 0.0)
    if not (only_travel or travel.distance_m or travel.duration_s):
        return Said(whole, whole.duration_s)
    return Said(whole, asked(step.duration_s, 0.0, 0.0).duration_s)


def qualities(
    actions: Sequence[FlatAction],
    robot_type: RobotType,
    travels: Sequence[Travel],
    entities: Mapping[str, Entity],
    estimator: Estimator,
) -> tuple[float, ...]:
    """Quality of every action of a role."""
    return tuple(
        said_of(flat, robot_type, travel, entities, estimator).estimate.quality
        for flat, travel in zip(actions, travels, strict=True)
    )
