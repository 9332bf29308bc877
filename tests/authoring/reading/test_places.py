"""Where the words say that something is, against where the scene has it."""

from __future__ import annotations

import pytest

from missiontree.authoring.reading.places import is_designation, place_said, stands_at
from missiontree.mission.entity import Entity
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene

SCENE = Scene(
    places=(
        Entity(id="hall", kind="place", label="Great Hall", position=Position(0, 0)),
        Entity(id="attic", kind="place", position=Position(0, 0, floor="top")),
        Entity(id="shed", kind="place", position=Position(10, 0)),
        Entity(id="nook", kind="place", place="hall"),
        Entity(id="limbo", kind="place"),
    ),
    entities=(
        Entity(id="vase", place="nook"),
        Entity(id="broom", place="hall"),
        Entity(id="rake", position=Position(9, 0)),
        Entity(id="ghost", last_seen=Position(0, 0)),
    ),
)


@pytest.mark.parametrize(
    ("description", "place"),
    [
        ("in the great hall", "hall"),
        ("at the shed", "shed"),
        ("from shed", "shed"),
        ("in the cellar", None),
        ("near the shed", None),
        ("in", None),
        ("", None),
        ("in the shed of the farmer", None),
    ],
)
def test_place_is_said_by_its_whole_name(description: str, place: str | None) -> None:
    said = place_said(description, SCENE)
    assert (said.id if said else None) == place


@pytest.mark.parametrize(
    ("entity", "place", "expected"),
    [
        ("vase", "nook", True),
        ("vase", "hall", True),  # the nook is in the hall
        ("vase", "shed", False),
        ("broom", "nook", None),  # in the hall, maybe in its nook
        ("rake", "shed", True),  # 1 m from the shed, 9 m from the hall
        ("rake", "hall", False),
        ("rake", "attic", False),  # above the hall, on another floor
        ("rake", "limbo", None),  # nobody knows where that is
        ("ghost", "hall", None),  # it was only seen there
    ],
)
def test_entity_stands_at_a_place_or_not_or_nobody_knows(entity: str, place: str, expected: bool | None) -> None:
    assert stands_at(SCENE.by_id[entity], SCENE.by_id[place], SCENE) is expected


def test_what_tells_places_of_one_noun_apart() -> None:
    assert all(is_designation(word) for word in ("3", "three", "a", "b2"))
    assert not any(is_designation(word) for word in ("hall", "great"))
