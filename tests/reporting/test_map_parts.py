"""Small parts of the map: hatching, round lengths, clusters, the key of the routes."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from missiontree.estimation.polygon import Polygon
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.reporting.maps.cards import card_of
from missiontree.reporting.maps.clusters import MOST_MARKS, clusters_of
from missiontree.reporting.maps.content import content_of
from missiontree.reporting.maps.ground import hatch
from missiontree.reporting.maps.layout import layout_of
from missiontree.reporting.maps.legend import metres, metres_walked, round_length, routes_key
from missiontree.reporting.maps.routes import routes_of
from tests.reporting.map_plans import Doing, by_hand, place, unplanned, walker


@given(st.lists(st.tuples(st.floats(0, 300), st.floats(0, 300)), min_size=3, max_size=8))
def test_hatching_stays_inside_its_area(corners: list[tuple[float, float]]) -> None:
    """Concave and crossing outlines too: the middle of every stroke is inside, by the even-odd rule."""
    polygon = Polygon(corners)
    for (ax, ay), (bx, by) in hatch(corners):
        assert ax + ay == pytest.approx(bx + by, abs=1e-6)  # rising in a picture, where y grows downwards
        if math.dist((ax, ay), (bx, by)) > 0.01:
            assert polygon.covers(((ax + bx) / 2, (ay + by) / 2))


def test_a_square_is_hatched_all_over() -> None:
    """100 by 100: the sum of coordinates runs from 0 to 200, strokes 8 apart, that is 11.3 in the sum: 17 of them."""
    assert len(hatch([(0, 0), (100, 0), (100, 100), (0, 100)])) == 17


@pytest.mark.parametrize(
    ("most_m", "length_m"), [(110, 100), (99.9, 50), (49, 20), (2, 2), (0.7, 0.5), (23456, 20000), (1, 1)]
)
def test_a_bar_is_one_two_or_five_times_a_power_of_ten(most_m: float, length_m: float) -> None:
    assert round_length(most_m) == pytest.approx(length_m)


@given(st.floats(1e-6, 1e9))
def test_a_bar_is_never_longer_than_asked_and_never_below_two_fifths(most_m: float) -> None:
    assert most_m / 2.5 - 1e-9 * most_m <= round_length(most_m) <= most_m * (1 + 1e-6)


@pytest.mark.parametrize(("length_m", "words"), [(0.5, "0.5 m"), (500, "500 m"), (2000, "2 km")])
def test_lengths_of_bars_are_for_people(length_m: float, words: str) -> None:
    assert metres(length_m) == words


@pytest.mark.parametrize(("length_m", "words"), [(55, "55.0 m"), (1234.5, "1234 m"), (15_000, "15.0 km")])
def test_lengths_of_ways_are_for_people(length_m: float, words: str) -> None:
    assert metres_walked(length_m) == words


def clustered(scene: Scene, fleet: Fleet | None = None) -> list[list[str]]:
    made = unplanned(scene, fleet)
    content = content_of(made)
    layout = layout_of(content, made)
    assert layout is not None
    return [[thing.id for thing in cluster.things] for cluster in clusters_of(content.things, [], layout)]


def test_what_stands_at_one_point_has_one_mark_and_the_place_gives_it() -> None:
    scene = Scene(
        places=(place("a", 0, 0), place("b", 50, 0)),
        entities=(Entity(id="box", place="a"), Entity(id="cat", kind="animal", place="a")),
    )
    assert clustered(scene, Fleet((walker(place="a"),))) == [["a", "box", "cat", "walker"], ["b"]]


def test_what_stands_apart_has_marks_apart() -> None:
    """716 units for 100 m: 1 m is 7.2 units, near; 3 m are 21, apart."""
    places = (place("a", 0, 0), place("b", 1, 0), place("c", 3, 0), place("d", 100, 0))
    assert clustered(Scene(places=places)) == [["a", "b"], ["c"], ["d"]]


def test_one_spot_of_two_floors_is_two_marks() -> None:
    assert clustered(Scene(places=(place("a", 0, 0), place("b", 0, 0, "first")))) == [["a"], ["b"]]


def test_the_label_of_a_crowd_names_some_and_counts_the_rest() -> None:
    entities = tuple(Entity(id=f"box{number}", place="a") for number in range(20))
    made = unplanned(Scene(places=(place("a", 0, 0),), entities=entities))
    content = content_of(made)
    layout = layout_of(content, made)
    assert layout is not None
    (cluster,) = clusters_of(content.things, [], layout)
    card = card_of(cluster)
    assert card is not None
    assert [row.text for row in card.rows] == ["a", *(f"box{number}" for number in range(7)), "and 13 more"]
    short = card_of(cluster, short=True)
    assert short is not None
    assert [row.text for row in short.rows] == ["a"]


def test_where_there_are_too_many_marks_plain_places_become_dots() -> None:
    places = [place(f"p{number}", 40 * (number % 40), 40 * (number // 40)) for number in range(MOST_MARKS + 40)]
    made = unplanned(Scene(places=tuple(places), entities=(Entity(id="box", place="p7"),)))
    content = content_of(made)
    layout = layout_of(content, made)
    assert layout is not None
    clusters = clusters_of(content.things, [], layout)
    assert [cluster.things[0].id for cluster in clusters if not cluster.plain] == ["p7"]


def test_in_the_key_no_stop_is_torn_and_those_that_do_not_fit_are_counted() -> None:
    a, b = Position(0, 0), Position(9, 0)
    scene = Scene(places=(place("a", 0, 0), place("b", 9, 0)))
    legs = [(a, b) if number % 2 == 0 else (b, a) for number in range(40)]
    doings = [
        Doing("walker-1", 9.0 * n, 9.0 * n + 9, "ba"[n % 2], moves=True, leg=(9.0 * n, 9.0 * n + 9, *ends, 9.0))
        for n, ends in enumerate(legs)
    ]
    routes, _ = routes_of(by_hand(scene, Fleet((walker(place="a"),)), doings), 1, scene)
    lines, _ = routes_key(
        routes, lambda route: [f"{stop.number} at {stop.spot and stop.spot.x_m:g}" for stop in route.stops], 0, 0, 400
    )
    text = " ".join(
        line[line.index(">") + 1 : line.index("</text>")] for line in lines if line.startswith('<text class="mt-ink"')
    )
    assert text.startswith("walker-1 (Walker, 360 m): 1 at 9, 2 at 0, 3 at 9,")
    more = int(text.rsplit("and ", 1)[1].split()[0])
    assert text.count(" at ") + more == 40
