"""A schedule of a tree in columns: which way was taken at every XOR, and which robot does what from when."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from missiontree.mission.certificate import Certificate

TreeScheduleStatus = Literal["optimal", "feasible", "infeasible", "unknown"]


@dataclass(frozen=True)
class TreeSchedule:
    """
    The choice and the times. Plain numbers, since trees in columns are large.

    Parameters
    ----------
    status
        ``optimal``: proven that no selection has a schedule of a smaller makespan; the certificate says by which method.
        ``feasible``: this one works; that nothing is shorter may be a solver's word.
        ``infeasible``: proven that no selection is complete. ``unknown``: none was found, none is excluded. With the last two, nothing
        is scheduled.
    certificate
        The bound on the makespan. ``proven``: the makespan meets one of missiontree's own, or a second method agrees. ``bounded``: no
        makespan is below ``bound``. ``solver_word``: the same by the word of a solver alone.
    chosen
        Child taken at every reached XOR.
    start_s
        Start of each selected leaf, in whole seconds.
    robot
        Of each selected leaf, which of the robots that its ``robot`` stands for does it, from 0.
    makespan_s
        End of the last action.
    """

    status: TreeScheduleStatus
    certificate: Certificate
    chosen: Mapping[int, int]
    start_s: Mapping[int, int]
    robot: Mapping[int, int]
    makespan_s: int
