"""Who cannot pay for the way to its work: numbers by hand, and no claim that trying everything contradicts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import permutations, product
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from missiontree.estimation.travel import Leg, TravelModel, start_of
from missiontree.mission.area import Area, KeepOut, Zone
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.grounded import Action
from missiontree.mission.position import Position
from missiontree.mission.reason import Reason
from missiontree.mission.scene import Scene
from missiontree.mission.ways import Lift, OccupancyGrid, Road, RoadGraph, RoadNode
from missiontree.scheduling.approach_budget import approaches_too_dear
from missiontree.scheduling.places import Places
from missiontree.scheduling.precedence import task_graph
from missiontree.scheduling.trips import Trips
from tests.scheduling.instances import Instance, Part, at, mission, move, robots, scene, work


def claims(made: Instance, world: Scene, *types: RobotType) -> list[Reason]:
    graph = task_graph(made.tree, made.alternative.choices)
    order = graph.order()
    assert order is not None
    trips = Trips(Fleet(types), world)
    return approaches_too_dear(graph, Places(graph, order, trips), trips)


def electric(energy_j: float, **more: Any) -> RobotType:
    """Robots that use 1 J a metre."""
    return robots("r", speed=1, uses_per_m={"energy_j": 1}, limits={"energy_j": energy_j}, **more)


@pytest.mark.parametrize(("energy_j", "too_dear"), [(12, False), (11.9, True)])
def test_the_way_and_the_work_together_are_what_counts(energy_j: float, too_dear: bool) -> None:
    """10 m to p are 10 J, the work there 2 J: 12 J are just enough."""
    made = mission([Part("a", "r", [work(1, at="p", uses={"energy_j": 2})])])
    found = claims(made, scene(p=10), electric(energy_j, position=at(0)))
    assert bool(found) == too_dear
    assert [(one.rule, one.needed, one.found) for one in found] == (
        [("budget_exceeded", "energy_j 12", "energy_j 11.9")] if too_dear else []
    )


def test_of_several_robots_one_that_can_is_enough() -> None:
    """near has 5 J for 4 m, far 30 J for 31 m: near can. Without near, far is 1 J short."""
    near, far = (
        Robot(id="near", position=at(6), remaining={"energy_j": 5}),
        Robot(id="far", position=at(-21), remaining={"energy_j": 30}),
    )
    made = mission([Part("a", "r", [work(1, at="p")])])
    assert claims(made, scene(p=10), electric(0, robots=(near, far))) == []
    assert [one.needed for one in claims(made, scene(p=10), electric(0, robots=(far,)))] == ["energy_j 31"]


def test_a_moved_place_counts_from_the_nearest_it_may_be() -> None:
    """The box is at 9 or, once taken there, at 3: 4 J reach the one and not the other; with the order reversed it is at 9."""
    parts = [Part("m", "x", [move("q", "box")]), Part("a", "r", [work(1, at="box")])]
    kinds = robots("x"), electric(4, position=at(0))
    assert claims(mission(parts), scene(box=9, q=3), *kinds) == []
    assert [one.needed for one in claims(mission(parts, [("a", "m")]), scene(box=9, q=3), *kinds)] == ["energy_j 9"]


def test_a_one_way_road_counts_the_way_round() -> None:
    """From here to p it is 10 m against the one-way road, so 10 + 20 m round by the bend."""
    world = Scene(
        places=(
            Entity(id="here", kind="place", position=at(0)),
            Entity(id="p", kind="place", position=at(10)),
        ),
        roads=RoadGraph(
            nodes=(RoadNode(id="bend", position=at(0, 10)),),
            roads=(
                Road(ends=("p", "here"), one_way=True),
                Road(ends=("here", "bend")),
                Road(ends=("bend", "p"), length_m=20),
            ),
        ),
    )
    made = mission([Part("a", "r", [work(1, at="p")])])
    assert [one.needed for one in claims(made, world, electric(29, place="here"))] == ["energy_j 30"]
    assert claims(made, world, electric(30, place="here")) == []


def test_a_keep_out_counts_the_way_round_it() -> None:
    """From (0, 0) to (8, 0) round a wall up to y = 3 at x = 4: 5 + 5 m. A grid with the same wall: 2 diagonals and 6 steps."""
    made = mission([Part("a", "r", [work(1, at="p")])])
    wall = KeepOut(id="wall", area=Area(corners=((4, -9), (4.000001, -9), (4.000001, 3), (4, 3))))
    open_ground = Scene(places=(Entity(id="p", kind="place", position=at(8)),), keep_outs=(wall,))
    assert claims(made, open_ground, electric(9.9, position=at(0)))[0].needed == "energy_j 10"
    assert claims(made, open_ground, electric(10.001, position=at(0))) == []
    grid = Scene(
        places=(Entity(id="p", kind="place", position=at(2.5, 0.5)),),
        grid=OccupancyGrid(rows=("...", ".#."), cell_m=1.0),
    )
    # no corner is cut: up, right, right, down
    assert claims(made, grid, electric(3.9, position=at(0.5, 0.5)))[0].needed == "energy_j 4"
    assert claims(made, grid, electric(4, position=at(0.5, 0.5))) == []


def test_a_zone_that_is_closed_to_the_type_lengthens_the_way() -> None:
    """The straight road of 10 m runs in a zone the type may not enter; the other takes 25 m."""
    world = Scene(
        zones=(Zone(id="ward"), Zone(id="hall")),
        places=(
            Entity(id="here", kind="place", position=at(0)),
            Entity(id="p", kind="place", position=at(10)),
        ),
        roads=RoadGraph(
            roads=(Road(ends=("here", "p"), zone="ward"), Road(ends=("here", "p"), length_m=25)),
        ),
    )
    made = mission([Part("a", "r", [work(1, at="p")])])
    assert claims(made, world, electric(20, place="here")) == []
    assert claims(made, world, electric(20, place="here", zones=("hall",)))[0].needed == "energy_j 25"


def test_of_two_nodes_equally_near_a_point_joins_one_and_pays_for_it() -> None:
    """The robot at (0, 0) is 3 m from n and from m; it joins n, the first listed: 3 + 7 + 0 m to p, though m is at p's door."""
    world = Scene(
        places=(Entity(id="p", kind="place", position=at(3, 1)),),
        roads=RoadGraph(
            nodes=(RoadNode(id="n", position=at(-3)), RoadNode(id="m", position=at(3))),
            roads=(Road(ends=("n", "p"), length_m=7), Road(ends=("m", "p"))),
        ),
    )
    made = mission([Part("a", "r", [work(1, at="p")])])
    assert claims(made, world, electric(9, position=at(0)))[0].needed == "energy_j 10"


def test_without_a_speed_metres_are_charged_all_the_same() -> None:
    kind = robots("r", uses_per_m={"energy_j": 1}, limits={"energy_j": 9}, position=at(0))
    assert claims(mission([Part("a", "r", [work(1, at="p")])]), scene(p=10), kind)[0].needed == "energy_j 10"


def test_where_lifts_run_or_something_is_unknown_nothing_is_claimed() -> None:
    """A lift's quickest way may be the longer one; from an unknown start, or back from an unknown place, a way costs nothing."""
    made = mission([Part("a", "r", [work(1, at="p")])])
    lifts = Scene(
        places=(Entity(id="p", kind="place", position=at(10)), Entity(id="here", kind="place", position=at(0))),
        roads=RoadGraph(
            nodes=(RoadNode(id="up", position=Position(0, 0, "first")),),
            roads=(Road(ends=("here", "p")),),
            lifts=(Lift(id="lift", stops=("here", "up"), ride_s=5),),
        ),
    )
    assert claims(made, lifts, electric(1, place="here")) == []
    assert claims(made, scene(p=10), electric(1)) == []
    assert claims(made, scene(p=None), electric(1, position=at(0))) == []
    # the robot may first be led astray, and come to p from there
    astray = mission([Part("m", "r", [move("lost")]), Part("a", "r", [work(1, at="p")])])
    assert claims(astray, scene(p=10, lost=None), electric(1, position=at(0))) == []
    assert claims(mission([Part("a", "r", [move("lost"), work(1, at="p")])]), scene(p=10, lost=None), electric(1)) == []
    # and so may work at an unknown place
    unsure = mission([Part("m", "r", [work(1, at="lost")]), Part("a", "r", [work(1, at="p")])])
    assert claims(unsure, scene(p=10, lost=None), electric(1, position=at(0))) == []


# --- against trying everything ----------------------------------------------------------------------------------------

SPOTS = st.builds(at, st.integers(0, 6), st.integers(0, 6))


@st.composite
def worlds(draw: st.DrawFn) -> Scene:
    """Open ground with keep-outs that may touch, a grid, or roads of which some are one-way or in a closed zone."""
    entities = tuple(Entity(id=name, position=draw(st.one_of(SPOTS, SPOTS, st.none()))) for name in "pqs")
    what = draw(st.sampled_from(["ground", "ground", "grid", "roads"]))
    if what == "grid":
        rows = draw(st.lists(st.text("...#", min_size=7, max_size=7), min_size=7, max_size=7))
        return Scene(entities=entities, grid=OccupancyGrid(rows=tuple(rows), cell_m=1.0))
    if what == "roads":
        nodes = tuple(RoadNode(id=f"n{number}", position=draw(SPOTS)) for number in range(4))
        pairs = st.permutations([node.id for node in nodes]).map(lambda names: (names[0], names[1]))
        roads = tuple(
            Road(
                ends=draw(pairs),
                one_way=draw(st.booleans()),
                length_m=draw(st.sampled_from([None, 2.0, 9.0])),
                zone=draw(st.sampled_from([None, None, "ward"])),
            )
            for _ in range(5)
        )
        zones = Zone(id="ward"), Zone(id="hall")
        return Scene(zones=zones, entities=entities, roads=RoadGraph(nodes=nodes, roads=roads))
    corners = st.tuples(*[st.integers(0, 4)] * 2, *[st.integers(1, 3)] * 2)
    boxes = (draw(corners) for _ in range(draw(st.integers(0, 3))))
    areas = (Area(corners=((x, y), (x + w, y), (x + w, y + h), (x, y + h))) for x, y, w, h in boxes)
    return Scene(
        entities=entities, keep_outs=tuple(KeepOut(id=f"k{number}", area=area) for number, area in enumerate(areas))
    )


@st.composite
def cases(draw: st.DrawFn) -> tuple[Instance, RobotType, Scene]:
    steps = st.one_of(
        st.builds(lambda name: work(1, at=name, uses={"energy_j": 1}), st.sampled_from([*"pqs", None])),
        st.builds(move, st.sampled_from("pqs")),
    )
    parts = [Part(f"a{n}", "r", draw(st.lists(steps, min_size=1, max_size=2))) for n in range(draw(st.integers(1, 3)))]
    members = tuple(
        Robot(
            id=f"r{number}",
            position=draw(st.one_of(SPOTS, SPOTS, SPOTS, st.none())),
            remaining={"energy_j": draw(st.integers(0, 12))},
        )
        for number in range(draw(st.integers(1, 2)))
    )
    world = draw(worlds())
    zones = draw(st.sampled_from([None, ("hall",)])) if world.zones else None
    kind = robots(
        "r", speed=draw(st.sampled_from([None, 1.0])), uses_per_m={"energy_j": 1}, robots=members, zones=zones
    )
    return mission(parts), kind, world


def affordable(made: Instance, kind: RobotType, world: Scene) -> bool:
    """Whether some robots, in some order of roles, last for everything, by trying all."""
    roles: dict[int, list[Action]] = {}
    for node in made.tree.nodes:
        if node.action is not None:
            roles.setdefault(node.action.role, []).append(node.action)
    return any(
        all(
            _lasts(
                robot, kind, world, [roles[role] for role, taker in zip(roles, takers, strict=True) if taker == robot]
            )
            for robot in kind.robots
        )
        for takers in product(kind.robots, repeat=len(roles))
    )


def _lasts(robot: Robot, kind: RobotType, world: Scene, roles: Sequence[list[Action]]) -> bool:
    model = TravelModel(world)
    for order in permutations(roles):
        used = sum(_used([action for role in order for action in role], robot, kind, world, model))
        if used <= robot.remaining["energy_j"] + 1e-9:
            return True
    return False


def _used(
    actions: Sequence[Action], robot: Robot, kind: RobotType, world: Scene, model: TravelModel
) -> Iterator[float]:
    here = start_of(robot, world)
    for action in actions:
        yield action.uses.get("energy_j", 0.0)
        goal = None if action.at is None else world.by_id[action.at].position
        if here is not None and goal is not None:
            leg = model.leg(kind, here, goal)
            yield leg.distance_m if isinstance(leg, Leg) else float("inf")
        if goal is not None or action.moves:
            here = goal


@settings(max_examples=600, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)
@given(cases())
def test_what_is_claimed_holds_however_roles_are_shared_and_ordered(case: tuple[Instance, RobotType, Scene]) -> None:
    made, kind, world = case
    if claims(made, world, kind):
        assert not affordable(made, kind, world)
