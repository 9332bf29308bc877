"""The scene: what refers to what, where things are taken to be, frames and kinds."""

from __future__ import annotations

import pytest

from missiontree.mission.area import Area
from missiontree.mission.entity import Entity
from missiontree.mission.position import Position
from missiontree.mission.scene import Frame, Scene
from missiontree.mission.ways import Lift, OccupancyGrid, Road, RoadGraph, RoadNode

SQUARE = Area(corners=((0, 0), (4, 0), (4, 2), (0, 2)))


def test_whereabouts_prefer_what_is_known_best() -> None:
    scene = Scene(places=(Entity(id="gate", position=Position(7, 8)),))
    at = Position(1, 2)
    assert scene.whereabouts(Entity(id="a", position=at)).position == at
    assert scene.whereabouts(Entity(id="a", place="gate")).position == Position(7, 8)
    assert scene.whereabouts(Entity(id="a", last_seen=at, search_area=SQUARE)).source == "last_seen"
    # The middle of a rectangle is the mean of its corners: (8 / 4, 4 / 4).
    assert scene.whereabouts(Entity(id="a", search_area=SQUARE)).position == Position(2, 1)
    assert scene.whereabouts(Entity(id="a")).position is None


def test_a_frame_turns_then_moves() -> None:
    # A quarter turn takes (2, 0) to (0, 2); moving by (10, 0) takes that to (10, 2).
    scene = Scene(frames=(Frame(id="dock", x_m=10, yaw_deg=90),))
    moved = scene.in_map(Position(2, 0, frame="dock"))
    assert (round(moved.x_m, 9), round(moved.y_m, 9)) == (10, 2)
    with pytest.raises(ValueError, match="frame 'deck' is not known"):
        scene.in_map(Position(0, 0, frame="deck"))


def test_kinds_stand_under_kinds() -> None:
    scene = Scene(kinds={"kitten": "cat", "cat": "animal"})
    assert list(scene.lineage("kitten")) == ["kitten", "cat", "animal"]
    assert scene.base_kind("kitten") == "animal"
    with pytest.raises(ValueError, match="stands under itself"):
        Scene(kinds={"a": "b", "b": "a"})
    with pytest.raises(ValueError, match="kind 'ghost' is not known"):
        Scene(entities=(Entity(id="x", kind="ghost"),))


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"entities": (Entity(id="a"), Entity(id="a"))}, "entity 'a' stands twice"),
        ({"entities": (Entity(id="a", place="nowhere"),)}, "at place 'nowhere'"),
        ({"entities": (Entity(id="a", zone="z"),)}, "in zone 'z'"),
        ({"places": (Entity(id="a", kind="person"),)}, "stands under places but is of kind 'person'"),
        ({"roads": RoadGraph(roads=(Road(ends=("a", "b")),))}, "a road ends at 'a'"),
        ({"roads": RoadGraph(lifts=(Lift(id="l", stops=("a", "b"), ride_s=1),))}, "lift 'l' stops at 'a'"),
        ({"roads": RoadGraph(), "grid": OccupancyGrid(rows=(".",), cell_m=1)}, "either roads or a grid"),
    ],
)
def test_a_scene_that_contradicts_itself_is_refused(fields: dict[str, object], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        Scene(**fields)  # type: ignore[arg-type]


def test_a_road_ends_at_a_place_wherever_that_is_listed() -> None:
    """Places may stand among the entities; a person is no end of a road."""
    ends = (Entity(id="a", kind="place", position=Position(0, 0)), Entity(id="b", kind="hall", position=Position(3, 4)))
    scene = Scene(entities=ends, kinds={"hall": "place"}, roads=RoadGraph(roads=(Road(ends=("a", "b")),)))
    assert scene.road_points == {"a": Position(0, 0), "b": Position(3, 4)}
    with pytest.raises(ValueError, match="a road ends at 'b'"):
        Scene(
            entities=(ends[0], Entity(id="b", kind="person", position=Position(3, 4))),
            roads=RoadGraph(roads=(Road(ends=("a", "b")),)),
        )


def test_a_road_between_floors_needs_a_lift() -> None:
    nodes = (
        RoadNode(id="low", position=Position(0, 0)),
        RoadNode(id="high", position=Position(0, 0, floor="first")),
    )
    with pytest.raises(ValueError, match="joins two floors; use a lift"):
        Scene(roads=RoadGraph(nodes=nodes, roads=(Road(ends=("low", "high")),)))
    Scene(roads=RoadGraph(nodes=nodes, lifts=(Lift(id="lift", stops=("low", "high"), ride_s=20),)))


@pytest.mark.parametrize(("rows", "words"), [((), "at least one row"), (("..", "."), "row 2"), (("x",), "'x'")])
def test_a_grid_is_a_rectangle_of_dots_and_hashes(rows: tuple[str, ...], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        OccupancyGrid(rows=rows, cell_m=1.0)


def test_a_scene_with_more_entities_is_made_once() -> None:
    scene, child, dog = Scene(), Entity(id="child", kind="person"), Entity(id="dog", kind="animal")
    larger = scene.extended((child,))
    assert scene.extended((child,)) is larger
    assert scene.extended((dog,)).entities == (dog,)
    assert scene.extended((child,)).entities == (child,)
    assert scene.extended(()) is scene
