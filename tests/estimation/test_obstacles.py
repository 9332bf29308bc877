"""Closed areas by name."""

from missiontree.estimation.access import ClosedArea
from missiontree.estimation.leg import for_robot
from missiontree.estimation.obstacles import Obstacles, describe
from missiontree.mission.area import Area
from missiontree.mission.position import Position

PIT = ClosedArea("keep-out pit", Area(corners=((0, 0), (2, 0), (2, 2), (0, 2))))
WARD = ClosedArea("zone ward", Area(corners=((5, 0), (7, 0), (7, 2), (5, 2))))
BOTH = Obstacles((PIT, WARD))


def test_who_stands_inside_which_area() -> None:
    assert BOTH.holding((1, 1)) == "keep-out pit"
    assert BOTH.holding((6, 1)) == "zone ward"
    assert BOTH.holding((2, 1)) is None


def test_which_area_a_line_passes_through() -> None:
    assert BOTH.crossed((-1, 1), (3, 1)) == "keep-out pit"
    assert BOTH.crossed((3, 1), (9, 1)) == "zone ward"
    assert BOTH.crossed((3, 1), (4, 1)) is None


def test_a_refusal_says_where_and_for_whom() -> None:
    refusal = BOTH.forbid(Position(1, 1.5))
    assert refusal is not None
    assert refusal.reason.message == "(1, 1.5) is inside keep-out pit, which is closed to the robot."
    assert (refusal.reason.rule, refusal.reason.robot) == ("unreachable", "")
    assert for_robot(refusal, "cart").reason.robot == "cart"
    assert BOTH.forbid(Position(4, 1)) is None


def test_positions_in_words() -> None:
    assert describe(Position(1, 2.5)) == "(1, 2.5)"
    assert describe(Position(1, 2.5, floor="first")) == "(1, 2.5) on floor first"
