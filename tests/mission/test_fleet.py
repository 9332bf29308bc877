"""The fleet: counts, names, budgets, and what it refuses."""

from __future__ import annotations

import pytest

from missiontree.mission.estimate import Estimate, Weights
from missiontree.mission.fleet import Capability, Fleet, Robot, RobotType
from missiontree.mission.position import Position


def test_interchangeable_robots_are_named_after_their_type() -> None:
    scouts = RobotType(id="scout", count=3, place="gate")
    assert [robot.id for robot in scouts.members] == ["scout-1", "scout-2", "scout-3"]
    assert {robot.place for robot in scouts.members} == {"gate"}


def test_a_short_capability_is_the_long_one() -> None:
    assert RobotType(id="a", count=1, capabilities={"search": 0.5}).capability("search") == Capability(0.5)
    assert RobotType(id="a", count=1).capability("search") is None


def test_what_remains_goes_before_the_limit_of_the_type() -> None:
    fresh, tired = Robot(id="fresh"), Robot(id="tired", remaining={"energy_j": 10.0})
    kind = RobotType(id="a", robots=(fresh, tired), limits={"energy_j": 100.0})
    assert kind.budget(fresh, "energy_j") == 100.0
    assert kind.budget(tired, "energy_j") == 10.0
    assert kind.budget(fresh, "medkits") is None


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({}, "either a count or a list of robots"),
        ({"count": 1, "robots": (Robot(id="x"),)}, "either a count or a list of robots"),
        ({"count": 0}, "count must be at least 1"),
        ({"count": 1, "capabilities": {"search": -1.0}}, "quality must be at least 0"),
        ({"count": 1, "limits": {"max_speed_mps": 0.0}}, "max_speed_mps must be above 0"),
        ({"count": 1, "limits": {"max_speed_mps": -2.0}}, "limits.max_speed_mps must be at least 0"),
        ({"count": 1, "place": "p", "position": Position(0, 0)}, "both a position and a place"),
        ({"robots": (Robot(id="x"),), "place": "p"}, "give each of them its own position"),
    ],
)
def test_a_type_that_contradicts_itself_is_refused(fields: dict[str, object], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        RobotType(id="a", **fields)  # type: ignore[arg-type]


def test_a_fleet_needs_types_and_unique_names() -> None:
    with pytest.raises(ValueError, match="at least one robot type"):
        Fleet(())
    with pytest.raises(ValueError, match="robot type 'a' stands twice"):
        Fleet((RobotType(id="a", count=1), RobotType(id="a", count=1)))
    with pytest.raises(ValueError, match="robot 'a-1' stands twice"):
        Fleet((RobotType(id="a", count=1), RobotType(id="b", robots=(Robot(id="a-1"),))))


def test_a_fleet_of_ten_thousand_robots_is_a_fleet() -> None:
    fleet = Fleet((RobotType(id="ant", count=10_000),))
    assert len(fleet.robots) == 10_000
    assert fleet.type_of["ant-10000"].id == "ant"


def test_a_fleet_beyond_all_reason_is_refused_before_its_robots_are_made() -> None:
    with pytest.raises(ValueError, match="at most 100,000 robots, this one 1,000,000,001"):
        Fleet((RobotType(id="ant", count=10**9), RobotType(id="bee", count=1)))


def test_utility_is_a_whole_number_of_millionths() -> None:
    # 2 * 0.3 - 0.01 * 10 - 0.5 * 0.1 = 0.6 - 0.1 - 0.05 = 0.45
    assert Weights(2, 0.01, 0.5).utility_micro(Estimate(0.3, 10, 0.1)) == 450_000
    # Ties round to even: 0.0000005 is half a millionth, and the even neighbour is 0.
    assert Weights().utility_micro(Estimate(0.0000005)) == 0
