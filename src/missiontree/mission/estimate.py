"""What it takes a robot to do one action: how well, how long, how dear."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.value import NonNegative, Value

MICRO = 1_000_000


@dataclass(frozen=True, slots=True)
class Estimate(Value):
    """
    Expected outcome of one robot performing one primitive action (the TAEMS triple of the paper, section III-A).

    Parameters
    ----------
    quality
        How well it will be done; no unit, at least 0, higher is better.
    duration_s
        How long it will take, in seconds, at least 0, an approach from the type's nearest robot included.
    cost
        What it costs, in the fleet's own unit, at least 0.
    """

    quality: NonNegative
    duration_s: NonNegative = 0.0
    cost: NonNegative = 0.0


@dataclass(frozen=True, slots=True)
class Weights(Value):
    """
    How quality, duration and cost make one utility: u = alpha * q - beta * d - gamma * c (the paper, equation 1).

    Parameters
    ----------
    alpha
        Weight of quality, default 1.
    beta
        Weight of a second, default 0.
    gamma
        Weight of a unit of cost, default 0.
    """

    alpha: NonNegative = 1.0
    beta: NonNegative = 0.0
    gamma: NonNegative = 0.0

    def utility_micro(self, estimate: Estimate) -> int:
        """
        Utility of one action, in millionths, rounded half to even.

        Rounding each action once makes every sum exact, so that ranks never hang on the order of additions.
        """
        value = self.alpha * estimate.quality - self.beta * estimate.duration_s - self.gamma * estimate.cost
        return round(value * MICRO)
