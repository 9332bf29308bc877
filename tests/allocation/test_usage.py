"""What an alternative uses of every limit."""

from __future__ import annotations

from dataclasses import replace

from hypothesis import given, settings

from benchmarks.random_trees import Case
from missiontree.allocation.columns import flat_of_columns
from missiontree.allocation.exhaustive import Exhaustive
from missiontree.allocation.flat import flatten
from missiontree.allocation.kbest import ExactKBest
from missiontree.allocation.usage import Usage
from missiontree.formats.importers.tree_grounded import fleet_of, grounded_of
from missiontree.mission.alternative import Alternative, selected_leaves
from missiontree.mission.columns import WEIGHTS
from missiontree.mission.control import Control
from missiontree.mission.estimate import Estimate, Weights
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.grounded import Action, GroundedNode, GroundedTree, Role
from missiontree.mission.limit_use import LimitUse
from missiontree.mission.terms import NO_TERMS, Terms
from tests.formats.tree_files import read, small
from tests.strategies import cases


def test_each_robot_is_told_of_beside_its_budget() -> None:
    """Leaves 2 and 4: robot 0 uses 4 of 8, robot 1 uses 1 of 3."""
    columns = read(small())
    best = ExactKBest()(grounded_of(columns), fleet_of(columns), WEIGHTS, 1, Control()).alternatives[0]
    assert best.uses == (
        LimitUse("robot", "robot-0-1", "consumption", 4.0, 8.0),
        LimitUse("robot", "robot-1-1", "consumption", 1.0, 3.0),
    )
    robots = {filled.role: filled.robot for filled in best.witness}
    assert Usage(flat_of_columns(columns)).of((2, 4), robots) == best.uses


def two_tasks() -> tuple[GroundedTree, Fleet]:
    """Two actions that use 2 each, for two robots of one type that may use 3 each and 5 together."""
    nodes = [GroundedNode(parent=-1, kind="and", label="both")]
    for role in range(2):
        uses = {"energy_j": 2.0}
        action = Action(
            name="act",
            text="Act",
            role=role,
            robot_type="rover",
            capability="act",
            estimate=Estimate(1.0),
            uses=uses,
            uses_at_least=uses,
        )
        nodes.append(GroundedNode(parent=0, kind="action", label=f"task {role}", action=action))
    rover = RobotType(id="rover", count=2, limits={"energy_j": 3.0}, total_limits={"energy_j": 5.0})
    return GroundedTree(objective="", nodes=tuple(nodes), roles=(Role(label="a"), Role(label="b"))), Fleet((rover,))


def best_of(tree: GroundedTree, fleet: Fleet, terms: Terms = NO_TERMS) -> Alternative:
    flat = flatten(tree, fleet, Weights(), terms)
    return ExactKBest()(flat, fleet, Weights(), 1, Control()).alternatives[0]


def test_robots_of_a_type_are_told_of_one_by_one_and_together() -> None:
    assert best_of(*two_tasks()).uses == (
        LimitUse("robot", "rover-1", "energy_j", 2.0, 3.0),
        LimitUse("robot", "rover-2", "energy_j", 2.0, 3.0),
        LimitUse("type", "rover", "energy_j", 4.0, 5.0),
    )


def test_a_robot_that_uses_nothing_and_a_limit_that_nothing_uses_are_not_told_of() -> None:
    """One of the two could do both, with 4 of its 9; nothing uses water."""
    tree, fleet = two_tasks()
    red = Robot(id="red", remaining={"energy_j": 9.0, "water_l": 1.0})
    blue = Robot(id="blue", remaining={"energy_j": 1.0})
    named = replace(fleet.types[0], count=None, robots=(red, blue), limits={}, total_limits={"water_l": 4.0})
    assert best_of(tree, Fleet((named,))).uses == (LimitUse("robot", "red", "energy_j", 4.0, 9.0),)


def test_of_the_total_of_the_fleet_and_the_stock_of_the_scene_the_tighter_is_told_of() -> None:
    tree, fleet = two_tasks()
    whole = replace(fleet, total_limits={"energy_j": 4.5})
    assert best_of(tree, whole).uses[-1] == LimitUse("mission", "", "energy_j", 4.0, 4.5)
    assert best_of(tree, whole, Terms(stock={"energy_j": 4.25})).uses[-1] == LimitUse(
        "stock", "", "energy_j", 4.0, 4.25
    )
    assert best_of(tree, whole, Terms(stock={"energy_j": 4.75})).uses[-1] == LimitUse(
        "mission", "", "energy_j", 4.0, 4.5
    )


def test_without_a_witness_what_robots_have_each_is_added_up() -> None:
    """3 + 3 in all; 3 if no more than one may be in use."""
    tree, fleet = two_tasks()
    assert Usage(flatten(tree, fleet, Weights())).of((1, 2), {}) == (
        LimitUse("robots", "rover", "energy_j", 4.0, 6.0),
        LimitUse("type", "rover", "energy_j", 4.0, 5.0),
    )
    one = Fleet((replace(fleet.types[0], max_in_use=1),))
    assert Usage(flatten(tree, one, Weights())).of((1,), {})[0] == LimitUse("robots", "rover", "energy_j", 2.0, 3.0)


def test_without_limits_there_is_nothing_to_tell() -> None:
    tree, fleet = two_tasks()
    free = Fleet((replace(fleet.types[0], limits={}, total_limits={}),))
    assert best_of(tree, free).uses == ()


def test_something_of_nothing_is_all_of_it() -> None:
    assert LimitUse("robot", "a", "x", 0.0, 0.0).share == 0.0
    assert LimitUse("robot", "a", "x", 1.0, 0.0).share == 1.0
    assert LimitUse("robot", "a", "x", 1.0, 4.0).share == 0.25


@settings(max_examples=60, deadline=None)
@given(cases())
def test_what_is_counted_on_from_one_alternative_to_the_next_is_what_each_uses_by_itself(case: Case) -> None:
    flat = case.flat
    for alternative in Exhaustive()(flat, case.fleet, case.weights, 40, Control()).alternatives:
        leaves = selected_leaves(case.tree, alternative.choices)
        robots = {filled.role: filled.robot for filled in alternative.witness}
        assert alternative.uses == Usage(flat).of(leaves, robots)
        assert all(use.used <= use.limit for use in alternative.uses)
