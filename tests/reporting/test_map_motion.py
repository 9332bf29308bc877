"""Where everybody is when, by hand."""

from __future__ import annotations

import json
from itertools import pairwise

from hypothesis import given, settings

from missiontree import plan
from missiontree.mission.area import Area
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.ways import Lift, Road, RoadGraph
from missiontree.reporting.maps.motion import Motion, Mover, motion
from missiontree.samples.catalogue import sample_file
from tests.reporting.map_plans import Doing, by_hand, moving_plans, place, walker

A, B, C = Position(0, 0), Position(8, 0), Position(8, 6)
SCENE = Scene(
    places=(place("a", 0, 0), place("b", 8, 0), place("c", 8, 6)),
    entities=(
        Entity(id="box", place="b"),
        Entity(id="Mia", kind="person", search_area=Area(corners=((7, 5), (9, 5), (9, 7), (7, 7)))),
        Entity(id="ghost", kind="person"),
    ),
)


def moving(*doings: Doing, fleet: Fleet | None = None, scene: Scene = SCENE, floor: str | None = None) -> Motion:
    found = motion(by_hand(scene, fleet or Fleet((walker(2, place="a"),)), doings), 1, floor=floor)
    assert found is not None
    return found


def where(mover: Mover, t_s: float) -> tuple[float, float, str] | None:
    """What a script shows, by the rule that the module states: metres and floor, or None for hidden."""
    past = [frame for frame in mover.frames if frame.t_s <= t_s]
    if not past or not past[-1].seen:
        return None
    here = past[-1]
    later = mover.frames[len(past)] if len(past) < len(mover.frames) else None
    if later is None or not later.seen or later.floor != here.floor:
        return here.x_m, here.y_m, here.floor
    share = (t_s - here.t_s) / (later.t_s - here.t_s)
    return here.x_m + share * (later.x_m - here.x_m), here.y_m + share * (later.y_m - here.y_m), here.floor


def test_at_one_metre_per_second_it_is_three_metres_on_after_three_seconds() -> None:
    """Leaves a at 10 s, is at b, 8 m on, at 18 s, and stays."""
    (robot,) = moving(Doing("walker-1", 10, 18, "b", moves=True, leg=(10, 18, A, B, 8))).movers
    assert where(robot, 0) == (0, 0, "ground")
    assert where(robot, 13) == (3, 0, "ground")
    assert where(robot, 99) == (8, 0, "ground")


def test_it_waits_where_it_is_until_it_leaves() -> None:
    """Arrives at 8 s for an action that begins at 20 s; goes on to c at 30 s."""
    (robot,) = moving(
        Doing("walker-1", 20, 30, "b", leg=(0, 8, A, B, 8)),
        Doing("walker-1", 30, 36, "c", moves=True, leg=(30, 36, B, C, 6)),
    ).movers
    assert where(robot, 4) == (4, 0, "ground")
    assert where(robot, 15) == where(robot, 29) == (8, 0, "ground")
    assert where(robot, 32) == (8, 2, "ground")
    assert [(one.start_s, one.end_s, one.text) for one in robot.doings] == [(20, 30, "Work at b"), (30, 36, "Go to c")]


def test_who_is_brought_moves_with_its_robot_and_stays_where_it_was_brought() -> None:
    """The robot fetches the box at b and brings it to c, 6 m at 0.5 m/s, and goes back alone."""
    robot, box = moving(
        Doing("walker-1", 0, 8, "b", moves=True, leg=(0, 8, A, B, 8)),
        Doing("walker-1", 8, 20, "c", moves=True, brings=("box",), leg=(8, 20, B, C, 6)),
        Doing("walker-1", 20, 26, "b", moves=True, leg=(20, 26, C, B, 6)),
    ).movers
    assert (box.id, box.kind, box.letter, box.hue) == ("box", "object", "", -1)
    assert where(box, 0) == where(box, 8) == (8, 0, "ground")
    assert where(box, 14) == where(robot, 14) == (8, 3, "ground")
    assert where(box, 26) == (8, 6, "ground")
    assert where(robot, 26) == (8, 0, "ground")


def test_the_missing_come_into_sight_when_they_are_found() -> None:
    """Found at c, the middle of the search area, when the search ends at 74 s."""
    robot, mia = moving(Doing("walker-1", 14, 74, "Mia", finds="Mia", leg=(0, 14, A, C, 14))).movers
    assert where(mia, 73.9) is None
    assert where(mia, 74) == (8, 6, "ground")
    assert robot.letter == "A"


def test_one_who_is_known_and_stays_is_no_mover() -> None:
    movers = moving(Doing("walker-1", 0, 8, "box", finds="box", leg=(0, 8, A, B, 8))).movers
    assert [mover.id for mover in movers] == ["walker-1"]


def test_a_robot_is_hidden_until_it_is_known_where_it_is() -> None:
    """It starts nobody knows where; the move to b takes its nominal 60 s, so at 60 s it is at b."""
    (robot,) = moving(
        Doing("walker-1", 0, 60, "b", moves=True),
        Doing("walker-1", 60, 66, "c", moves=True, leg=(60, 66, B, C, 6)),
        fleet=Fleet((walker(),)),
    ).movers
    assert where(robot, 59.9) is None
    assert where(robot, 60) == (8, 0, "ground")
    assert where(robot, 63) == (8, 3, "ground")


def test_a_robot_that_goes_where_nobody_knows_is_hidden_from_then_on() -> None:
    """The ghost has no position; afterwards it is known again only at b."""
    (robot,) = moving(
        Doing("walker-1", 5, 10, "ghost"), Doing("walker-1", 10, 70, "b", moves=True), fleet=Fleet((walker(place="a"),))
    ).movers
    assert where(robot, 4) == (0, 0, "ground")
    assert where(robot, 5) is None
    assert where(robot, 69) is None
    assert where(robot, 70) == (8, 0, "ground")


HOUSE = Scene(
    places=(place("hall", 0, 0), place("shaft", 4, 0), place("top", 4, 0, "first"), place("room", 4, 3, "first")),
    entities=(Entity(id="bag", place="hall"),),
    roads=RoadGraph(
        roads=(Road(ends=("hall", "shaft")), Road(ends=("top", "room"))),
        lifts=(Lift(id="lift", stops=("shaft", "top"), ride_s=10),),
    ),
)
UP = Doing(
    "walker-1",
    0,
    17,
    "room",
    moves=True,
    brings=("bag",),
    leg=(0, 17, Position(0, 0), Position(4, 3, floor="first"), 7),
    via=("hall", "shaft", "top", "room"),
)


def test_in_a_lift_it_is_at_the_stop_where_it_got_in_and_then_at_the_other() -> None:
    """4 s to the shaft, a ride of 10 s, 3 s to the room."""
    robot, bag = moving(UP, scene=HOUSE, fleet=Fleet((walker(place="hall"),))).movers
    for mover in (robot, bag):
        assert where(mover, 2) == (2, 0, "ground")
        assert where(mover, 13.9) == (4, 0, "ground")
        assert where(mover, 14) == (4, 0, "first")
        assert where(mover, 16) == (4, 2, "first")


def test_on_one_floor_alone_who_is_elsewhere_is_hidden() -> None:
    robot, _ = moving(UP, scene=HOUSE, fleet=Fleet((walker(place="hall"),)), floor="first").movers
    assert where(robot, 13.9) is None
    assert where(robot, 14) == (4, 0, "first")


def test_marks_of_robots_at_one_spot_are_beside_each_other() -> None:
    found = moving(Doing("walker-1", 0, 1), Doing("walker-2", 0, 1))
    first, second = found.movers
    assert ((first.dx - second.dx) ** 2 + (first.dy - second.dy) ** 2) ** 0.5 >= 14 - 1e-6
    assert [one.dx for one in moving(Doing("walker-1", 0, 1)).movers] == [0]


def test_in_the_picture_it_is_where_the_map_has_it() -> None:
    """8 m from a to b are as many units as between their marks."""
    (robot,) = moving(Doing("walker-1", 0, 8, "b", moves=True, leg=(0, 8, A, B, 8))).movers
    first, last = robot.frames[0], robot.frames[-1]
    assert last.x > first.x
    assert last.y == first.y


def test_without_schedule_or_position_there_is_no_motion() -> None:
    assert motion(plan(sample_file("reunite")), 1) is None
    assert motion(by_hand(SCENE, Fleet((walker(place="a"),)), [Doing("walker-1", 0, 1, "a")]), 2) is None


def test_the_plain_form_is_json_with_the_same_frames() -> None:
    found = moving(UP, scene=HOUSE, fleet=Fleet((walker(place="hall"),)))
    plain = json.loads(json.dumps(found.plain()))
    assert plain["end"] == 17_000
    robot = plain["movers"][0]
    assert [frame[0] for frame in robot["frames"]] == [round(frame.t_s * 1000) for frame in found.movers[0].frames]
    assert {frame[3] for frame in robot["frames"]} == {0, 1}
    assert robot["doings"] == [[0, 17_000, "Go to room"]]


@settings(max_examples=40)
@given(moving_plans())
def test_frames_are_in_order_and_in_the_picture(made: Plan) -> None:
    found = motion(made, 1)
    for mover in found.movers if found is not None else ():
        assert all(before.t_s <= after.t_s for before, after in pairwise(mover.frames))
        for frame in mover.frames:
            assert 0 <= frame.x <= 1400
            assert 0 <= frame.y <= 3000


def test_the_sample_is_told_from_the_first_second_to_the_last() -> None:
    """The guide leads the visitor, so both are at the gate when the walk ends."""
    made = plan(sample_file("site"))
    found = motion(made, 1)
    assert found is not None
    movers = {mover.id: mover for mover in found.movers}
    assert found.end_s == made.schedules[0].makespan_s
    guide = next(leg for leg in made.schedules[0].legs if leg.destination == Position(0, 0))
    assert where(movers["visitor"], guide.end_s) == where(movers[guide.robot], guide.end_s) == (0, 0, "ground")
