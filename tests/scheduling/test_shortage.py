"""A run that comes to a halt for want of a budget says which, how much is left of it, and what the next role takes."""

from __future__ import annotations

from typing import Any

import pytest

from missiontree.mission.control import Control
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.mission.ways import Road, RoadGraph
from missiontree.scheduling import SCHEDULERS
from tests.scheduling.instances import Part, at, mission, robots, scene, work


def both_ways(fleet_limit: float | None = None, **limits: Any) -> Schedule:
    """Work at 10 m and at -10 m for one robot at 0 that uses 1 J a metre: the first takes 10 J, and the other 20 J after it."""
    made = mission([Part("p", "r", [work(1, at="p")]), Part("q", "r", [work(1, at="q")])])
    kind = robots("r", speed=1, position=at(0), uses_per_m={"energy_j": 1.0}, **limits)
    fleet = Fleet((kind,), total_limits={} if fleet_limit is None else {"energy_j": fleet_limit})
    return SCHEDULERS["greedy"](made.tree, made.alternative, fleet, scene(p=10, q=-10), Control())


@pytest.mark.parametrize(
    ("schedule", "whose"),
    [
        (both_ways(limits={"max_speed_mps": 1.0, "energy_j": 25.0}), "r-1"),
        (both_ways(total_limits={"energy_j": 25.0}), "all robots of type 'r' together"),
        (both_ways(25.0), "all robots together"),
    ],
)
def test_the_budget_that_does_not_last_is_told_with_what_is_left_of_it(schedule: Schedule, whose: str) -> None:
    assert schedule.status == "infeasible"
    reason = next(one for one in schedule.reasons if one.rule == "budget_exceeded")
    first = "q" if reason.node == "q.0" else "p"
    assert reason.message == f"'{first}.0' takes 20 of energy_j, and of the 25 that {whose} may use 15 is left."
    assert (reason.found, reason.needed) == ("energy_j 25", "energy_j 30")


def test_nothing_is_said_of_budgets_where_a_link_keeps_robots_from_a_role() -> None:
    """Two parts for different robots, of which there is one with budget enough for both."""
    parts = [Part("p", "r", [work(1, at="p")]), Part("q", "r", [work(1, at="q")])]
    made = mission(parts, [("p", "q", "different_robot")])
    kind = robots("r", speed=1, position=at(0), uses_per_m={"energy_j": 1.0}, limits={"energy_j": 99.0})
    result = SCHEDULERS["greedy"](made.tree, made.alternative, Fleet((kind,)), scene(p=10, q=-10), Control())
    assert result.status == "infeasible"
    assert "budget_exceeded" not in {reason.rule for reason in result.reasons}


def test_a_way_that_is_closed_from_where_the_robot_is_by_then_is_told() -> None:
    """The only road leads from hall to yard, one way: once the work in the yard is done there is no way back to the hall."""
    parts = [Part("far", "r", [work(1, at="yard")]), Part("near", "r", [work(1, at="hall")])]
    made = mission(parts, [("far", "near")])
    ends = (Entity(id="hall", kind="place", position=at(0)), Entity(id="yard", kind="place", position=at(9)))
    world = Scene(places=ends, roads=RoadGraph(roads=(Road(ends=("hall", "yard"), one_way=True),)))
    fleet = Fleet((robots("r", speed=1, position=at(0)),))
    result = SCHEDULERS["greedy"](made.tree, made.alternative, fleet, world, Control())
    assert result.status == "infeasible"
    reason = next(one for one in result.reasons if one.rule == "unreachable")
    assert reason.message.startswith("From where it is by then, r-1 cannot get to hall for 'near.0': ")
    assert "hall - yard" in reason.message
