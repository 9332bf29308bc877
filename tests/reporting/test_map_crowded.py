"""Where very much stands and happens, the map keeps what people find their way by."""

from __future__ import annotations

import re
from xml.etree import ElementTree

from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.ways import OccupancyGrid
from missiontree.reporting.maps.boxes import Box
from missiontree.reporting.maps.cards import MOST_PILLS, card_of, draw_card
from missiontree.reporting.maps.clusters import MOST_STOPS, Cluster
from missiontree.reporting.maps.labels import Placed
from missiontree.reporting.maps.things import Thing
from missiontree.reporting.palette import PAPER
from tests.reporting.map_plans import Doing, by_hand, place, unplanned, walker
from tests.reporting.test_map_view import box, drawn, of_class, words


def yard(count: int) -> Plan:
    """A robot that goes from a store to each of so many crates, 4 m apart, and back every time."""
    store = place("store", 42, 42, label="the store")
    crates = [
        Entity(id=f"crate{number}", position=Position(4 * (number % 20), 4 * (number // 20) + 2))
        for number in range(count)
    ]
    home = store.position
    assert home is not None
    doings = []
    for number, crate in enumerate(crates):
        spot, start = crate.position, 20.0 * number
        assert spot is not None
        doings.append(
            Doing("walker-1", start, start + 10, crate.id, moves=True, leg=(start, start + 10, home, spot, 9))
        )
        doings.append(
            Doing("walker-1", start + 10, start + 20, "store", moves=True, leg=(start + 10, start + 20, spot, home, 9))
        )
    scene = Scene(places=(store,), entities=(*crates, Entity(id="Mia", kind="person", last_seen=Position(90, 90))))
    return by_hand(scene, Fleet((walker(place="store"),)), doings)


def test_where_robots_stop_at_very_many_things_these_are_dots_that_tell_their_names() -> None:
    count = MOST_STOPS + 10
    svg = drawn(yard(count), 1)
    said = {(dot[0].text or "") for dot in of_class(svg, "mt-map-dot") if len(dot)}
    assert said == {f"crate{number}" for number in range(count)}
    assert f"{count} things at which robots stop are small dots; their names would find no room." in words(svg)
    assert not any("left out" in word for word in words(svg))


def test_the_place_that_robots_start_from_and_whoever_is_missed_keep_their_marks_and_names() -> None:
    svg = drawn(yard(MOST_STOPS + 10), 1)
    assert {"the store", "walker-1", "Mia"} <= set(words(svg))
    assert len(of_class(svg, "mt-map-place")) == 2  # one of them in the legend


def test_as_long_as_there_are_few_enough_everything_has_a_mark() -> None:
    svg = drawn(yard(MOST_STOPS - 10), 1)
    assert not of_class(svg, "mt-map-dot")
    assert not any("small dots" in word for word in words(svg))


def test_of_very_many_stops_at_a_place_the_number_is_told() -> None:
    few, many = drawn(yard(MOST_PILLS), 1), drawn(yard(MOST_PILLS + 1), 1)
    assert f"A{2 * MOST_PILLS}" in words(few)
    assert f"{MOST_PILLS + 1} stops of 1 robot" in words(many)
    assert f"A{2 * MOST_PILLS + 2}" not in words(many)


def test_a_line_to_a_label_is_seen_where_it_crosses_routes() -> None:
    """It has a wider stroke of paper below it."""
    card = card_of(Cluster("ground", 0, 0, [Thing("a", "a", "place", Position(0, 0))]))
    assert card is not None
    lines = list(draw_card(card, Placed(Box(40, 40, 80, 56), ((4, 4), (40, 40)), 0.0)))
    below, line = (ElementTree.fromstring(one) for one in lines if one.startswith("<path"))  # noqa: S314 - our own
    assert below.get("d") == line.get("d") == "M4 4 L40 40"
    assert below.get("stroke") == PAPER
    assert float(below.get("stroke-width", "0")) > float(line.get("stroke-width", "0")) + 2


def wall_boxes(svg: str) -> list[Box]:
    (path,) = of_class(svg, "mt-map-wall")
    corners = re.findall(r"M([\d.]+) ([\d.]+)H([\d.]+)V([\d.]+)H[\d.]+z", path.get("d", ""))
    return [Box(*map(float, one)) for one in corners]


def test_labels_keep_off_walls_where_there_is_room_elsewhere() -> None:
    """Right of its mark, where a label stands by default, there is a wall 1 m away; left of it, there are 9 m of free ground."""
    rows = ("..........####................",) * 12
    scene = Scene(places=(place("room", 9, 6, label="the reading room"),), grid=OccupancyGrid(rows=rows, cell_m=1.0))
    svg = drawn(unplanned(scene))
    (card,) = (box(one) for one in of_class(svg, "mt-map-card"))
    walls = wall_boxes(svg)
    assert len(walls) == 1
    assert not card.meets(walls[0])
    (without,) = (box(one) for one in of_class(drawn(unplanned(Scene(places=scene.places))), "mt-map-card"))
    (mark, _) = of_class(drawn(unplanned(Scene(places=scene.places))), "mt-map-place")
    assert without.left > box(mark).right  # by default, it is on the right
