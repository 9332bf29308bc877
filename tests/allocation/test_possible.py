"""What can be done at all: gates, and the least use of budgets."""

from __future__ import annotations

from missiontree.allocation.flat import Flat, flatten
from missiontree.allocation.possible import possible_nodes, reasons_of, structurally_possible
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from tests.builders import Spec, and_, grounded, leaf, trivial_fleet, xor_


def flat_of(root: Spec, fleet: Fleet | None = None) -> Flat:
    return flatten(grounded(root), fleet or trivial_fleet(), Weights())


def user(label: str, energy: float, robot_type: str = "r", role: str = "") -> Spec:
    return leaf(label, robot_type, role, uses={"energy_j": energy})


def test_an_and_with_an_impossible_child_is_impossible() -> None:
    # Preorder: 0 xor, 1 and, 2 leaf, 3 impossible xor, 4 leaf.
    flat = flat_of(xor_(and_(leaf("a"), xor_()), leaf("b")))
    assert structurally_possible(flat) == [True, False, True, False, True]


def test_an_and_adds_up_and_an_xor_takes_the_least() -> None:
    # Least use: 2 + min(3, 4) = 5, and there are 5; with 4.9 it is impossible.
    root = and_(user("a", 2), xor_(user("b", 3), user("c", 4)))
    assert possible_nodes(flat_of(root, trivial_fleet(limits={"energy_j": 5}))).possible[0]
    assert not possible_nodes(flat_of(root, trivial_fleet(limits={"energy_j": 4.9}))).possible[0]


def test_an_xor_with_a_way_of_another_type_needs_nothing_of_this_one() -> None:
    fleet = trivial_fleet(("r", "s"), limits={"energy_j": 3})
    # r alone would need 2 + 2 of 3, but s can do the second: 2 and 2.
    assert possible_nodes(flat_of(and_(user("a", 2), xor_(user("b", 2), user("c", 2, "s"))), fleet)).possible[0]


def test_what_all_types_together_lack() -> None:
    fleet = trivial_fleet(("r", "s"), limits={"energy_j": 3})
    ways = [xor_(user(f"r{number}", 2.5), user(f"s{number}", 2.5, "s")) for number in range(3)]
    # No single type must do anything, but three times 2.5 is more than 3 + 3.
    flat = flat_of(and_(*ways), fleet)
    found = possible_nodes(flat)
    assert not found.possible[0]
    assert reasons_of(flat, found, "error")[0].message.endswith("and types r and s together may use 6.")


def test_one_role_needs_one_robot() -> None:
    # Two robots of 3 have 6 together, but the role uses 4 and one robot fills it.
    fleet = trivial_fleet({"r": 2}, limits={"energy_j": 3})
    flat = flat_of(and_(user("a", 2, role="x"), user("b", 2, role="x")), fleet)
    found = possible_nodes(flat)
    assert not found.possible[0]
    (reason,) = reasons_of(flat, found, "error")
    assert (reason.rule, reason.robot, reason.found, reason.needed) == (
        "budget_exceeded",
        "r",
        "energy_j 3",
        "energy_j 4",
    )
    assert possible_nodes(flat_of(and_(user("a", 2, role="x"), user("b", 2, role="y")), fleet)).possible[0]


def test_impossible_ways_do_not_count_as_the_least() -> None:
    # c would need 0, but stands beside an impossible sibling; so b's 3 is the least, and 3 + 3 is more than 5.
    root = and_(user("a", 3), xor_(user("b", 3), and_(user("c", 0), xor_())))
    assert not possible_nodes(flat_of(root, trivial_fleet(limits={"energy_j": 5}))).possible[0]
