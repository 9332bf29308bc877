"""Times and lengths beyond what is counted exactly are refused where they stand."""

from __future__ import annotations

import pytest

from missiontree.errors import InputError
from missiontree.formats.document import read_text
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Capability, DurationModel, Fleet, RobotType
from missiontree.mission.position import Position
from missiontree.mission.reach import refuse_endless
from missiontree.mission.scene import Scene
from missiontree.mission.ways import Road, RoadGraph
from missiontree.routines.library import built_in


@pytest.mark.parametrize(
    ("kind", "text", "line", "said"),
    [
        (
            "scene",
            "places:\n  - {id: p, position: {x_m: 0, y_m: -1.1e7}}",
            2,
            "places[0].position.y_m: -1.1e+07 m is too far",
        ),
        ("scene", "keep_outs:\n  - id: pit\n    area: {corners: [[0, 0], [1e9, 0], [0, 1]]}", 3, "1e+09 m is too far"),
        ("fleet", "types:\n  - id: a\n    count: 1\n    available_until_s: 1.0e+10", 4, "1e+10 s is too long"),
        ("mission", "mission: Go\ndeadline_s: 1000000001", 2, "deadline_s: 1e+09 s is too long"),
    ],
)
def test_the_line_is_told_and_the_most_that_is_accepted(kind: str, text: str, line: int, said: str) -> None:
    with pytest.raises(InputError) as refusal:
        read_text(text, kind, "file.yaml")
    assert (refusal.value.file, refusal.value.line) == ("file.yaml", line)
    assert said in str(refusal.value)
    assert ("1,000,000,000" if " s is" in said else "10,000,000") in refusal.value.accepted


def test_the_most_itself_is_accepted_and_a_time_that_ends_nothing_is_no_number_of_ours() -> None:
    assert read_text("mission: Go\ndeadline_s: 1000000000", "mission").deadline_s == 1e9
    assert read_text("places: [{id: p, position: {x_m: -1.0e+7, y_m: 1.0e+7}}]", "scene").places[0].position.x_m == -1e7


def team(speed: float, *, scale: float = 1.0) -> Fleet:
    able = Capability(0.5, duration=DurationModel(scale=scale))
    return Fleet((RobotType(id="a", count=1, capabilities={"carry": able}, limits={"max_speed_mps": speed}),))


def square(**others: object) -> Scene:
    """Places in the corners of 30 x 40 m, joined by a road of 100 m: no way is longer than four diagonals of 50 m and the road, 300 m."""
    corners = (Entity(id="p", position=Position(0, 0)), Entity(id="q", position=Position(30, 40)))
    roads = RoadGraph(roads=(Road(ends=("p", "q"), length_m=100),))
    return Scene(places=corners, roads=roads, **others)  # type: ignore[arg-type]


def test_a_way_of_300_m_may_take_the_longest_time_and_no_more() -> None:
    refuse_endless(team(3e-7), square(), built_in())
    with pytest.raises(ValueError, match=r"'a', alone or with what it brings, moves at 2.9e-07 m/s.* 300 m long"):
        refuse_endless(team(2.9e-7), square(), built_in())


def test_what_is_brought_slows_its_robot() -> None:
    slow = Entity(id="snail", kind="object", max_speed_mps=2.9e-7)
    with pytest.raises(ValueError, match=r"2\.9e-07 m/s"):
        refuse_endless(team(1.0), square(entities=(slow,)), built_in())


def test_an_action_that_a_capability_makes_endless_is_refused() -> None:
    refuse_endless(team(1.0, scale=1e6), square(), built_in())
    with pytest.raises(ValueError, match="'carry' of robot type 'a' makes an action of"):
        refuse_endless(team(1.0, scale=1e9), square(), built_in())
