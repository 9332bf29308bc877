"""The map in a terminal: harmless, no wider than asked, everything at its place."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from rich.cells import cell_len

from missiontree import plan
from missiontree.mission.area import Area, KeepOut
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.ways import Lift, OccupancyGrid, Road, RoadGraph
from missiontree.reporting.maps.text import map_view
from missiontree.reporting.text import render
from missiontree.samples.catalogue import sample_file
from tests.reporting.map_plans import Doing, by_hand, moving_plans, place, unplanned, walker
from tests.reporting.strict import check_terminal

A, B = Position(0, 0), Position(60, 0)
SCENE = Scene(
    places=(place("a", 0, 0, label="depot"), place("b", 60, 0, label="shop"), place("c", 60, 30, label="shed")),
    entities=(Entity(id="key"), Entity(id="Mia", kind="person", last_seen=Position(30, 30))),
)


def shown(made: Plan, rank: int | None = None, width: int = 80) -> list[str]:
    view = map_view(made, rank, width)
    assert view is not None
    return render(view, width).splitlines()


def test_places_stand_as_on_a_map() -> None:
    """The shop is right of the depot on one line; the shed is above the shop in one column."""
    lines = shown(unplanned(SCENE))
    at = {
        name: next((row, line.index(name)) for row, line in enumerate(lines) if name in line)
        for name in ("depot", "shop", "shed")
    }
    assert at["depot"][0] == at["shop"][0]
    assert at["depot"][1] < at["shop"][1]
    assert at["shed"][0] < at["shop"][0]
    assert [line.index("■") for line in lines if "shed" in line] == [
        [at for at, sign in enumerate(line) if sign == "■"][-1] for line in lines if "shop" in line
    ]


def test_the_missing_are_named_and_marked_where_they_are_planned() -> None:
    text = "\n".join(shown(unplanned(SCENE)))
    assert "? Mia" in text
    assert "position unknown: key, Mia (planned where last seen)" in text


def test_ways_are_written_as_letters_and_told_below() -> None:
    fleet = Fleet((walker(2, place="a"),))
    made = by_hand(SCENE, fleet, [Doing("walker-1", 0, 60, "b", moves=True, leg=(0, 60, A, B, 60))])
    lines = shown(made, 1)
    assert any("aaaaaaaaaa" in line for line in lines)
    assert "A walker-1  from depot: A1 shop (60 s); 60.0 m in all" in lines
    assert not any("aaaa" in line for line in shown(made))


def test_ways_of_several_are_told_from_ways_of_one() -> None:
    fleet = Fleet((walker(2, place="a"),))
    doings = [Doing(f"walker-{n}", 0, 60, "b", moves=True, leg=(0, 60, A, B, 60)) for n in (1, 2)]
    assert any("**********" in line for line in shown(by_hand(SCENE, fleet, doings), 1))


def test_walls_keep_outs_and_roads_are_drawn_and_explained() -> None:
    rows = ("##########", *("#........#",) * 8, "##########")
    walled = "\n".join(shown(unplanned(Scene(grid=OccupancyGrid(rows=rows, cell_m=1.0), places=(place("in", 5, 5),)))))
    assert "██████████" in walled
    assert "█ wall" in walled
    pit = KeepOut(id="pit", area=Area(corners=((10, 5), (40, 5), (40, 25), (10, 25))))
    roads = RoadGraph(roads=(Road(ends=("a", "b")),))
    lines = "\n".join(shown(unplanned(Scene(places=SCENE.places, keep_outs=(pit,), roads=roads))))
    assert "░░░░░░" in lines
    assert "······" in lines
    assert "░ keep-out" in lines
    assert "· road" in lines


def test_every_floor_is_drawn_with_its_name() -> None:
    scene = Scene(
        places=(place("hall", 0, 0), place("top", 0, 0, "first")),
        roads=RoadGraph(lifts=(Lift(id="lift", stops=("hall", "top"), ride_s=5),)),
    )
    lines = shown(unplanned(scene))
    assert lines.index("floor ground") < lines.index("floor first")
    assert "■ hall +1" in [line.strip() for line in lines]  # the lift is there, too


def test_without_a_position_there_is_no_map() -> None:
    assert map_view(plan(sample_file("reunite")), 1) is None


@pytest.mark.parametrize("width", [10, 40, 80, 200])
def test_no_line_is_wider_than_asked(width: int) -> None:
    lines = shown(plan(sample_file("site")), 1, width)
    assert max(map(cell_len, lines)) <= max(width, 24)


@settings(max_examples=40)
@given(moving_plans())
def test_any_scene_is_harmless_and_narrow(made: Plan) -> None:
    view = map_view(made, 1, 60)
    if view is not None:
        text = render(view, 60)
        check_terminal(text)
        assert max(map(cell_len, text.splitlines())) <= 60


def test_names_do_not_act() -> None:
    evil = "\x1b[31m\u202eevil\nline[red]"
    view = map_view(unplanned(Scene(places=(place("a", 0, 0, label=evil), place("b", 9, 9, label="good")))), width=80)
    assert view is not None
    text = render(view, 80)
    check_terminal(text)
    assert "evil line[red]" in text
