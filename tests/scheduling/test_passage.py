"""Roads and lifts that robots share: held on the whole way, by every scheduler, with numbers by hand."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from random import Random
from typing import Any

import pytest

from missiontree.checking import check
from missiontree.mission.charger import Charger
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.plan import Plan
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.shared_resource import SharedResource
from missiontree.mission.tree import Link, MissionTree
from missiontree.mission.ways import Lift, Road, RoadGraph, RoadNode
from missiontree.rechecking import recheck
from missiontree.reporting.critical.chain import chain_of
from missiontree.reporting.critical.parts import parts_of
from missiontree.scheduling import SCHEDULERS
from tests.builders import brief_of, flat_tree, routine_node
from tests.checking.plans import made

EVERY = pytest.mark.parametrize("scheduler", SCHEDULERS)
GATE = SharedResource(id="gate", label="Gate")


def corridor(capacity: int = 1, **roads: Any) -> Scene:
    """West (0 m) and east (20 m), joined by one road; two people in the east."""
    places = {"west": 0, "east": 20}
    return Scene(
        places=tuple(Entity(id=name, kind="place", position=Position(x_m, 0)) for name, x_m in places.items()),
        entities=tuple(Entity(id=name, kind="person", place="east") for name in ("ann", "bob")),
        roads=RoadGraph(roads=(Road(ends=("west", "east"), resource="gate"),), **roads),
        resources=(replace(GATE, capacity=capacity),),
    )


def planned(scene: Scene, scheduler: str, tree: MissionTree | None = None, **more: Any) -> Plan:
    """Two searches in the east by two robots that start in the west, 1 m/s; a search takes 30 s of which 20 s are the way."""
    kind = RobotType(id="r", count=2, capabilities={"search": 1.0}, limits={"max_speed_mps": 1.0}, place="west")
    tree = tree or flat_tree(*(routine_node(name, "Search", agent=name) for name in ("ann", "bob")))
    return made(tree, brief_of(tree, Fleet((kind,)), scene=scene, **more), k=1, scheduler=scheduler)


def ways(plan: Plan) -> list[tuple[float, float]]:
    return sorted((leg.start_s, leg.end_s) for leg in plan.schedules[0].legs if leg.distance_m)


@EVERY
def test_one_sets_out_when_the_other_has_arrived(scheduler: str) -> None:
    """With room for one the second is on its way from when the first is there; with room for two both go at once."""
    alone, together = planned(corridor(), scheduler), planned(corridor(2), scheduler)
    (first, second), (one, other) = ways(alone), ways(together)
    assert second[0] >= first[1]
    assert one == other
    for plan in (alone, together):
        assert check(plan) == ()
        assert recheck(plan) == []


@EVERY
def test_the_way_home_waits_for_its_turn(scheduler: str) -> None:
    plan = planned(corridor(), scheduler, return_home=True)
    spans = sorted([*ways(plan), *((leg.start_s, leg.end_s) for leg in plan.schedules[0].returns)])
    assert len(spans) >= 2
    assert all(later[0] >= earlier[1] for earlier, later in pairwise(spans))
    assert check(plan) == ()


def test_a_bound_leaves_ways_out_of_account_and_is_never_above_what_is_least() -> None:
    """One robot could do both without a wait, so nothing longer than that is proven."""
    plan = planned(corridor(), "cpsat")
    certificate = plan.schedules[0].certificate
    assert certificate.bound is not None
    assert certificate.bound <= planned(corridor(2), "cpsat").schedules[0].makespan_s + 1e-9


def test_a_lift_is_held_between_any_two_of_its_stops_and_a_road_in_both_directions() -> None:
    nodes = tuple(RoadNode(id=f"n{floor}", position=Position(0, 0, f"f{floor}")) for floor in range(3))
    lift = Lift(id="lift", stops=("n0", "n1", "n2"), ride_s=5, resource="gate")
    graph = RoadGraph(nodes=nodes, roads=(Road(ends=("n0", "west"), resource="gate", length_m=1),), lifts=(lift,))
    west = Entity(id="west", kind="place", position=Position(1, 0))
    scene = Scene(places=(west,), roads=graph, resources=(GATE,))
    assert scene.passed(("n0", "n2")) == scene.passed(("n2", "n1")) == scene.passed(("west", "n0")) == ("gate",)
    assert scene.passed(("west",)) == scene.passed(()) == scene.passed(("west", "n2")) == ()


@pytest.mark.parametrize("what", ["road", "lift"])
def test_a_road_or_lift_that_names_no_shared_resource_is_refused(what: str) -> None:
    place = Entity(id="p", kind="place", position=Position(0, 0))
    other = Entity(id="q", kind="place", position=Position(0, 9))
    graph = (
        RoadGraph(roads=(Road(ends=("p", "q"), resource="gat"),))
        if what == "road"
        else RoadGraph(lifts=(Lift(id="up", stops=("p", "q"), ride_s=1, resource="gat"),))
    )
    with pytest.raises(ValueError, match="names 'gat', which is no shared resource of the scene; it has gate"):
        Scene(places=(place, other), roads=graph, resources=(GATE,))


def dock(capacity: int = 1) -> Scene:
    """The corridor, and behind the east, 5 m on, a charger at the end of a track of its own that has room for so many."""
    scene = corridor(2)
    end = Entity(id="dock", kind="place", position=Position(25, 0))
    assert scene.roads is not None
    roads = replace(scene.roads, roads=(*scene.roads.roads, Road(ends=("east", "dock"), resource="track")))
    return replace(
        scene,
        places=(*scene.places, end),
        roads=roads,
        resources=(*scene.resources, SharedResource(id="track", capacity=capacity)),
        chargers=(Charger(id="plug", place="dock", rate_per_s=10, capacity=2),),
    )


def plugged(scene: Scene, scheduler: str) -> Plan:
    """Both search in the east, 20 J there of 30 J; home they need 20 J more, and refill behind the east."""
    kind = RobotType(
        id="r",
        count=2,
        capabilities={"search": 1.0},
        limits={"max_speed_mps": 1.0, "energy_j": 30.0},
        uses_per_m={"energy_j": 1.0},
        place="west",
    )
    tree = flat_tree(
        *(routine_node(name, "Search", agent=name) for name in ("ann", "bob")),
        links=(Link("ann", "bob", "different_robot"),),
    )
    brief = brief_of(tree, Fleet((kind,)), scene=scene, return_home=True)
    return made(tree, brief, k=1, scheduler=scheduler)


@EVERY
def test_the_way_to_a_charger_waits_for_its_turn(scheduler: str) -> None:
    """
    Both are done in the east at once, with 10 J left, and at the charger with 5 J; home from there it is 25 m: they take in 20 J, in 2 s.
    On the track there is room for one. The first holds it for 5 s there and for the 25 s home, so the other sets out 32 s later.
    """
    plan = plugged(dock(), scheduler)
    over = max(one.end_s for one in plan.schedules[0].actions)
    legs = sorted((one.leg.start_s, one.leg.end_s) for one in plan.schedules[0].recharges if one.leg is not None)
    assert legs == [(over, over + 5), (over + 32, over + 37)]
    assert [round(one.amount, 6) for one in plan.schedules[0].recharges] == [20, 20]
    wide = plugged(dock(2), scheduler)
    assert [one.leg.start_s for one in wide.schedules[0].recharges if one.leg is not None] == [over, over]
    for made_plan in (plan, wide):
        assert check(made_plan) == ()
        assert recheck(made_plan) == []


def test_the_chain_tells_of_waits_for_the_track() -> None:
    """The last to come home refilled later since the track was taken; without chargers the last waits for the corridor."""
    plan = plugged(dock(), "greedy")
    assert [(step.kind, step.bond) for step in chain_of(plan, plan.schedules[0]).steps][-2:] == [
        ("refill", "robot"),
        ("home", "refill"),
    ]


def test_the_chain_tells_of_a_way_home_that_waits() -> None:
    """
    The slow one goes through the corridor first, from 5 to 45 s, and is done in the east at 107 s; the quick one comes later, gets there at
    65 s and is done at 127 s. It waits until the slow one is home, at 147 s.
    """
    kinds = (
        RobotType(
            id=name,
            count=1,
            capabilities={"search": 0.9},
            limits={"max_speed_mps": speed},
            place="west",
            available_from_s=since,
        )
        for name, speed, since in (("slow", 0.5, 0.0), ("quick", 1.0, 30.0))
    )
    tree = flat_tree(
        *(routine_node(name, "Search", agent=name) for name in ("ann", "bob")),
        links=(Link("ann", "bob", "different_robot"),),
    )
    brief = brief_of(tree, Fleet(tuple(kinds)), scene=corridor(), return_home=True)
    plan = made(tree, brief, k=1, scheduler="greedy")
    *_, wait, home = parts_of(plan, plan.schedules[0])
    assert (wait.what, wait.start_s, wait.end_s) == (
        "nothing: the way home waits for room in what robots share",
        127,
        147,
    )
    assert (home.robot, home.what, home.end_s) == ("quick-1", "the way home", 167)


def test_both_checkers_see_two_on_the_way_to_a_charger() -> None:
    """Room for two taken away afterwards: both set out at once, on a track for one."""
    plan = plugged(dock(2), "greedy")
    narrow = replace(plan, brief=replace(plan.brief, scene=dock()))
    assert "resource_overfull" in {one.rule for one in check(narrow)}
    assert "core_shared" in {one.rule for one in recheck(narrow)}


@pytest.mark.parametrize("seed", range(30))
def test_random_teams_between_chargers_and_narrow_roads_keep_every_rule(seed: int) -> None:
    """A line of five places, narrow here and there, two chargers, two to four searches: whatever is scheduled, both checkers pass."""
    draw = Random(f"passage {seed}")  # noqa: S311 - luck for tests, not for secrets
    names = [f"p{number}" for number in range(5)]
    places = tuple(Entity(id=name, kind="place", position=Position(8 * x, 0)) for x, name in enumerate(names))
    people = [f"who{number}" for number in range(draw.randint(2, 4))]
    roads = tuple(Road(ends=ends, resource=draw.choice([None, "gate", "track"])) for ends in pairwise(names))
    scene = Scene(
        places=places,
        entities=tuple(Entity(id=name, kind="person", place=draw.choice(names)) for name in people),
        roads=RoadGraph(roads=roads),
        resources=(GATE, SharedResource(id="track", capacity=draw.randint(1, 2))),
        chargers=tuple(
            Charger(id=f"plug{number}", place=draw.choice(names), rate_per_s=draw.choice([2, 10]))
            for number in range(2)
        ),
    )
    kind = RobotType(
        id="r",
        count=draw.randint(1, 3),
        capabilities={"search": 1.0},
        limits={"max_speed_mps": 1.0, "energy_j": float(draw.randint(30, 60))},
        uses_per_m={"energy_j": 1.0},
        place=draw.choice(names),
    )
    tree = flat_tree(*(routine_node(name, "Search", agent=name) for name in people))
    brief = brief_of(tree, Fleet((kind,)), scene=scene, return_home=draw.random() < 0.5)
    plan = made(tree, brief, k=1, scheduler=draw.choice(["greedy", "auto"]))
    assert check(plan) == ()
    assert recheck(plan) == []
