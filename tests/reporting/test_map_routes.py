"""Where each robot goes, in which order it stops, and who moves along."""

from __future__ import annotations

import pytest

from missiontree import plan
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.reporting.clock import clock
from missiontree.reporting.maps.content import content_of
from missiontree.reporting.maps.routes import Route, letters_of, routes_of
from missiontree.reporting.maps.stops import length_of, stops_of
from missiontree.reporting.maps.whereabouts import whereabouts_of
from missiontree.samples.catalogue import sample_file
from tests.reporting.map_plans import Doing, by_hand, place, walker

A, B, C = Position(0, 0), Position(3, 4), Position(3, 0)
SCENE = Scene(places=(place("a", 0, 0), place("b", 3, 4), place("c", 3, 0)), entities=(Entity(id="box", place="b"),))


def route(*doings: Doing, fleet: Fleet | None = None) -> Route:
    made = by_hand(SCENE, fleet or Fleet((walker(place="a"),)), doings)
    (found,), _ = routes_of(made, 1, SCENE)
    return found


def test_stops_are_numbered_in_the_order_of_the_route() -> None:
    """Thinks at the start, goes 5 m to b, works there twice, goes 4 m to c."""
    found = route(
        Doing("walker-1", 0, 2),
        Doing("walker-1", 2, 7, "b", moves=True, leg=(2, 7, A, B, 5)),
        Doing("walker-1", 7, 9, "b"),
        Doing("walker-1", 9, 10),
        Doing("walker-1", 10, 14, "c", moves=True, leg=(10, 14, B, C, 4)),
    )
    assert [(stop.number, stop.spot, stop.start_s, stop.end_s) for stop in found.stops] == [
        (0, A, 0, 2),
        (1, B, 7, 10),
        (2, C, 14, 14),
    ]
    assert found.stops[1].texts == ("Go to b", "Work at b", "Work at hand")
    assert found.distance_m == 9


def test_a_place_that_is_come_back_to_is_a_stop_of_its_own() -> None:
    found = route(
        Doing("walker-1", 0, 5, "b", moves=True, leg=(0, 5, A, B, 5)),
        Doing("walker-1", 5, 10, "a", moves=True, leg=(5, 10, B, A, 5)),
        Doing("walker-1", 10, 15, "b", moves=True, leg=(10, 15, A, B, 5)),
    )
    assert [(stop.number, stop.spot) for stop in found.stops] == [(1, B), (2, A), (3, B)]


def test_the_way_to_an_action_is_a_stop_when_it_arrives() -> None:
    """Arrives after 5 s, may begin after 20 s."""
    found = route(Doing("walker-1", 20, 30, "b", leg=(0, 5, A, B, 5)))
    assert [(stop.number, stop.start_s, stop.end_s) for stop in found.stops] == [(1, 5, 30)]


def test_a_robot_that_starts_nobody_knows_where_is_first_seen_at_its_first_stop() -> None:
    found = route(
        Doing("walker-1", 0, 60, "b", moves=True),
        Doing("walker-1", 60, 64, "c", moves=True, leg=(60, 64, B, C, 4)),
        fleet=Fleet((walker(),)),
    )
    assert found.start is None
    assert [(stop.spot, stop.start_s) for stop in found.stops] == [(B, 60), (C, 64)]


def test_what_was_brought_is_where_it_was_brought_to() -> None:
    """The box goes from b to c; who works at the box afterwards works at c."""
    doings = (
        Doing("walker-1", 0, 5, "b", moves=True, leg=(0, 5, A, B, 5)),
        Doing("walker-1", 5, 9, "c", moves=True, brings=("box",), leg=(5, 9, B, C, 4)),
        Doing("walker-2", 9, 12, "box"),
    )
    made = by_hand(SCENE, Fleet((walker(2),)), doings)
    assert made.grounding is not None
    where = whereabouts_of(made.schedules[0], made.grounding.tree, SCENE)
    assert [deed.at for deed in where.deeds] == [B, C, C]
    assert [deed.scheduled.leaf for deed in where.brought["box"]] == [2]


def test_before_it_is_brought_it_is_where_it_was() -> None:
    doings = (
        Doing("walker-2", 0, 3, "box"),
        Doing("walker-1", 5, 9, "c", moves=True, brings=("box",), leg=(5, 9, B, C, 4)),
    )
    made = by_hand(SCENE, Fleet((walker(2),)), doings)
    assert made.grounding is not None
    assert whereabouts_of(made.schedules[0], made.grounding.tree, SCENE).deeds[0].at == B


def test_what_begins_before_it_is_brought_away_is_done_where_it_was() -> None:
    """However long it lasts: from 0 to 20 s at b, though the box leaves at 5 s."""
    doings = (
        Doing("walker-2", 0, 20, "box"),
        Doing("walker-1", 5, 9, "c", moves=True, brings=("box",), leg=(5, 9, B, C, 4)),
    )
    made = by_hand(SCENE, Fleet((walker(2),)), doings)
    assert made.grounding is not None
    assert whereabouts_of(made.schedules[0], made.grounding.tree, SCENE).deeds[0].at == B


def test_of_two_who_carry_together_one_stands_for_both() -> None:
    doings = tuple(
        Doing(f"walker-{number}", 5, 9, "c", moves=True, brings=("box",), leg=(5, 9, B, C, 4), sync=0)
        for number in (1, 2)
    )
    made = by_hand(SCENE, Fleet((walker(2),)), doings)
    assert made.grounding is not None
    where = whereabouts_of(made.schedules[0], made.grounding.tree, SCENE)
    assert [deed.scheduled.robot for deed in where.brought["box"]] == ["walker-1"]


def test_letters_follow_the_fleet_and_are_the_same_in_every_alternative() -> None:
    """The site's alternatives use a guide, or the hauler or courier in its place."""
    made = plan(sample_file("site"))
    letters = letters_of(made)
    assert list(letters.values()) == ["A", "B", "C", "D", "E"]
    assert list(letters) == [robot for robot in made.brief.fleet.robots if robot in letters]
    for schedule in made.schedules:
        scene = made.brief.world
        for found in routes_of(made, schedule.rank, scene)[0]:
            assert found.letter == letters[found.robot]


def test_after_z_comes_aa() -> None:
    fleet = Fleet((walker(28),))
    made = by_hand(SCENE, fleet, [Doing(f"walker-{number}", 0, 1) for number in range(1, 29)])
    assert list(letters_of(made).values())[25:] == ["Z", "AA", "AB"]


def test_without_a_schedule_there_are_no_routes() -> None:
    made = by_hand(SCENE, Fleet((walker(place="a"),)), [Doing("walker-1", 0, 1, "a")])
    assert routes_of(made, 2, SCENE)[0] == []
    assert routes_of(made, None, SCENE)[0] == []


def test_stops_are_told_with_place_and_time() -> None:
    """At b, where the box is, the place is named; of who is met off every place, the name."""
    scene = Scene(places=SCENE.places, entities=(Entity(id="Mia", kind="person", position=Position(9, 9)),))
    doings = (
        Doing("walker-1", 0, 5, "b", moves=True, leg=(0, 5, A, B, 5)),
        Doing("walker-1", 5, 12, "Mia", leg=(5, 10, B, Position(9, 9), 8)),
    )
    made = by_hand(scene, Fleet((walker(place="a"),)), doings)
    (found,), _ = routes_of(made, 1, scene)
    assert stops_of(found, content_of(made), 599.9) == ["A1 b (5 s)", "A2 Mia (10–12 s)"]
    assert stops_of(found, content_of(made), 600.0) == ["A1 b (0:00:05)", "A2 Mia (0:00:10–0:00:12)"]


def test_the_last_stop_of_any_robot_says_how_long_all_takes() -> None:
    doings = (Doing("walker-1", 0, 61.5, "b", moves=True, leg=(0, 61.5, A, B, 5)), Doing("walker-2", 0, 4000, "a"))
    routes, _ = routes_of(by_hand(SCENE, Fleet((walker(2, place="a"),)), doings), 1, SCENE)
    assert length_of(routes) == 4000
    assert length_of([]) == 0


@pytest.mark.parametrize(
    ("time_s", "told"), [(0, "0:00:00"), (912.4, "0:15:12"), (3599.6, "1:00:00"), (360_000, "100:00:00")]
)
def test_a_clock_goes_on_after_a_day(time_s: float, told: str) -> None:
    assert clock(time_s) == told


@pytest.mark.parametrize(("robots", "index"), [(12, 11), (23, 22)])
def test_a_robot_has_the_colours_of_its_place_in_the_fleet(robots: int, index: int) -> None:
    """Not of its place among those that are used: all pictures of a plan agree on it."""
    types = (RobotType(id="idle", count=robots - 1), walker())
    found = route(Doing("walker-1", 0, 1, "a"), fleet=Fleet(types))
    assert found.livery.number == index % 10
    assert found.livery.hatch
