"""Chargers as schedulers see them: where each is, what it gives in a tick, and who can refill what."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.terms import Terms
from missiontree.mission.ticks import TICKS_PER_S

NOBODY: frozenset[str] = frozenset()


@dataclass(frozen=True, slots=True)
class Station:
    """
    A charger.

    Parameters
    ----------
    id, spot
        Charger and where it stands.
    stock
        What it refills.
    per_tick
        How much of it in a tick.
    capacity
        How many robots at one time.
    """

    id: str
    spot: Position
    stock: str
    per_tick: float
    capacity: int

    def lasts(self, amount: float) -> int:
        """Ticks that it takes to give so much, rounded up; noise of a millionth of a tick is none."""
        return max(1, math.ceil(amount / self.per_tick - 1e-6))


@dataclass(frozen=True)
class Chargers:
    """
    Who can refill what, where.

    Parameters
    ----------
    stations
        Chargers that the robots of a type may use for a limit that they have, by type; types without are left out.
    refilled
        Names of those limits, by type.
    """

    stations: Mapping[str, tuple[Station, ...]] = field(default_factory=dict)
    refilled: Mapping[str, frozenset[str]] = field(default_factory=dict)

    def __bool__(self) -> bool:
        return bool(self.stations)

    def of(self, kind: RobotType) -> frozenset[str]:
        """What robots of a type can refill."""
        return self.refilled.get(kind.id, NOBODY)


NO_CHARGERS = Chargers()


def chargers_of(fleet: Fleet, scene: Scene, terms: Terms) -> Chargers:
    """The chargers of a scene, for the types of a fleet."""
    if not terms.chargers:
        return NO_CHARGERS
    spots = scene.charger_spots
    refilled = {kind.id: terms.refilled(kind) for kind in fleet.types}
    stations = {
        kind.id: tuple(
            Station(one.id, spots[one.id], one.stock, one.rate_per_s / TICKS_PER_S, one.capacity)
            for one in terms.chargers
            if one.serves(kind.id) and one.stock in refilled[kind.id]
        )
        for kind in fleet.types
    }
    return Chargers(
        {name: own for name, own in stations.items() if own}, {name: own for name, own in refilled.items() if own}
    )
