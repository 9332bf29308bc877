"""Where robots refill what they use up: a charging station, a fuel pump, a tap."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.fleet import RobotType
from missiontree.mission.position import Position
from missiontree.mission.value import Count, Id, Positive, Value, require_unique


@dataclass(frozen=True, slots=True, kw_only=True)
class Charger(Value):
    """
    A place where robots refill one stock, between their roles.

    Parameters
    ----------
    id
        Name, unique among the chargers of a scene.
    place
        Place of the scene where it stands. Either this or ``position``.
    position
        Where it stands.
    rate_per_s
        How much of the stock it gives a robot in a second, above 0, in the stock's own unit: joules per second for ``energy_j``.
    stock
        What it refills: the limit of a robot type that its actions and its metres use up. Default ``energy_j``.
    types
        Robot types that may use it; None (default) means all.
    capacity
        How many robots may refill there at one time, at least 1, default 1.
    label
        Name shown to people; default: the id.
    """

    id: Id
    place: Id | None = None
    position: Position | None = None
    rate_per_s: Positive
    stock: Id = "energy_j"
    types: tuple[Id, ...] | None = None
    capacity: Count = 1
    label: str = ""

    def _check(self) -> None:
        if not self.label:
            object.__setattr__(self, "label", self.id)
        if (self.place is None) == (self.position is None):
            raise ValueError(f"charger {self.id!r} needs either a place or a position, and not both.")
        if self.stock == "max_speed_mps":
            raise ValueError(f"charger {self.id!r} refills max_speed_mps, which nothing uses up.")
        if self.types is not None:
            require_unique(f"robot type of charger {self.id!r}", self.types)

    def serves(self, robot_type: str) -> bool:
        """Whether robots of a type may use it."""
        return self.types is None or robot_type in self.types


def check_full(kind: RobotType, charger: Charger) -> None:
    """
    Refuse a robot that has more of a refilled stock than its type holds when it is full.

    Raises
    ------
    ValueError
        Naming the robot, what it has, and what is full.
    """
    full = kind.limits.get(charger.stock)
    for robot in kind.robots:
        level = robot.remaining.get(charger.stock)
        if level is not None and (full is None or level > full):
            raise ValueError(
                f"robot {robot.id!r} has {level:g} of {charger.stock}, which it can refill at charger {charger.id!r}; "
                + (
                    f"full is {full:g}, the limit of its type."
                    if full is not None
                    else "its type needs a limit of it: full."
                )
            )
