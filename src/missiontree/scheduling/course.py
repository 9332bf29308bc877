"""What a schedule decides, times left out: who fills what, and in which order."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class Course:
    """
    The decisions of a schedule; :mod:`missiontree.scheduling.replay` makes a draft of them.

    Parameters
    ----------
    robots
        Robot of each role.
    tours
        Roles of each robot, in order.
    after_end, after_start
        Pairs of activities: the second starts no sooner than the first has ended, or has started.
    under_way
        For an open-ended activity, one of those that set its end, which ends later than it starts.
    """

    robots: Mapping[int, str]
    tours: Mapping[str, Sequence[int]]
    after_end: Sequence[tuple[int, int]] = ()
    after_start: Sequence[tuple[int, int]] = ()
    under_way: Mapping[int, int] = field(default_factory=dict)
