"""The flat form: integers where things are added up, and only limits that limit something."""

from __future__ import annotations

from dataclasses import replace

import pytest

from missiontree.allocation.flat import AMOUNT_SCALE, EVERYBODY, amount, flatten
from missiontree.errors import InputError
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet, Robot, RobotType
from tests.builders import and_, grounded, index_of, leaf, trivial_fleet, xor_


def test_amounts_add_up_as_people_write_them() -> None:
    """As floats 0.1 + 0.2 is more than 0.3; as billionths it is not."""
    assert amount(0.1) + amount(0.2) == amount(0.3)
    assert amount(2.5) == 5 * AMOUNT_SCALE // 2


def test_columns_follow_the_tree() -> None:
    tree = grounded(
        and_(leaf("a", quality=1.5, duration_s=2), xor_(leaf("b", "s")), label="top"),
        links=[("a", "xor", "same_robot"), ("a", "b", "different_robot"), ("a", "xor")],
    )
    flat = flatten(tree, trivial_fleet(("r", "s")), Weights(1, 0.25, 0))
    a, b = index_of(tree.nodes, "a"), index_of(tree.nodes, "b")
    # 1.5 - 0.25 * 2 = 1.0 for a, 1.0 for b, in millionths.
    assert (flat.utility[0], flat.utility[a], flat.utility[b]) == (0, 1_000_000, 1_000_000)
    assert (flat.role[0], flat.robot_type[b]) == (-1, "s")
    assert flat.parent[b] == index_of(tree.nodes, "xor")
    # A precedence is the scheduler's business.
    assert (flat.same_robot, flat.different_robot) == (((a, flat.parent[b]),), ((a, b),))
    assert flat.leaves_under[flat.parent[b]] == {b}


def test_uses_without_a_limit_are_left_out() -> None:
    tree = grounded(leaf("a", uses={"energy_j": 2, "water_l": 3}))
    assert flatten(tree, trivial_fleet(limits={"energy_j": 5}), Weights()).uses == ({"energy_j": 2 * AMOUNT_SCALE},)


def test_what_a_leaf_takes_counts_for_its_type_and_for_the_mission() -> None:
    """Each purse is told once, by number; the mission shares water alone, and a leaf without uses takes nothing."""
    root = and_(leaf("a", "r", uses={"energy_j": 2, "water_l": 1}), leaf("b", "s", uses={"water_l": 3}), leaf("c", "r"))
    fleet = trivial_fleet(("r", "s"), limits={"energy_j": 9, "water_l": 9})
    charges = flatten(grounded(root), replace(fleet, total_limits={"water_l": 4}), Weights()).charges
    assert charges.purses == (("r", "energy_j"), ("r", "water_l"), (EVERYBODY, "water_l"), ("s", "water_l"))
    billion = 10**9
    assert list(charges.of_leaf) == [
        (), ((0, 2 * billion), (1, billion), (2, billion)), ((3, 3 * billion), (2, 3 * billion)), (),
    ]  # fmt: skip


def test_what_a_robot_has_left_overrides_its_type() -> None:
    robots = (Robot(id="x", remaining={"energy_j": 1}), Robot(id="y"))
    fleet = Fleet((RobotType(id="r", limits={"energy_j": 5}, total_limits={"energy_j": 4}, robots=robots),))
    stock = flatten(grounded(leaf("a", uses={"energy_j": 1})), fleet, Weights()).stocks["r"]
    assert stock.budgets == ({"energy_j": AMOUNT_SCALE}, {"energy_j": 5 * AMOUNT_SCALE})
    # All robots together have 1 + 5, the type's total is 4; one robot alone has no more than min(5, 4).
    assert (stock.pooled("energy_j"), stock.largest("energy_j")) == (4 * AMOUNT_SCALE, 4 * AMOUNT_SCALE)


def test_one_robot_without_a_limit_makes_the_type_unlimited() -> None:
    fleet = Fleet((RobotType(id="r", robots=(Robot(id="x", remaining={"energy_j": 1}), Robot(id="y"))),))
    stock = flatten(grounded(leaf("a", uses={"energy_j": 1})), fleet, Weights()).stocks["r"]
    assert (stock.pooled("energy_j"), stock.largest("energy_j")) == (None, None)


def test_an_unknown_type_is_named() -> None:
    with pytest.raises(InputError, match="'ghost', which the fleet does not have"):
        flatten(grounded(leaf("a", "ghost")), trivial_fleet(), Weights())
