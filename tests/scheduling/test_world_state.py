"""Where robots and entities are as actions are done."""

from __future__ import annotations

from typing import Any

from missiontree.mission.estimate import Estimate
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import Action
from missiontree.scheduling.trips import Trips
from missiontree.scheduling.world_state import WorldState
from tests.scheduling.instances import Part, at, mission, move, robots, scene, work


def action(given: dict[str, Any]) -> Action:
    return Action(name="a", text="a", role=0, robot_type="r", capability="work", estimate=Estimate(1.0), **given)


def state() -> WorldState:
    fleet = Fleet((robots("r", position=at(1), limits={"energy_j": 9}),))
    return WorldState(fleet, Trips(fleet, scene(box=0, p=5, lost=None)))


def test_what_is_brought_is_at_the_new_place_afterwards() -> None:
    world = state()
    robot = world.robots["r-1"]
    world.do(robot, action(move("p", "box")), 10, 40)
    assert (robot.spot, world.entity("box").spot, world.entity("box").since) == (at(5), at(5), 40)
    # who wants the box now cannot start before it has arrived
    assert world.not_before(action(work(1, at="box"))) == 40


def test_who_moves_an_entity_waits_for_those_who_use_it() -> None:
    world = state()
    world.do(world.robots["r-1"], action(work(1, at="box")), 0, 25)
    assert world.not_before(action(move("p", "box"))) == 25
    assert world.not_before(action(work(1, at="box"))) == 0


def test_unknown_places_leave_workers_and_movers_nowhere() -> None:
    world = state()
    world.do(world.robots["r-1"], action(work(1, at="lost")), 0, 1)
    assert world.robots["r-1"].spot is None
    world.do(world.robots["r-1"], action(move("lost", "box")), 1, 2)
    assert world.robots["r-1"].spot is None
    assert world.entity("box").spot is None


def test_budgets_start_full() -> None:
    assert state().robots["r-1"].left == {"energy_j": 9}


def test_who_works_at_a_thing_that_is_taken_away_meanwhile_stays_where_it_was() -> None:
    """One takes the box from 2 to 9; the other works jointly with it at the box, and is at 2 afterwards, not at 9."""
    made = mission([Part("a", "r", [move("p", "box", sync=0)]), Part("b", "s", [work(1, at="box", sync=0)])])
    fleet = Fleet((robots("r", position=at(2)), robots("s", position=at(2))))
    world = WorldState(fleet, Trips(fleet, scene(box=2, p=9)))
    actions = [made.tree.action(made.node[name]) for name in ("a.0", "b.0")]
    world.do_jointly([(world.robots["r-1"], actions[0]), (world.robots["s-1"], actions[1])], 0, 7)
    assert [world.robots[name].spot for name in ("r-1", "s-1")] == [at(9), at(2)]
    assert world.entity("box").spot == at(9)
