"""The quickest approach among many starts, without asking for the way from each."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Callable, Iterable, Iterator

from missiontree.estimation.leg import Leg
from missiontree.estimation.travel import Blocked, travel_time_s
from missiontree.mission.position import Position

FindLeg = Callable[[Position], Leg | Blocked]


class Starts:
    """
    Positions to start from, sorted by x on each floor.

    Parameters
    ----------
    positions
        Any number, in frame ``map``.
    """

    def __init__(self, positions: Iterable[Position]) -> None:
        self._floors: dict[str, list[Position]] = {}
        for position in sorted(dict.fromkeys(positions), key=lambda each: (each.x_m, each.y_m)):
            self._floors.setdefault(position.floor, []).append(position)

    def quickest(self, target: Position, find_leg: FindLeg, speed_mps: float) -> Leg | Blocked | None:
        """
        The leg that takes least time, then is shortest; what blocks the way if every start is blocked; None without starts.

        Starts farther off in a straight line than the best way found cannot do better and are skipped. Lifts and roads that are
        declared shorter than the straight line can break that; the result is then still a way, if not the quickest.
        """
        best: Leg | Blocked | None = None
        limit_s = math.inf
        floors = sorted(self._floors, key=lambda floor: (floor != target.floor, floor))
        for floor in floors:
            for along_x_m, start in self._outwards(floor, target):
                if along_x_m / speed_mps > limit_s:
                    break
                if math.hypot(start.x_m - target.x_m, start.y_m - target.y_m) / speed_mps > limit_s:
                    continue
                leg = find_leg(start)
                if isinstance(leg, Blocked):
                    best = best or leg
                elif not isinstance(best, Leg) or _key(leg, speed_mps) < _key(best, speed_mps):
                    best, limit_s = leg, travel_time_s(leg, speed_mps)
        return best

    def _outwards(self, floor: str, target: Position) -> Iterator[tuple[float, Position]]:
        """Starts on a floor, with their distance from the target along x, by that distance."""
        starts = self._floors[floor]
        right = bisect_left(starts, target.x_m, key=lambda each: each.x_m)
        left = right - 1
        while left >= 0 or right < len(starts):
            left_m = target.x_m - starts[left].x_m if left >= 0 else math.inf
            right_m = starts[right].x_m - target.x_m if right < len(starts) else math.inf
            if left_m < right_m:
                yield left_m, starts[left]
                left -= 1
            else:
                yield right_m, starts[right]
                right += 1


def _key(leg: Leg, speed_mps: float) -> tuple[float, float]:
    return travel_time_s(leg, speed_mps), leg.distance_m
