"""Where actions can possibly happen."""

from __future__ import annotations

from missiontree.mission.fleet import Fleet
from missiontree.scheduling.places import Places
from missiontree.scheduling.precedence import task_graph
from missiontree.scheduling.trips import Trips
from tests.scheduling.instances import Instance, Part, at, mission, move, robots, scene, work

WORLD = scene(box=0, p=5, q=9, lost=None)


def places_of(made: Instance) -> dict[str, set[float | None]]:
    graph = task_graph(made.tree, made.alternative.choices)
    order = graph.order()
    assert order is not None
    places = Places(graph, order, Trips(Fleet((robots("r", 3),)), WORLD))
    return {
        graph.name(leaf): {None if spot is None else spot.x_m for spot in spots} for leaf, spots in places.of.items()
    }


def test_what_nobody_moves_is_where_the_scene_has_it() -> None:
    assert places_of(mission([Part("a", "r", [work(1, at="box"), work(1), work(1, at="lost")])])) == {
        "a.0": {at(0).x_m},
        "a.1": {None},
        "a.2": {None},
    }


def test_an_ordered_move_is_certain() -> None:
    """Before the moves the box is at 0; between them at p; after both at q."""
    made = mission(
        [
            Part("a", "r", [work(1, at="box"), move("p", "box"), work(1, at="box"), move("q", "box")]),
            Part("b", "r", [work(1, at="box")]),
        ],
        [("a", "b")],
    )
    found = places_of(made)
    assert (found["a.0"], found["a.2"], found["b.0"]) == ({0}, {5}, {9})


def test_a_move_without_an_order_leaves_it_open() -> None:
    made = mission([Part("a", "r", [move("p", "box")]), Part("b", "r", [work(1, at="box")])])
    assert places_of(made)["b.0"] == {0, 5}
