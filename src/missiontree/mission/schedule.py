"""Who does what from when to when, and the travel between."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from missiontree.mission.alternative import Assignment
from missiontree.mission.certificate import Certificate
from missiontree.mission.position import Position
from missiontree.mission.reason import Reason
from missiontree.mission.value import Count, Id, Index, NonNegative, Positive, Value

ScheduleStatus = Literal["optimal", "feasible", "infeasible", "unknown"]


@dataclass(frozen=True, slots=True, kw_only=True)
class ScheduledAction(Value):
    """
    An action with its robot and its time, in seconds on the grid of 1 ms.

    Parameters
    ----------
    leaf
        Index of the action in the grounded tree.
    robot
        Robot that does it.
    start_s, end_s
        From when to when; equal for an action that takes no time.
    """

    leaf: Index
    robot: Id
    start_s: NonNegative
    end_s: NonNegative

    def _check(self) -> None:
        if self.end_s < self.start_s:
            raise ValueError(f"action {self.leaf} ends at {self.end_s} s, before it starts at {self.start_s} s.")


@dataclass(frozen=True, slots=True, kw_only=True)
class TravelLeg(Value):
    """
    A robot on its way to an action. The leg of a move has the time of the move itself.

    Parameters
    ----------
    robot
        Robot that travels.
    leaf
        Action it travels for.
    start_s, end_s
        From when to when.
    origin, destination
        From where to where, in frame ``map``.
    distance_m
        Length of the way.
    via
        Road nodes passed, in order; empty off the road graph.
    """

    robot: Id
    leaf: Index
    start_s: NonNegative
    end_s: NonNegative
    origin: Position
    destination: Position
    distance_m: NonNegative
    via: tuple[Id, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class OwnLeg(Value):
    """
    A robot on its way for its own sake, not for an action: to a charger, or home after its last action.

    Parameters
    ----------
    robot
        Robot that travels.
    start_s, end_s
        From when to when.
    origin, destination
        From where to where, in frame ``map``.
    distance_m
        Length of the way.
    via
        Road nodes passed, in order; empty off the road graph.
    """

    robot: Id
    start_s: NonNegative
    end_s: NonNegative
    origin: Position
    destination: Position
    distance_m: NonNegative
    via: tuple[Id, ...] = ()

    def _check(self) -> None:
        if self.end_s < self.start_s:
            raise ValueError(f"the way of {self.robot} ends at {self.end_s} s, before it starts at {self.start_s} s.")


@dataclass(frozen=True, slots=True, kw_only=True)
class Recharge(Value):
    """
    A robot at a charger, between two of its roles, or before it goes home.

    Parameters
    ----------
    robot
        Robot that refills.
    charger
        Charger of the scene.
    start_s, end_s
        From when to when it refills; the second is later.
    amount
        How much of the charger's stock it takes in, above 0.
    leg
        The way there; None if the robot is there already.
    """

    robot: Id
    charger: Id
    start_s: NonNegative
    end_s: NonNegative
    amount: Positive
    leg: OwnLeg | None = None

    def _check(self) -> None:
        if self.end_s <= self.start_s:
            raise ValueError(f"{self.robot} refills at {self.charger} from {self.start_s} s to {self.end_s} s.")


Leg = TravelLeg | OwnLeg
"""A way that a robot travels, whatever for."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Schedule(Value):
    """
    The schedule of one alternative.

    Parameters
    ----------
    rank
        Rank of the alternative.
    status
        ``optimal``: the makespan is proven least. ``feasible``: it is one that works. ``infeasible``: proven that there is none.
        ``unknown``: none was found, none is excluded. With the last two, nothing is scheduled.
    certificate
        The bound on the makespan, and the method behind the status.
    assignments
        Robot of every reached role, in order of role index.
    actions
        Every selected action, by start, then by leaf.
    legs
        Travel, by start, then by leaf, then by robot.
    recharges
        Visits to chargers, by start, then by robot.
    returns
        Where robots return: the ways home, by start, then by robot. A robot that ends where it started has none.
    makespan_s
        End of the last action; where robots return, when the last of them is home, if that is later.
    assumptions
        What was unknown and taken for granted, such as where a robot starts.
    reasons
        Why there is no schedule.
    """

    rank: Count
    status: ScheduleStatus
    certificate: Certificate
    assignments: tuple[Assignment, ...] = ()
    actions: tuple[ScheduledAction, ...] = ()
    legs: tuple[TravelLeg, ...] = ()
    recharges: tuple[Recharge, ...] = ()
    returns: tuple[OwnLeg, ...] = ()
    makespan_s: NonNegative = 0.0
    assumptions: tuple[Reason, ...] = ()
    reasons: tuple[Reason, ...] = ()

    @property
    def ways(self) -> tuple[Leg, ...]:
        """Every way that is travelled, whatever for."""
        to_chargers = (recharge.leg for recharge in self.recharges if recharge.leg is not None)
        return (*self.legs, *to_chargers, *self.returns)
