"""When robots are busy, and the first gap that is long enough."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence

Fit = tuple[int, int]


class Timeline:
    """
    Spans of time in which the robots of every type are busy.

    Parameters
    ----------
    count
        How many robots of each type there are.
    """

    def __init__(self, count: Sequence[int]) -> None:
        self._starts: list[list[list[int]]] = [[[] for _ in range(robots)] for robots in count]
        self._ends: list[list[list[int]]] = [[[] for _ in range(robots)] for robots in count]

    def fit(self, kind: int, ready: int, duration: int) -> Fit:
        """Earliest start at or after ``ready``, and the robot that is free for so long. What takes no time waits for nobody."""
        if not duration:
            return ready, 0
        best, chosen = -1, 0
        for robot, (starts, ends) in enumerate(zip(self._starts[kind], self._ends[kind], strict=True)):
            if not ends or ends[-1] <= ready:
                return ready, robot
            place = bisect_right(ends, ready)  # the first span that ends later
            start = ready
            for at in range(place, len(starts)):
                if starts[at] - start >= duration:
                    break
                start = ends[at]
            if best < 0 or start < best:
                best, chosen = start, robot
                if start == ready:
                    break
        return best, chosen

    def take(self, kind: int, robot: int, start: int, duration: int) -> None:
        """Make a robot busy from ``start`` on; an action that takes no time takes no robot's time either."""
        if duration:
            starts, ends = self._starts[kind][robot], self._ends[kind][robot]
            place = bisect_right(starts, start)
            starts.insert(place, start)
            ends.insert(place, start + duration)
