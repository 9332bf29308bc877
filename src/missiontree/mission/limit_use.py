"""What an alternative uses of a limit, by what allocation knows."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from missiontree.mission.value import Id, NonNegative, Value

Whose = Literal["robot", "robots", "type", "mission", "stock"]


@dataclass(frozen=True, slots=True)
class LimitUse(Value):
    """
    A limit beside what is used of it, both in the limit's own unit.

    What is used is a lower bound: it holds whatever the schedule. An approach counts 0.

    Parameters
    ----------
    whose
        ``robot``: what one robot may use. ``robots``: what the robots of a type may use each, added up, where no witness says who
        does what. ``type``: the total of a robot type. ``mission``: the total of the fleet. ``stock``: what the scene holds. Where
        both the fleet and the scene limit one budget, the tighter is told.
    who
        Id of the robot, or of the type; empty for the mission and the stock.
    name
        Name of the budget, its unit at the end.
    used
        At least 0.
    limit
        How much may be used, at least 0.
    """

    whose: Whose
    who: str
    name: Id
    used: NonNegative
    limit: NonNegative

    @property
    def share(self) -> float:
        """Used of what may be used; 1 for something of nothing."""
        return self.used / self.limit if self.limit else float(self.used > 0)
