"""In which zones entities are."""

from __future__ import annotations

import pytest

from missiontree.mission.area import Area, Zone
from missiontree.mission.entity import Entity
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.routines.zones import holds, zones_of

# An L: the square (0, 0)-(4, 4) without its upper right quarter.
L = Area(corners=((0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)))


@pytest.mark.parametrize(
    ("x_m", "y_m", "inside"),
    [
        (1, 1, True),
        (3, 1, True),
        (1, 3, True),
        (3, 3, False),  # the missing quarter
        (5, 1, False),
        (-1, 2, False),  # level with a corner
        (2, 2, True),  # a corner
        (4, 1, True),  # an edge
        (3, 4, False),  # on the line of an edge, beyond it
    ],
)
def test_inside_an_l(x_m: float, y_m: float, inside: bool) -> None:
    assert holds(L, Position(x_m, y_m)) is inside


def test_another_floor_is_outside() -> None:
    assert not holds(L, Position(1, 1, floor="first"))


def test_own_zone_then_the_places_then_all_areas() -> None:
    scene = Scene(
        zones=(
            Zone(id="l", area=L),
            Zone(id="all", area=Area(corners=((-9, -9), (9, -9), (9, 9), (-9, 9)))),
            Zone(id="hot"),
        ),
        places=(
            Entity(id="oven", kind="place", position=Position(1, 1), zone="hot"),
            Entity(id="door", kind="place", position=Position(3, 3)),
        ),
        entities=(
            Entity(id="named", position=Position(1, 1), zone="hot"),
            Entity(id="at_oven", place="oven"),
            Entity(id="at_door", place="door"),
            Entity(id="seen", last_seen=Position(1, 1)),
            Entity(id="lost"),
        ),
    )
    zones = {name: zones_of(scene.by_id[name], scene) for name in ("named", "at_oven", "at_door", "seen", "lost")}
    assert zones == {"named": ("hot",), "at_oven": ("hot",), "at_door": ("all",), "seen": ("l", "all"), "lost": ()}
