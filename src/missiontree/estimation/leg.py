"""What a way comes to: a leg that can be travelled, or the reason why there is none."""

from __future__ import annotations

from dataclasses import dataclass, replace

from missiontree.mission.reason import Reason


@dataclass(frozen=True, slots=True)
class Leg:
    """
    A way from one point to another.

    Parameters
    ----------
    distance_m
        Length of the way in metres, at least 0.
    ride_s
        Seconds spent in lifts, at least 0, whatever the robot's speed. Default 0.
    via
        Road nodes passed, in order; empty off the road graph.
    """

    distance_m: float
    ride_s: float = 0.0
    via: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Blocked:
    """
    There is no way.

    Parameters
    ----------
    reason
        What cuts the destination off; its rule is ``unreachable``.
    """

    reason: Reason


STAY = Leg(0.0)
"""The leg of a robot that is there already."""


def unreachable(message: str, *, found: str = "", hint: str = "") -> Blocked:
    """No way, for the reason that the message states in a sentence."""
    return Blocked(Reason(rule="unreachable", message=message, found=found, hint=hint))


def for_robot(blocked: Blocked, robot: str) -> Blocked:
    """The same, said of one robot or robot type."""
    return Blocked(replace(blocked.reason, robot=robot))
