"""What is near one point is one mark with one label, which says all that stands there, starts there and stops there."""

from __future__ import annotations

from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.ways import Road, RoadGraph, RoadNode
from missiontree.reporting.maps.cards import MOST_NAMES, Card, card_of
from missiontree.reporting.maps.clusters import Cluster, clusters_of
from missiontree.reporting.maps.content import content_of
from missiontree.reporting.maps.layout import layout_of
from missiontree.reporting.maps.routes import Route, routes_of
from missiontree.reporting.maps.things import MapContent, Thing
from tests.reporting.map_plans import Doing, by_hand, place, unplanned, walker

FAR = place("far", 100, 0)
"""716 units for 100 m: 1 m is 7.2 units."""


def clusters(made: Plan, rank: int | None = None) -> list[Cluster]:
    content = content_of(made)
    layout = layout_of(content, made)
    assert layout is not None
    routes, _ = routes_of(made, rank, content.scene)
    return clusters_of(content.things, routes, layout)


def label(cluster: Cluster, *, short: bool = False) -> Card:
    card = card_of(cluster, short=short)
    assert card is not None
    return card


def test_a_road_node_at_a_place_goes_without_saying() -> None:
    graph = RoadGraph(nodes=(RoadNode(id="turn", position=Position(1, 0)),), roads=(Road(ends=("turn", "far")),))
    first, *_ = clusters(unplanned(Scene(places=(place("a", 0, 0), FAR), roads=graph)))
    assert [thing.id for thing in first.things] == ["a"]


def test_a_road_node_alone_is_named_quietly() -> None:
    graph = RoadGraph(nodes=(RoadNode(id="turn", position=Position(50, 0)),), roads=(Road(ends=("turn", "far")),))
    node = clusters(unplanned(Scene(places=(place("a", 0, 0), FAR), roads=graph)))[-1]
    assert [(row.text, row.quiet, row.strong) for row in label(node).rows] == [("turn", True, False)]


def test_what_stands_a_little_aside_gets_a_dot_of_its_own_and_what_stands_there_gets_none() -> None:
    entities = (Entity(id="box", position=Position(0, 0)), Entity(id="cup", position=Position(1, 0)))
    first, *_ = clusters(unplanned(Scene(places=(place("a", 0, 0), FAR), entities=entities)))
    assert [thing.id for thing in first.things] == ["a", "box", "cup"]
    assert [round(x - first.x, 1) for x, _ in first.aside] == [7.2]


def test_who_is_only_taken_to_be_there_has_a_question_mark_behind_the_name() -> None:
    entities = (Entity(id="Mia", kind="person", last_seen=Position(0, 0)), Entity(id="box", position=Position(0, 0)))
    first, *_ = clusters(unplanned(Scene(places=(place("a", 0, 0), FAR), entities=entities)))
    assert [(row.text, row.unsure) for row in label(first).rows] == [("a", False), ("Mia ?", True), ("box", False)]


def starting(count: int) -> Cluster:
    """So many robots start at one place and work there."""
    doings = [Doing(f"walker-{number + 1}", 0, 9, "a") for number in range(count)]
    scene = Scene(places=(place("a", 0, 0), FAR))
    first, *_ = clusters(by_hand(scene, Fleet((walker(count, place="a"),)), doings), 1)
    return first


def test_robots_that_start_at_a_place_are_named_a_line_each_and_in_short_stand_side_by_side() -> None:
    assert [row.text for row in label(starting(3)).rows] == ["a", "walker-1", "walker-2", "walker-3"]
    name, robots = label(starting(3), short=True).rows
    assert name.text == "a"
    assert [text for text, _, _ in robots.pills] == ["A", "B", "C"]
    assert robots.text == ""


def test_one_robot_alone_keeps_its_name_even_in_short() -> None:
    assert [row.text for row in label(starting(1), short=True).rows] == ["a", "walker-1"]


def test_of_very_many_robots_some_are_named_and_the_rest_is_counted() -> None:
    rows = [row.text for row in label(starting(MOST_NAMES + 3)).rows]
    assert rows == ["a", *(f"walker-{number + 1}" for number in range(MOST_NAMES)), "and 3 robots more"]


def test_a_bold_name_has_the_room_that_it_needs() -> None:
    """Bold letters are some 6 percent wider."""
    bold, plain = (label(one).rows[0] for one in clusters(unplanned(both("same words"))))
    assert bold.text == plain.text
    assert bold.strong
    assert bold.width > 1.05 * plain.width


def both(name: str) -> Scene:
    return Scene(
        places=(place("a", 0, 0, label=name),), entities=(Entity(id="b", label=name, position=Position(50, 0)),)
    )


def test_robots_only_come_by_where_nobody_would_look_for_the_way() -> None:
    """Neither a place, nor a lift, nor a start, nor somebody who is missed."""
    content, (route,) = crossed()
    stop = route.stops[0]

    def passed(*things: Thing, starts: bool = False) -> bool:
        return Cluster("ground", 0, 0, list(things), [route] if starts else [], [(route, stop)]).passed

    box = Thing("box", "box", "object", Position(0, 0))
    assert passed(box)
    assert not passed(box, starts=True)
    assert not passed(box, next(thing for thing in content.things if thing.kind == "place"))
    assert not passed(Thing("lift", "lift", "lift", Position(0, 0)))
    assert not passed(Thing("Mia", "Mia", "person", Position(0, 0), sure=False))
    assert not Cluster("ground", 0, 0, [box]).passed  # no robot comes by at all


def crossed() -> tuple[MapContent, list[Route]]:
    scene = Scene(places=(place("a", 0, 0), FAR))
    made = by_hand(scene, Fleet((walker(place="a"),)), [Doing("walker-1", 0, 9, "a")])
    content = content_of(made)
    return content, routes_of(made, 1, content.scene)[0]
