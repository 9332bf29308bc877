"""The map as a picture: whole, readable, the same every time."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import combinations
from xml.etree import ElementTree

import pytest
from hypothesis import given, settings

from missiontree import plan
from missiontree.errors import InputError
from missiontree.mission.area import Area, KeepOut
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.ways import Lift, OccupancyGrid, Road, RoadGraph
from missiontree.reporting.maps.boxes import Box
from missiontree.reporting.maps.motion import motion
from missiontree.reporting.maps.text import map_view
from missiontree.reporting.maps.view import map_svg
from missiontree.reporting.team.view import team_view
from missiontree.samples.catalogue import sample_file
from tests.reporting.map_plans import Doing, by_hand, moving_plans, place, unplanned, walker
from tests.reporting.strict import parse_svg

A, B = Position(0, 0), Position(80, 40)
SCENE = Scene(
    label="Yard",
    places=(place("a", 0, 0, label="depot"), place("b", 80, 40, label="shop")),
    entities=(
        Entity(id="Mia", kind="person", position=Position(40, 10)),
        Entity(id="cat", kind="animal", place="b"),
        Entity(id="key", label="lost key"),
        Entity(id="dog", kind="animal", last_seen=Position(20, 30)),
        Entity(id="Tom", kind="person", search_area=Area(corners=((50, 0), (70, 0), (70, 20), (50, 20)))),
    ),
    keep_outs=(KeepOut(id="pit", area=Area(corners=((10, 5), (30, 5), (30, 15), (10, 15)))),),
)
SVG = "{http://www.w3.org/2000/svg}"


def drawn(made: Plan, rank: int | None = None, **options: str) -> str:
    svg = map_svg(made, rank, **options)
    assert svg is not None
    return svg


def of_class(svg: str, name: str) -> list[ElementTree.Element]:
    root = ElementTree.fromstring(svg)  # noqa: S314 - our own picture
    return [one for one in root.iter() if name in one.get("class", "").split()]


def words(svg: str) -> list[str]:
    root = ElementTree.fromstring(svg)  # noqa: S314 - our own picture
    return [one.text or "" for one in root.iter(f"{SVG}text")]


def box(rect: ElementTree.Element) -> Box:
    x, y, width, height = (float(rect.get(name, "0")) for name in ("x", "y", "width", "height"))
    return Box(x, y, x + width, y + height)


def test_without_a_position_there_is_no_map() -> None:
    assert map_svg(plan(sample_file("reunite")), 1) is None
    assert map_svg(unplanned(Scene(entities=(Entity(id="key"),)))) is None


def test_everything_with_a_position_is_named_and_the_others_are_in_the_box() -> None:
    svg = drawn(unplanned(SCENE, Fleet((walker(2, place="a"),))))
    said = words(svg)
    assert {"depot", "shop", "Mia", "cat", "dog", "Tom", "pit", "Walker ×2"} <= set(said)
    missing = said[said.index("position unknown") :]
    assert [word for word in missing if word in {"lost key", "dog", "Tom", "Mia"}][:3] == ["lost key", "dog", "Tom"]
    assert "planned where last seen" in missing
    assert "planned in the search area" in missing
    assert len(of_class(svg, "mt-map-search-area")) == 1
    assert len(of_class(svg, "mt-map-keep-out")) == 1


def test_entities_that_the_author_introduced_are_on_the_map_too() -> None:
    """Nobody in the scene: the child comes from the mission's words, without a position."""
    made = plan("Find the child", scene=Scene(places=(place("a", 0, 0),)), fleet=Fleet((walker(place="a"),)))
    assert "position unknown" in words(drawn(made, 1))


def test_of_robots_alike_those_on_the_way_have_a_letter_and_the_rest_is_counted() -> None:
    fleet = Fleet((walker(3, place="a"),))
    made = by_hand(SCENE, fleet, [Doing("walker-2", 0, 9, "b", moves=True, leg=(0, 9, A, B, 9))])
    said = words(drawn(made, 1))
    assert "Walker ×2" in said
    assert "walker-2" in said
    assert said.count("A") == 2  # at its start and in the key
    assert "A1" in said
    assert "Walker ×3" in words(drawn(made))


def test_a_named_robot_without_a_known_start_is_in_the_box() -> None:
    fleet = Fleet((RobotType(id="guide", capabilities={"reach": 1}, robots=(Robot(id="ada"),)),))
    made = by_hand(SCENE, fleet, [Doing("ada", 0, 9, "b", moves=True)])
    assert "start not known" in words(drawn(made, 1))


def test_equal_plans_give_equal_bytes() -> None:
    made = plan(sample_file("site"))
    assert drawn(made, 1) == drawn(plan(sample_file("site")), 1)


def test_all_alternatives_have_the_ground_at_the_same_place() -> None:
    """So that the routes can be changed under the reader's eye."""
    made = plan(sample_file("site"))
    grounds = [
        [(one.tag, one.attrib) for one in of_class(drawn(made, rank), "mt-map-road")] for rank in (None, 1, 2, 3)
    ]
    assert grounds[0]
    assert all(ground == grounds[0] for ground in grounds)


def test_marks_that_move_are_drawn_where_the_map_has_their_places() -> None:
    """The way of the robot in the picture begins and ends where its frames do."""
    made = by_hand(SCENE, Fleet((walker(place="a"),)), [Doing("walker-1", 0, 9, "b", moves=True, leg=(0, 9, A, B, 9))])
    (line,) = [one for one in of_class(drawn(made, 1), "mt-map-route")[0] if one.get("class") == "mt-line"]
    found = motion(made, 1)
    assert found is not None
    frames = found.movers[0].frames
    ends = [tuple(map(float, point.split())) for point in re.findall(r"[ML]([\d.]+ [\d.]+)", line.get("d", ""))]
    assert ends[0] == pytest.approx((frames[0].x, frames[0].y), abs=0.1)
    assert ends[-1] == pytest.approx((frames[-1].x, frames[-1].y), abs=0.1)


def test_ways_that_robots_share_are_lines_of_their_own() -> None:
    fleet = Fleet((walker(3, place="a"),))
    made = by_hand(SCENE, fleet, [Doing(f"walker-{n}", 0, 9, "b", moves=True, leg=(0, 9, A, B, 9)) for n in (1, 2, 3)])
    routes = of_class(drawn(made, 1), "mt-map-route")
    assert [route.get("data-letter") for route in routes] == ["A", "B", "C"]
    assert len({one.get("d") for route in routes for one in route if one.get("class") == "mt-line"}) == 3


def test_the_bar_is_a_round_length_at_the_scale_of_the_map() -> None:
    """80 m are 716 units wide, 8.95 a metre: 110 units are 12.3 m, so the bar is 10 m, 89.5 units."""
    svg = drawn(unplanned(Scene(places=(place("a", 0, 0), place("b", 80, 0)))))
    (bar,) = of_class(svg, "mt-map-scale")
    assert bar[0].text == "scale: 10 m"
    start, end = re.findall(r"M([\d.]+) .*H([\d.]+) ", bar[1].get("d", ""))[0]
    assert float(end) - float(start) == pytest.approx(89.5, abs=0.1)


def test_every_floor_has_a_panel_with_its_name() -> None:
    scene = Scene(
        places=(place("hall", 0, 0), place("top", 0, 0, "first")),
        roads=RoadGraph(lifts=(Lift(id="lift", stops=("hall", "top"), ride_s=5),)),
    )
    svg = drawn(unplanned(scene))
    assert len(of_class(svg, "mt-map-panel")) == 2
    assert {"floor ground", "floor first", "lift to first", "lift to ground"} <= set(words(svg))
    assert len(of_class(drawn(unplanned(scene), None, floor="first"), "mt-map-panel")) == 1


def test_what_holds_on_roads_is_drawn_and_explained() -> None:
    scene = Scene(
        places=(place("a", 0, 0), place("b", 80, 0), place("c", 80, 60)),
        roads=RoadGraph(
            roads=(
                Road(ends=("a", "b"), one_way=True),
                Road(ends=("b", "c"), blocked=True),
                Road(ends=("a", "c"), types=("walker",)),
            )
        ),
    )
    svg = drawn(unplanned(scene))
    for name in ("mt-map-one-way", "mt-map-blocked", "mt-map-limited"):
        assert of_class(svg, name)
    assert {"one-way", "blocked", "only for some robot types"} <= set(words(svg))
    assert "keep-out" not in words(svg)  # only signs that the map has are explained


def test_walls_are_one_path() -> None:
    scene = Scene(grid=OccupancyGrid(rows=("#####", "#...#", "#####"), cell_m=1.0), places=(place("in", 2.5, 1.5),))
    (wall,) = of_class(drawn(unplanned(scene)), "mt-map-wall")
    assert wall.get("d", "").count("M") == 4  # above, left, right, below


def test_names_are_words_and_nothing_else() -> None:
    evil = "\x1b]0;x\x07<script>alert(1)</script>\u202e&\"'"
    scene = Scene(
        label=evil,
        places=(place("a", 0, 0, label=evil), place("b", 9, 9, label="]]>" + evil)),
        entities=(Entity(id="x", label=evil), Entity(id="y", label=evil * 9, place="a")),
    )
    parsed = parse_svg(drawn(unplanned(scene)))
    assert "<script>alert(1)</script>" in parsed.words


def test_three_hundred_places_are_marked_and_the_names_left_out_are_counted() -> None:
    """Scattered over 500 m by 320 m, no two at one spot: names and those left out are 300 together."""
    places = [place(f"p{n}", n * 157 % 500, n * 89 % 320, label=f"bay {n}") for n in range(300)]
    svg = drawn(unplanned(Scene(places=tuple(places))))
    named = sum(word.startswith("bay ") for word in words(svg))
    (remark,) = [word for word in words(svg) if "left out for want of room" in word]
    assert named + int(remark.split()[0]) == 300
    assert named >= 100
    marked = len(of_class(svg, "mt-map-place")) + len(of_class(svg, "mt-map-dot")) - 1  # one of them in the legend
    assert marked == 300


def test_five_thousand_places_are_dots_but_for_those_that_the_plan_is_about() -> None:
    places = [place(f"p{number}", number % 100, number // 100, label=f"bay {number}") for number in range(5000)]
    start, goal = places[0].position, places[4210].position
    assert start is not None
    assert goal is not None
    fleet = Fleet((walker(place="p0"),))
    made = by_hand(
        Scene(places=tuple(places)), fleet, [Doing("walker-1", 0, 9, "p4210", moves=True, leg=(0, 9, start, goal, 9))]
    )
    svg = drawn(made, 1)
    assert "bay 4210" in " ".join(words(svg))
    assert "A1" in words(svg)
    assert any(word.endswith("things that no route touches are dots without a name.") for word in words(svg))
    assert len(svg) < 200_000


@settings(max_examples=60)
@given(moving_plans())
def test_no_label_covers_another_or_a_mark_and_all_are_in_the_picture(made: Plan) -> None:
    svg = map_svg(made, 1)
    if svg is None:
        return
    parse_svg(svg)
    root = ElementTree.fromstring(svg)  # noqa: S314 - our own picture
    width, height = float(root.get("width", "0")), float(root.get("height", "0"))
    cards = [box(rect) for rect in of_class(svg, "mt-map-card")]
    grounds = [box(rect) for rect in of_class(svg, "mt-map-ground")]
    places = [box(rect) for rect in of_class(svg, "mt-map-place")]
    for card in cards:
        assert any(card.within(ground) for ground in grounds)
    for ground in grounds:
        assert ground.within(Box(0, 0, width, height))
        here = [card.grown(-0.1) for card in cards if card.within(ground)]  # coordinates have one decimal
        assert not any(first.meets(second) for first, second in combinations(here, 2))
        marks = [place.grown(-0.1) for place in places if place.within(ground)]
        assert not any(card.meets(mark) for card in here for mark in marks)
    for text in root.iter(f"{SVG}text"):
        assert 0 <= float(text.get("x", "0")) <= width
        assert 0 <= float(text.get("y", "0")) <= height


@pytest.mark.parametrize("extent_m", [0.0, 2.0, 20_000.0])
def test_from_a_point_to_twenty_kilometres_the_map_can_be_drawn(extent_m: float) -> None:
    scene = Scene(places=(place("a", 0, 0), place("b", extent_m, 0)))
    made = by_hand(
        scene,
        Fleet((walker(place="a"),)),
        [Doing("walker-1", 0, 9, "b", moves=True, leg=(0, 9, A, Position(extent_m, 0), extent_m))],
    )
    svg = drawn(made, 1)
    parse_svg(svg)
    assert {"a", "b"} <= set(words(svg))
    assert [one.get("d", "").count("L") for one in of_class(svg, "mt-line")][:1] == [1]


def test_a_damaged_plan_is_drawn_as_far_as_it_goes() -> None:
    """A leg along nodes that the scene does not have, by a robot that the fleet does not have."""
    made = by_hand(
        SCENE,
        Fleet((walker(place="a"),)),
        [Doing("walker-1", 0, 9, "nowhere", moves=True, leg=(0, 9, A, B, 9), via=("x", "y"))],
    )
    other = Plan(
        outcome=made.outcome,
        brief=unplanned(SCENE, Fleet((RobotType(id="stranger", count=1),))).brief,
        grounding=made.grounding,
        ranking=made.ranking,
        schedules=made.schedules,
        provenance=made.provenance,
    )
    assert "A1" in words(drawn(other, 1))


def test_a_plan_that_points_past_its_tree_is_refused() -> None:
    """Action 7 of a tree of two nodes: neither map nor motion nor the terminal's map can tell of it."""
    made = by_hand(SCENE, Fleet((walker(place="a"),)), [Doing("walker-1", 0, 9, "b")])
    (schedule,) = made.schedules
    astray = replace(made, schedules=(replace(schedule, actions=(replace(schedule.actions[0], leaf=7),)),))
    for show in (map_svg, motion, map_view, lambda plan, _: team_view(plan)):
        with pytest.raises(InputError, match="node 7"):
            show(astray, 1)
