"""Metres to picture: everything inside, floors side by side at one scale."""

from __future__ import annotations

import pytest
from hypothesis import given, settings

from missiontree.mission.area import Area, Zone
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.reporting.maps.content import content_of
from missiontree.reporting.maps.layout import LARGEST_SCALE, MOST_HEIGHT, MOST_WIDTH, PAD_X, PAD_Y, MapLayout, layout_of
from tests.reporting.map_plans import moving_plans, place, unplanned


def laid_out(scene: Scene, floor: str | None = None) -> MapLayout:
    plan = unplanned(scene)
    layout = layout_of(content_of(plan), plan, floor)
    assert layout is not None
    return layout


def test_the_picture_has_the_ground_as_a_map_has_it() -> None:
    """300 m by 100 m: at most 900 - 2 * 92 = 716 units for 300 m, so 716 / 300 units a metre; y grows upwards."""
    layout = laid_out(Scene(places=(place("a", 0, 0), place("b", 300, 100))))
    assert layout.scale == pytest.approx((MOST_WIDTH - 2 * PAD_X) / 300)
    (ax, ay), (bx, by) = layout.at(0, 0, "ground") or (0, 0), layout.at(300, 100, "ground") or (0, 0)
    assert bx - ax == pytest.approx(716)
    assert ay - by == pytest.approx(716 / 3)


def test_a_scene_that_is_high_is_bound_by_its_height() -> None:
    layout = laid_out(Scene(places=(place("a", 0, 0), place("b", 1, 5000))))
    assert layout.scale == pytest.approx((MOST_HEIGHT - 2 * PAD_Y) / 5000)


@pytest.mark.parametrize("extent_m", [0.0, 1e-9, 0.5, 2.0, 20_000.0, 5e7, 1e300])
def test_any_extent_gives_a_picture_of_sound_size(extent_m: float) -> None:
    layout = laid_out(Scene(places=(place("a", 0, 0), place("b", extent_m, 0))))
    assert 200 <= layout.width <= MOST_WIDTH + 40
    assert 100 <= layout.height <= MOST_HEIGHT + 40
    assert 0 < layout.scale <= LARGEST_SCALE


def test_floors_stand_side_by_side_at_one_scale_and_show_the_same_ground() -> None:
    """A lift is at the same spot of every panel."""
    layout = laid_out(Scene(places=(place("a", 0, 0), place("b", 20, 10, "first"), place("c", 5, 5, "roof"))))
    assert [panel.floor for panel in layout.panels] == ["ground", "first", "roof"]
    spots = [layout.at(10, 4, panel.floor) or (0, 0) for panel in layout.panels]
    inside = [(spot[0] - panel.x, spot[1] - panel.y) for spot, panel in zip(spots, layout.panels, strict=True)]
    assert inside[1:] == [pytest.approx(inside[0])] * 2
    assert layout.panels[0].x < layout.panels[1].x


def test_one_floor_can_be_shown_alone() -> None:
    scene = Scene(places=(place("a", 0, 0), place("b", 20, 10, "first")))
    layout = laid_out(scene, "first")
    assert [panel.floor for panel in layout.panels] == ["first"]
    assert layout.point(Position(0, 0)) is None
    plan = unplanned(scene)
    assert layout_of(content_of(plan), plan, "cellar") is None


def test_without_a_position_there_is_no_layout() -> None:
    plan = unplanned(Scene(zones=(Zone(id="named_only"),)))
    assert layout_of(content_of(plan), plan) is None


def test_an_area_alone_is_enough() -> None:
    layout = laid_out(Scene(zones=(Zone(id="yard", area=Area(corners=((0, 0), (4, 0), (0, 3)))),)))
    assert layout.scale > 0


@settings(max_examples=40)
@given(moving_plans())
def test_everything_is_inside_its_panel_and_panels_are_apart(plan: Plan) -> None:
    content = content_of(plan)
    layout = layout_of(content, plan)
    if layout is None:
        assert not content.things
        assert not content.areas
        return
    for thing in content.things:
        panel, point = layout.panel(thing.spot.floor), layout.point(thing.spot)
        assert panel is not None
        assert point is not None
        assert panel.x <= point[0] <= panel.x + panel.width
        assert panel.y <= point[1] <= panel.y + panel.height
    for number, first in enumerate(layout.panels):
        assert first.x >= 0
        assert first.x + first.width <= layout.width
        assert first.y + first.height <= layout.height
        for second in layout.panels[number + 1 :]:
            beside = first.x + first.width < second.x or second.x + second.width < first.x
            assert beside or first.y + first.height < second.y
