"""Travel in ticks, with what is unknown."""

from __future__ import annotations

import pytest

from missiontree.estimation.travel import Blocked
from missiontree.mission.estimate import Estimate
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import Action
from missiontree.scheduling.trips import Spot, Trips
from tests.scheduling.instances import at, robots, scene

TRIPS = Trips(Fleet((robots("fast", speed=3), robots("slow"))), scene({"child": 0.5}, child=0, p=10))


def action(kind: str, moves: bool, *brings: str) -> Action:
    return Action(
        name="go",
        text="go",
        role=0,
        robot_type=kind,
        capability="work",
        estimate=Estimate(1.0),
        duration_s=7,
        at="p",
        moves=moves,
        brings=brings,
    )


@pytest.mark.parametrize(
    ("what", "origin", "destination", "count", "metres"),
    [
        (action("fast", True), at(0), at(10), 3_334, 10),  # 10 m / 3 m/s = 3.3333 s, rounded up
        (action("fast", True, "child"), at(0), at(10), 20_000, 10),  # the child goes at 0.5 m/s
        (action("fast", True), None, at(10), 7_000, 0),  # a move from nowhere takes its nominal 7 s
        (action("fast", True), at(0), None, 7_000, 0),
        (action("fast", False), None, at(10), 0, 0),  # an approach from nowhere takes none
        (action("slow", True), at(0), at(10), 7_000, 10),  # no speed: nominal, the metres count
        (action("slow", False), at(0), at(10), 0, 10),
        (action("fast", False), at(10), at(10), 0, 0),
    ],
)
def test_ticks_and_metres(what: Action, origin: Spot, destination: Spot, count: int, metres: float) -> None:
    trip = TRIPS.trip(what, origin, destination)
    assert not isinstance(trip, Blocked)
    assert (trip.ticks, trip.metres) == (count, metres)
