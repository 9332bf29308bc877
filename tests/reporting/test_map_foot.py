"""What stands beside and below the map: those who are missed, signs, and the key of the routes, whatever their number."""

from __future__ import annotations

import pytest

from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.ways import OccupancyGrid
from missiontree.reporting.maps.content import content_of
from missiontree.reporting.maps.legend import MOST_LINES, MOST_ROUTES, SIZE, routes_key
from missiontree.reporting.maps.missing import MOST_MISSING
from missiontree.reporting.maps.routes import routes_of
from missiontree.reporting.maps.signs import ROW, entries, entries_of
from missiontree.reporting.maps.text import map_view
from missiontree.reporting.text import render
from missiontree.reporting.text_box import text_width
from tests.reporting.map_plans import Doing, by_hand, place, unplanned, walker
from tests.reporting.test_map_view import SCENE, drawn, words

PLACES = (place("a", 0, 0), place("b", 80, 40))


def test_of_very_many_that_are_missed_twelve_are_named_and_the_rest_is_counted() -> None:
    keys = tuple(Entity(id=f"key{number}") for number in range(MOST_MISSING + 3))
    said = words(drawn(unplanned(Scene(places=PLACES, entities=keys))))
    assert sum(word.startswith("key") for word in said) == MOST_MISSING
    assert "and 3 more" in said


def working(count: int, start: str = "a") -> Plan:
    fleet = Fleet((walker(count, place=start) if start else walker(count),))
    doings = [Doing(f"walker-{number + 1}", 0, 9, "a") for number in range(count)]
    return by_hand(Scene(places=PLACES), fleet, doings)


def test_of_very_many_robots_that_start_nobody_knows_where_the_rest_is_counted() -> None:
    said = words(drawn(working(MOST_MISSING + 2, start=""), 1))
    assert said.count("start not known") == MOST_MISSING
    assert said.count("and 2 robots more") == 2  # beside the map, and in the key, which has twelve, too


def test_the_key_has_twelve_robots_and_counts_the_rest() -> None:
    svg = drawn(working(MOST_ROUTES + 4), 1)
    assert sum("(Walker)" in word for word in words(svg)) == MOST_ROUTES
    assert "and 4 robots more" in words(svg)


def test_who_does_not_see_the_map_is_told_of_eight_robots() -> None:
    svg = drawn(working(10), 1)
    description = svg[svg.index("<desc") : svg.index("</desc>")]
    assert "H is walker-8" in description
    assert "I is walker-9" not in description


@pytest.mark.parametrize("width", [150, 220, 300, 420])
def test_no_line_of_the_key_is_wider_than_its_room(width: float) -> None:
    """Also the last one, at whose end the rest is counted. Line and letter take 58 units."""
    names = [f"{number} at the place number {number}" for number in range(60)]
    made = working(1)
    routes, _ = routes_of(made, 1, content_of(made).scene)
    lines, _ = routes_key(routes, lambda _: names, 0, 0, width)
    said = [line[line.index(">") + 1 : line.index("</text>")] for line in lines if line.startswith("<text")]
    own = [line for line in said if line != routes[0].letter]
    assert len(own) == MOST_LINES
    assert own[-1].endswith(" more")
    assert all(text_width(line, SIZE) <= width - 58 for line in own)


def test_signs_that_do_not_fit_into_one_line_go_on_in_the_next() -> None:
    found = entries_of(content_of(unplanned(SCENE)), ["ground"])
    total = sum(entry.width for entry in found)
    assert entries(found, 0, 0, total)[1] == ROW
    assert entries(found, 0, 0, total / 2)[1] >= 2 * ROW


def test_a_narrow_map_is_wide_enough_for_its_legend() -> None:
    """Ground that goes up only takes 366 units."""
    svg = drawn(unplanned(Scene(places=(place("a", 0, 0), place("b", 0, 100)))))
    assert float(svg.split('width="', 1)[1].split('"')[0]) >= 420


def test_in_a_terminal_no_line_of_the_key_is_wider_than_the_terminal() -> None:
    grid = OccupancyGrid(rows=("#" + "." * 99, *("." * 100,) * 49), cell_m=1.0)
    scene = Scene(
        places=SCENE.places,
        entities=SCENE.entities,
        keep_outs=SCENE.keep_outs,
        grid=grid,
    )
    view = map_view(unplanned(scene, Fleet((walker(place="a"),))), None, 40)
    assert view is not None
    lines = render(view, 200).splitlines()
    key = [line for line in lines if any(word in line for word in ("person", "wall", "keep-out", "robot"))]
    assert len(key) > 1
    assert all(len(line.rstrip()) <= 40 for line in key)


def test_in_a_terminal_a_robot_of_two_letters_leaves_stars() -> None:
    """The 27th robot is AA, which is no single character."""
    far = Position(80, 40)
    doings = [Doing(f"walker-{number + 1}", 0, 9, "a") for number in range(26)]
    doings.append(Doing("walker-27", 0, 9, "b", moves=True, leg=(0, 9, Position(0, 0), far, 90)))
    made = by_hand(Scene(places=PLACES), Fleet((walker(27, place="a"),)), doings)
    view = map_view(made, 1, 80)
    assert view is not None
    drawing = render(view, 80).split("├")[0]
    assert drawing.count("*") > 10
    assert "aa" not in drawing
