"""A point on a floor."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.value import Id, Value


@dataclass(frozen=True, slots=True)
class Position(Value):
    """
    Where something is, in metres.

    Parameters
    ----------
    x_m, y_m
        Coordinates in the frame.
    floor
        Floor of the building, default ``ground``. Two floors are joined by lifts only.
    frame
        Frame of the coordinates, default ``map``; others are declared in the scene.
    """

    x_m: float
    y_m: float
    floor: Id = "ground"
    frame: Id = "map"
