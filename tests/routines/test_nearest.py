"""The quickest of many starts, found without asking for every way."""

from __future__ import annotations

import math

from hypothesis import given
from hypothesis import strategies as st

from missiontree.estimation.leg import Leg, unreachable
from missiontree.estimation.travel import Blocked
from missiontree.mission.position import Position
from missiontree.routines.nearest import Starts

coordinates = st.integers(-20, 20)
positions = st.builds(Position, coordinates, coordinates, st.sampled_from(["ground", "first"]))


@given(st.lists(positions, max_size=12), positions, st.sampled_from([0.5, 1.0, 2.0]))
def test_as_asking_for_every_way(starts: list[Position], target: Position, speed_mps: float) -> None:
    """Ways are never shorter than the straight line; one start in three is blocked, a floor costs 5 s."""

    def leg(start: Position) -> Leg | Blocked:
        if (start.x_m + start.y_m) % 3 == 0:
            return unreachable("closed")
        detour = 1 + (start.x_m % 2)
        straight_m = math.hypot(start.x_m - target.x_m, start.y_m - target.y_m)
        return Leg(straight_m * detour, 5.0 * (start.floor != target.floor))

    every = [leg(start) for start in starts]
    ways = [(way.distance_m / speed_mps + way.ride_s, way.distance_m) for way in every if isinstance(way, Leg)]
    found = Starts(starts).quickest(target, leg, speed_mps)
    if ways:
        assert isinstance(found, Leg)
        assert (found.distance_m / speed_mps + found.ride_s, found.distance_m) == min(ways)
    else:
        assert isinstance(found, Blocked) if starts else found is None


def test_far_starts_are_not_asked() -> None:
    asked = []

    def leg(start: Position) -> Leg:
        asked.append(start.x_m)
        return Leg(abs(start.x_m))

    assert Starts(Position(float(x), 0) for x in range(1, 1000)).quickest(Position(0, 0), leg, 1.0) == Leg(1.0)
    assert asked == [1.0]
