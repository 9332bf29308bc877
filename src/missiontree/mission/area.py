"""Parts of the ground with rules of their own."""

from __future__ import annotations

import math
from dataclasses import dataclass

from missiontree.mission.position import Position
from missiontree.mission.value import Id, Value

Corner = tuple[float, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class Area(Value):
    """
    A polygon on one floor.

    Parameters
    ----------
    corners
        At least three (x, y) pairs in metres, in order along the edge, in frame ``map``.
    floor
        Floor, default ``ground``.
    """

    corners: tuple[Corner, ...]
    floor: Id = "ground"

    def _check(self) -> None:
        if len(self.corners) < 3:
            raise ValueError(f"an area needs at least 3 corners, got {len(self.corners)}.")
        if not all(math.isfinite(number) for corner in self.corners for number in corner):
            raise ValueError("corners must be finite numbers.")

    @property
    def middle(self) -> Position:
        """Mean of the corners."""
        count = len(self.corners)
        return Position(
            sum(x for x, _ in self.corners) / count, sum(y for _, y in self.corners) / count, floor=self.floor
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class Zone(Value):
    """
    A part of the scene that robot types may be allowed in or kept out of.

    Parameters
    ----------
    id
        Name of the zone.
    area
        Its extent; None if entities and roads name the zone themselves.
    """

    id: Id
    area: Area | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class KeepOut(Value):
    """
    An area that robots do not enter.

    Parameters
    ----------
    id
        Name of the keep-out.
    area
        Its extent; the edge itself may be touched.
    types
        Robot types it holds for; None (default) means all.
    """

    id: Id
    area: Area
    types: tuple[Id, ...] | None = None
