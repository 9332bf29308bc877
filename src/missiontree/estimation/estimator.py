"""The seam: what every estimator is."""

from __future__ import annotations

from typing import Protocol

from missiontree.mission.estimate import Estimate
from missiontree.mission.fleet import Capability


class Estimator(Protocol):
    """
    Says how well, how long and how dear one action of one robot type will be.

    Allocation ranks by what it says of an action with its travel. Schedules take from it how long the action itself goes on, by
    asking once more without travel; the travel of schedules is that of the map.
    """

    def estimate(
        self,
        capability: Capability,
        nominal_s: float | None,
        nominal_cost: float = 0.0,
        travel_m: float = 0.0,
        travel_s: float = 0.0,
        /,
        *,
        robot_type: str = "",
        action: str = "",
        rating: str = "",
        at: str = "",
    ) -> Estimate:
        """
        Estimate one action, as allocation will rank it. The same question gets the same answer.

        Parameters
        ----------
        capability
            What the type declares for the capability that rates the action.
        nominal_s
            Nominal duration in seconds, at least 0. None if the action is a move whose travel is known: then it is that
            travel and nothing else.
        nominal_cost
            Nominal cost, at least 0.
        travel_m
            Metres travelled for the action, at least 0, as far as they are known beforehand.
        travel_s
            Seconds of that travel, at least 0.
        robot_type
            Id of the type, for estimators that know more than its table of capabilities.
        action
            Name of the primitive action, likewise.
        rating
            Name of the capability that rates it, likewise.
        at
            Id of the entity or place where it is done, or that it goes to, likewise; empty if anywhere.
        """
        ...
