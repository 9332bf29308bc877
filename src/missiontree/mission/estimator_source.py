"""Estimates that are not the fleet's: whose they are, what was asked, and what was said."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.estimate import Estimate
from missiontree.mission.value import Id, NonNegative, Value


@dataclass(frozen=True, slots=True, kw_only=True)
class EstimatorSource(Value):
    """
    An estimator of the user's own.

    Parameters
    ----------
    name
        Name of its file, without folders, or what it is called in Python.
    digest
        SHA-256 of the file, in hexadecimal; empty for a Python object.
    """

    name: str
    digest: str = ""

    @property
    def shown(self) -> str:
        """As a sentence names it."""
        return f"{self.name} (SHA-256 {self.digest:.12}…)" if self.digest else f"the Python object {self.name}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Estimated(Value):
    """
    One answer of a user's own estimator. With all of them a plan can be checked, and made again, where the estimator is not.

    Parameters
    ----------
    robot_type
        Type that would do the action.
    action
        Name of the primitive action.
    rating
        Capability that rates it.
    at
        Entity or place where it is done, or that it goes to; None if anywhere.
    nominal_s
        Nominal duration in seconds; None for a move whose travel is known.
    nominal_cost
        Nominal cost.
    travel_m, travel_s
        Metres and seconds of travel for the action, as far as they are known beforehand.
    estimate
        What was said.
    """

    robot_type: Id
    action: Id
    rating: Id
    at: Id | None = None
    nominal_s: NonNegative | None = None
    nominal_cost: NonNegative = 0.0
    travel_m: NonNegative = 0.0
    travel_s: NonNegative = 0.0
    estimate: Estimate
