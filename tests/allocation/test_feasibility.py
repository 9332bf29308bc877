"""Small selections whose feasibility can be seen by eye."""

from __future__ import annotations

from missiontree.allocation.feasibility import Feasibility, Verdict
from missiontree.allocation.flat import flatten
from missiontree.allocation.selection import select
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.grounded import GroundedTree
from tests.builders import Spec, and_, grounded, leaf, trivial_fleet, xor_


def decide(tree: GroundedTree, fleet: Fleet, steps: int = 1000, **taken: int) -> Verdict:
    """Decide the selection with the named positions at XORs (by label)."""
    flat = flatten(tree, fleet, Weights())
    positions = {index: taken[node.label] for index, node in enumerate(tree.nodes) if node.label in taken}
    return Feasibility(flat, steps).decide(select(flat, positions, [True] * len(tree.nodes)))


def users(*energies: float, role: str = "") -> list[Spec]:
    return [leaf(f"l{index}", role=role, uses={"energy_j": used}) for index, used in enumerate(energies)]


def rule_of(verdict: Verdict) -> str:
    assert verdict.answer == "no"
    assert verdict.reason is not None
    return verdict.reason.rule


def test_robots_of_a_type_share_the_work() -> None:
    # 3 + 2 and 4 fit two robots of 5; a third role of 2 does not, though 11 - 10 is all that is lacking.
    fleet = trivial_fleet({"r": 2}, limits={"energy_j": 5})
    assert decide(grounded(and_(*users(3, 2, 4))), fleet).answer == "yes"
    verdict = decide(grounded(and_(*users(3, 2, 4, 2))), fleet)
    assert rule_of(verdict) == "budget_exceeded"
    assert verdict.reason is not None
    assert (verdict.reason.found, verdict.reason.needed) == ("energy_j 10", "energy_j 11")


def test_the_witness_uses_named_robots_by_what_they_have_left() -> None:
    robots = (Robot(id="weak", remaining={"energy_j": 2}), Robot(id="strong", remaining={"energy_j": 9}))
    fleet = Fleet((RobotType(id="r", robots=robots),))
    # 8 fits the strong one only, which then has 1 left; so 2 goes to the weak one.
    assert decide(grounded(and_(*users(2, 8))), fleet).witness == ((0, "weak"), (1, "strong"))


def test_the_total_of_a_type_binds_beside_the_robots() -> None:
    fleet = trivial_fleet({"r": 2}, limits={"energy_j": 5}, total_limits={"energy_j": 6})
    assert decide(grounded(and_(*users(3, 3))), fleet).answer == "yes"
    assert rule_of(decide(grounded(and_(*users(3, 4))), fleet)) == "budget_exceeded"


def test_robots_are_reused_and_never_used_up() -> None:
    assert decide(grounded(and_(*users(1, 1, 1))), trivial_fleet(limits={"energy_j": 3})).answer == "yes"


def test_a_team_needs_as_many_robots_as_roles() -> None:
    tree = grounded(and_(leaf("a"), leaf("b")), teams={"a": 7, "b": 7})
    assert decide(tree, trivial_fleet({"r": 2})).witness == ((0, "r-1"), (1, "r-2"))
    assert rule_of(decide(tree, trivial_fleet({"r": 1}))) == "too_few_robots"


def test_two_teams_may_have_the_same_robots() -> None:
    tree = grounded(and_(*(leaf(name) for name in "abcd")), teams={"a": 0, "b": 0, "c": 1, "d": 1})
    assert decide(tree, trivial_fleet({"r": 2})).answer == "yes"


def test_same_robot_adds_the_uses_of_both_sides() -> None:
    tree = grounded(and_(*users(3, 3)), [("l0", "l1", "same_robot")])
    assert rule_of(decide(tree, trivial_fleet({"r": 2}, limits={"energy_j": 5}))) == "budget_exceeded"
    witness = decide(tree, trivial_fleet({"r": 2}, limits={"energy_j": 6})).witness
    assert witness[0][1] == witness[1][1]


def test_same_robot_over_two_types_cannot_be() -> None:
    tree = grounded(and_(leaf("a"), leaf("b", "s")), [("a", "b", "same_robot")])
    assert rule_of(decide(tree, trivial_fleet(("r", "s")))) == "same_robot_broken"


def test_same_robot_takes_in_all_roles_below_both_nodes() -> None:
    # a alone under one end, b and c under the other, and c is of another type.
    tree = grounded(
        and_(and_(leaf("a"), label="left"), and_(leaf("b"), leaf("c", "s"), label="right")),
        [("left", "right", "same_robot")],
    )
    assert rule_of(decide(tree, trivial_fleet(("r", "s")))) == "same_robot_broken"


def test_different_robot_needs_two() -> None:
    tree = grounded(and_(leaf("a"), leaf("b")), [("a", "b", "different_robot")])
    assert rule_of(decide(tree, trivial_fleet({"r": 1}))) == "too_few_robots"
    assert decide(tree, trivial_fleet({"r": 2})).answer == "yes"


def test_same_and_different_at_once_cannot_be() -> None:
    tree = grounded(and_(leaf("a"), leaf("b")), [("a", "b", "different_robot"), ("a", "b", "same_robot")])
    assert rule_of(decide(tree, trivial_fleet({"r": 2}))) == "different_robot_broken"


def test_a_link_binds_only_if_both_ends_are_selected() -> None:
    tree = grounded(and_(leaf("a"), xor_(leaf("b", "s"), leaf("c", "s"), label="x")), [("a", "b", "same_robot")])
    assert decide(tree, trivial_fleet(("r", "s")), x=1).answer == "yes"
    assert rule_of(decide(tree, trivial_fleet(("r", "s")), x=0)) == "same_robot_broken"


def test_a_role_is_filled_by_one_type() -> None:
    tree = grounded(and_(leaf("a", "r", "x"), leaf("b", "s", "x")))
    assert rule_of(decide(tree, trivial_fleet(("r", "s")))) == "role_torn"


def test_too_few_steps_leave_it_undecided() -> None:
    fleet = trivial_fleet({"r": 2}, limits={"energy_j": 5})
    assert decide(grounded(and_(*users(3, 2, 4))), fleet, steps=1) == Verdict("undecided")
