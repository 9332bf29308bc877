"""What is closed to whom."""

from missiontree.estimation.access import Closure, access_of
from missiontree.mission.area import Area, KeepOut, Zone
from missiontree.mission.fleet import RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.ways import Lift, Road, RoadGraph, RoadNode

AREA = Area(corners=((0, 0), (1, 0), (1, 1)))
SCENE = Scene(
    zones=(Zone(id="ward", area=AREA), Zone(id="hall")),
    keep_outs=(KeepOut(id="stairs", area=AREA), KeepOut(id="ramp", area=AREA, types=("cart",))),
    roads=RoadGraph(
        nodes=tuple(RoadNode(id=name, position=Position(0, 0)) for name in "ab"),
        roads=(
            Road(ends=("a", "b")),
            Road(ends=("a", "b"), blocked=True),
            Road(ends=("a", "b"), types=("cart",)),
            Road(ends=("a", "b"), zone="hall"),
        ),
        lifts=(
            Lift(id="l1", stops=("a", "b"), ride_s=1, blocked=True),
            Lift(id="l2", stops=("a", "b"), ride_s=1, types=("cart",)),
        ),
    ),
)


def test_a_type_without_zones_may_enter_all_of_them() -> None:
    access = access_of(RobotType(id="drone", count=1), SCENE)
    assert [closed.name for closed in access.areas] == ["keep-out stairs"]
    assert access.roads == (Closure(1, "is blocked"), Closure(2, "is closed to this robot type"))
    assert access.lifts == (Closure(0, "is out of order"), Closure(1, "is closed to this robot type"))


def test_keep_outs_and_zones_may_hold_for_some_types_only() -> None:
    access = access_of(RobotType(id="cart", count=1, zones=()), SCENE)
    assert [closed.name for closed in access.areas] == ["keep-out stairs", "keep-out ramp", "zone ward"]
    assert access.roads == (Closure(1, "is blocked"), Closure(3, "runs through zone hall, closed to this robot type"))


def test_types_with_equal_ways_have_equal_access() -> None:
    first = access_of(RobotType(id="drone", count=1), SCENE)
    second = access_of(RobotType(id="rover", count=3, zones=("ward", "hall")), SCENE)
    assert first == second
    assert hash(first) == hash(second)
