"""Areas that are closed: to everybody, or to some robot types only, which others cross before one's eyes."""

from __future__ import annotations

from itertools import pairwise

import pytest

from missiontree.estimation.polygon import Polygon
from missiontree.mission.area import Area, KeepOut
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.plan import Plan
from missiontree.mission.scene import Scene
from missiontree.reporting.maps.text import map_view
from missiontree.reporting.text import render
from tests.reporting.map_plans import place, unplanned
from tests.reporting.test_map_view import drawn, of_class, words

FLEET = Fleet((RobotType(id="cart", label="Quay Cart", count=1), RobotType(id="tug", label="Tug", count=1)))
WIDE = Area(corners=((0, 0), (100, 0), (100, 60), (0, 60)))


def closing(*types: str, area: Area = WIDE, everybody: bool = False) -> Plan:
    keep_out = KeepOut(id="basin", area=area, types=None if everybody else types)
    return unplanned(Scene(places=(place("a", -40, -40), place("b", 140, 100)), keep_outs=(keep_out,)), FLEET)


def hatches(made: Plan) -> int:
    """Lines in the area: of the two paths of one that is hatched, the second."""
    (group,) = of_class(drawn(made), "mt-map-keep-out")
    return sum(path.get("d", "").count("M") for path in list(group)[2:])


def test_an_area_closed_to_everybody_is_hatched() -> None:
    made = closing(everybody=True)
    assert hatches(made) > 10
    assert {"basin", "keep-out"} <= set(words(drawn(made)))
    assert "closed to some robot types" not in words(drawn(made))


def test_an_area_closed_to_some_is_not_hatched_and_says_to_whom() -> None:
    made = closing("cart")
    assert hatches(made) == 0
    assert {"basin: closed to Quay Cart", "closed to some robot types"} <= set(words(drawn(made)))
    assert "keep-out" not in words(drawn(made))


def test_an_area_closed_to_every_type_of_the_fleet_is_closed_to_everybody() -> None:
    assert drawn(closing("cart", "tug")).replace(", for cart, tug", "") == drawn(closing(everybody=True))


def test_an_area_closed_to_nobody_says_so() -> None:
    assert "basin: closed to nobody" in words(drawn(closing()))


@pytest.mark.parametrize("high_m", [30, 45, 60])
def test_in_a_narrow_area_the_rule_stands_below_the_name_and_inside(high_m: float) -> None:
    """32 m are some 112 units wide at this scale: room for "closed to Quay", not for all of it on one line."""
    narrow = Area(corners=((0, 0), (32, 0), (32, high_m), (0, high_m)))
    svg = drawn(closing("cart", area=narrow))
    named = of_class(svg, "mt-map-keep-out-name")
    assert [one.text for one in named] == ["basin", "closed to Quay", "Cart"]
    heights = [float(one.get("y", "0")) for one in named]
    assert [after - before for before, after in pairwise(heights)] == pytest.approx([14, 14])
    outline = of_class(svg, "mt-map-keep-out")[0][1].get("d", "").removeprefix("M").removesuffix(" z")
    corners = [tuple(map(float, point.split())) for point in outline.split(" L")]
    polygon = Polygon([(x, y) for x, y in corners])
    assert all(polygon.covers((float(one.get("x", "0")), float(one.get("y", "0")))) for one in named)


def test_in_a_tiny_area_only_the_name_is_told_and_the_rest_to_those_who_point_at_it() -> None:
    tiny = Area(corners=((0, 0), (3, 0), (3, 3), (0, 3)))
    svg = drawn(closing("cart", area=tiny))
    assert [one.text for one in of_class(svg, "mt-map-keep-out-name")] == ["basin"]
    assert "<title>keep-out basin, for cart</title>" in svg


def test_in_a_terminal_they_are_told_apart_and_what_is_closed_to_all_lies_on_top() -> None:
    pit = KeepOut(id="pit", area=Area(corners=((40, 20), (60, 20), (60, 40), (40, 40))))
    basin = KeepOut(id="basin", area=WIDE, types=("cart",))
    places = (place("a", -40, -40), place("b", 140, 100))
    for keep_outs in ((pit, basin), (basin, pit)):
        view = map_view(unplanned(Scene(places=places, keep_outs=keep_outs), FLEET), None, 100)
        assert view is not None
        lines = render(view, 100).splitlines()
        assert any(":::░░" in line and "░░:::" in line for line in lines)
        assert any("░ keep-out" in line and ": basin: closed to Quay Cart" in line for line in lines)
