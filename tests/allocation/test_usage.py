"""What an alternative uses of every limit."""

from __future__ import annotations

from dataclasses import replace

from missiontree.allocation.columns import flat_of_columns
from missiontree.allocation.flat import flatten
from missiontree.allocation.kbest import ExactKBest
from missiontree.allocation.usage import Use, uses_of
from missiontree.formats.importers.tree_grounded import fleet_of, grounded_of
from missiontree.mission.columns import WEIGHTS
from missiontree.mission.control import Control
from missiontree.mission.estimate import Estimate, Weights
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.grounded import Action, GroundedNode, GroundedTree, Role
from tests.formats.tree_files import read, small


def test_each_robot_is_told_of_beside_its_budget() -> None:
    """Leaves 2 and 4: robot 0 uses 4 of 8, robot 1 uses 1 of 3."""
    columns = read(small())
    best = ExactKBest()(grounded_of(columns), fleet_of(columns), WEIGHTS, 1, Control()).alternatives[0]
    assert uses_of(flat_of_columns(columns), best) == (
        Use("robot-0-1", False, "consumption", 4.0, 8.0),
        Use("robot-1-1", False, "consumption", 1.0, 3.0),
    )


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


def test_robots_of_a_type_are_told_of_one_by_one_and_together() -> None:
    tree, fleet = two_tasks()
    best = ExactKBest()(tree, fleet, Weights(), 1, Control()).alternatives[0]
    uses = uses_of(flatten(tree, fleet, Weights()), best)
    assert sorted(uses) == [
        Use("rover", True, "energy_j", 4.0, 5.0),
        Use("rover-1", False, "energy_j", 2.0, 3.0),
        Use("rover-2", False, "energy_j", 2.0, 3.0),
    ]


def test_without_a_witness_a_type_is_told_of_as_one() -> None:
    """Both together may use the smaller of 3 + 3 and 5."""
    tree, fleet = two_tasks()
    best = ExactKBest()(tree, fleet, Weights(), 1, Control()).alternatives[0]
    uses = uses_of(flatten(tree, fleet, Weights()), replace(best, witness=()))
    assert uses == (Use("rover", True, "energy_j", 4.0, 5.0),)


def test_something_of_nothing_is_all_of_it() -> None:
    assert Use("a", False, "x", 0.0, 0.0).share == 0.0
    assert Use("a", False, "x", 1.0, 0.0).share == 1.0
    assert Use("a", False, "x", 1.0, 4.0).share == 0.25
