"""Roads and lifts that robots share: held on the whole way, by every scheduler, with numbers by hand."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
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
from missiontree.mission.tree import MissionTree
from missiontree.mission.ways import Lift, Road, RoadGraph, RoadNode
from missiontree.rechecking import recheck
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


def test_chargers_beside_such_roads_are_refused() -> None:
    """Ways to chargers hold nothing yet, and what is accepted and then ignored would make a plan look better than it is."""
    with pytest.raises(ValueError, match="ways to chargers do not wait for shared resources"):
        replace(corridor(), chargers=(Charger(id="plug", place="west", stock="energy_j", rate_per_s=1.0),))
