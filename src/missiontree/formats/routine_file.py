"""What a file of routines holds: the writer's own ones; what they are composed of may stand elsewhere."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.routine import Routine
from missiontree.mission.value import Value, require_unique


@dataclass(frozen=True, kw_only=True)
class RoutineFile(Value):
    """
    Routines of one file. Those that parts name may be built in or stand in other files.

    Parameters
    ----------
    routines
        At least one routine.
    """

    routines: tuple[Routine, ...]

    def _check(self) -> None:
        if not self.routines:
            raise ValueError("a file of routines needs at least one routine.")
        require_unique("routine", tuple(routine.id for routine in self.routines))
