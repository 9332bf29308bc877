"""Which limits clash: hand-made clashes of every kind of limit, and random ones held against the oracle."""

from __future__ import annotations

from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from benchmarks.random_rules import RULES
from benchmarks.random_trees import Case, random_case
from missiontree.allocation import clash_wording, clashing
from missiontree.allocation.any_alternative import any_alternative
from missiontree.allocation.clash_wording import reason_of, with_clash
from missiontree.allocation.clashing import Clash, clash_of, only
from missiontree.allocation.exhaustive import Exhaustive
from missiontree.allocation.flat import Flat, flatten
from missiontree.allocation.kbest import ExactKBest
from missiontree.allocation.limits import Limit, limits_of, without_limits
from missiontree.mission.alternative import Ranking
from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.reason import Reason
from missiontree.mission.terms import NO_TERMS, Terms
from tests.builders import Spec, and_, grounded, leaf, trivial_fleet, xor_

BUDGETS_OF_TWO = Fleet(
    (
        RobotType(id="cart", label="Cart", count=1, limits={"energy_j": 6}),
        RobotType(id="drone", label="Drone", count=2, limits={"energy_j": 4}),
    )
)


def flat_of(tree: GroundedTree, fleet: Fleet, terms: Terms = NO_TERMS) -> Flat:
    return flatten(tree, fleet, Weights(), terms)


def ranked(flat: Flat) -> Ranking:
    return ExactKBest()(flat, Fleet((RobotType(id="r", count=1),)), Weights(), 1, Control())


def told(tree: GroundedTree, fleet: Fleet, terms: Terms = NO_TERMS) -> Reason:
    """What stands first among the reasons of an impossible mission."""
    ranking = ranked(flat_of(tree, fleet, terms))
    assert ranking.status == "infeasible"
    assert ranking.reasons[0].rule == "limits_clash"
    return ranking.reasons[0]


def found(flat: Flat) -> Clash:
    clash = clash_of(flat, Control())
    assert clash is not None
    return clash


def loads(*uses: float) -> GroundedTree:
    return grounded(and_(*(leaf(f"l{place}", uses={"energy_j": use}) for place, use in enumerate(uses))))


def by_cart_or_drone(name: str, energy: float) -> Spec:
    return xor_(
        leaf(f"{name} by cart", "cart", name, uses={"energy_j": energy}),
        leaf(f"{name} by drone", "drone", name, uses={"energy_j": energy}),
        label=name,
    )


def test_one_robot_that_is_too_weak_is_told_with_what_is_needed_and_what_there_is() -> None:
    """Two crates of 450 J each, and the one robot has 600."""
    crates = grounded(
        and_(
            and_(
                leaf("first crate", "mule", uses={"energy_j": 450}),
                leaf("second crate", "mule", uses={"energy_j": 450}),
                label="Carry the two crates",
            ),
            leaf("look", "scout"),
        )
    )
    fleet = Fleet((RobotType(id="mule", count=1, limits={"energy_j": 600}), RobotType(id="scout", count=1)))
    reason = told(crates, fleet)
    assert reason.message == (
        'Whatever is chosen, "Carry the two crates" uses 900 of energy_j, and the only robot of type mule may use 600.'
    )
    assert (reason.robot, reason.found, reason.needed) == ("mule", "energy_j 600", "energy_j 900")
    assert (
        reason.hint
        == "Raise energy_j of type mule, add a robot of that type, or give the task another way of being done."
    )


def test_where_every_way_of_a_task_needs_too_much_the_cheapest_is_told() -> None:
    """Either way uses more than the 5 J of the mission: 7 or 6."""
    tree = grounded(
        and_(xor_(leaf("long", uses={"energy_j": 7}), leaf("short", uses={"energy_j": 6}), label="go"), leaf("look"))
    )
    fleet = Fleet(trivial_fleet().types, total_limits={"energy_j": 5})
    assert told(tree, fleet).message == (
        'Whatever is chosen, "go" uses 6 of energy_j, and all robots of the mission together may use 5.'
    )


def test_budgets_of_two_types_clash_together() -> None:
    """Three tasks of 4 J: the cart with 6 takes one, a drone with 4 one each. A fourth is too much; either type could take it."""
    tree = grounded(and_(*(by_cart_or_drone(name, 4) for name in "abcd")))
    reason = told(tree, BUDGETS_OF_TWO)
    assert reason.message == (
        "Together these cannot be kept: energy_j of type cart (6, 1 robot), and energy_j of type drone (4 each, 2 robots)."
    )
    assert reason.hint == "Each of these would be enough: raise energy_j of type cart, or raise energy_j of type drone."


def test_what_cannot_be_dealt_out_is_told_of_the_limit_alone() -> None:
    """Three loads of 3 J on two robots with 5: 9 of 10, and each takes one only."""
    reason = told(loads(3, 3, 3), trivial_fleet({"r": 2}, limits={"energy_j": 5}))
    assert reason.message == "Whatever is chosen, this cannot be kept: energy_j of type r (5 each, 2 robots)."
    assert reason.hint == "It would be enough to raise energy_j of type r."


def test_how_many_may_be_in_use_clashes_with_what_each_may_use() -> None:
    fleet = trivial_fleet({"r": 3}, limits={"energy_j": 5}, max_in_use=2)
    reason = told(loads(4, 4, 3), fleet)
    assert reason.message == (
        "Together these cannot be kept: at most 2 robots of type r in use, and energy_j of type r (5 each, 3 robots)."
    )
    assert reason.robot == "r"
    assert "raise max_in_use of type r" in reason.hint


def test_who_must_take_part_clashes_with_a_total() -> None:
    """The drone would use 3 J, and all drones together have 2."""
    tree = grounded(by_cart_or_drone("a", 3))
    fleet = Fleet((RobotType(id="cart", count=1), RobotType(id="drone", count=1, total_limits={"energy_j": 2})))
    reason = told(tree, fleet, Terms(require=("drone",)))
    assert reason.message == (
        "Together these cannot be kept: type drone must take part, and energy_j of all robots of type drone together (2)."
    )
    assert reason.hint == (
        "Each of these would be enough: take type drone off 'require', or raise energy_j in the total_limits of type drone."
    )


def test_who_is_left_out_clashes_with_what_the_others_may_use() -> None:
    """Two loads of 4 J for one of two robots with 5."""
    robots = (Robot(id="red"), Robot(id="blue"))
    fleet = Fleet((RobotType(id="rover", robots=robots, limits={"energy_j": 5}),))
    tree = grounded(and_(*(leaf(name, "rover", uses={"energy_j": 4}) for name in "ab")))
    reason = told(tree, fleet, Terms(without=("blue",)))
    assert reason.message == (
        "Together these cannot be kept: blue takes no part, and energy_j of type rover (5, 1 robot)."
    )
    assert "take blue off 'without'" in reason.hint


def test_a_robot_that_comes_back_counts_against_how_many_may_be_in_use() -> None:
    """Of three robots two may be in use, and one is left out: all three of these stand in the way of three loads."""
    robots = tuple(Robot(id=name) for name in ("red", "blue", "green"))
    fleet = Fleet((RobotType(id="r", robots=robots, limits={"energy_j": 5}, max_in_use=2),))
    flat = flat_of(loads(4, 4, 4), fleet, Terms(without=("green",)))
    left_out, in_use, energy = (
        Limit("left_out", "r", "green"),
        Limit("max_in_use", "r"),
        Limit("robots", "r", "energy_j"),
    )
    assert limits_of(flat) == (left_out, in_use, energy)
    assert without_limits(flat, [left_out]).stocks["r"].usable == 2
    assert without_limits(flat, [left_out, in_use]).stocks["r"].usable == 3
    # Either of the first two by itself forbids the third robot, so a clash needs one of them only.
    assert found(flat).limits in ((left_out, energy), (in_use, energy))
    assert found(flat).enough == (energy,)


@pytest.mark.parametrize(
    ("link", "phrase"),
    [("same_robot", 'one robot for "a" and "b"'), ("different_robot", 'different robots for "a" and "b"')],
)
def test_links_clash_with_budgets(link: str, phrase: str) -> None:
    """One robot has 3 J for 2 + 2; of two robots with 3 and 1 J only the first can do either."""
    tree = grounded(and_(*(leaf(name, uses={"energy_j": 2}) for name in "ab")), [("a", "b", link)])  # type: ignore[list-item]
    strong, other = (3, 3) if link == "same_robot" else (5, 1)
    robots = (Robot(id="p", remaining={"energy_j": strong}), Robot(id="q", remaining={"energy_j": other}))
    reason = told(tree, Fleet((RobotType(id="r", robots=robots),)))
    assert phrase in reason.message
    assert "energy_j of type r" in reason.message
    assert f"drop the {link} link" in reason.hint


def test_joint_work_with_too_few_robots_is_told_by_its_task() -> None:
    lift = and_(leaf("left", role="x"), leaf("right", role="y"), label="Lift the beam")
    tree = grounded(and_(leaf("look"), lift), teams={"x": 0, "y": 0})
    reason = told(tree, trivial_fleet())
    assert (
        reason.message
        == 'Whatever is chosen, this cannot be kept: different robots for the joint roles of "Lift the beam".'
    )
    assert reason.hint == 'It would be enough to have "Lift the beam" done with fewer robots at once.'


def test_a_stock_of_the_scene_clashes_with_what_a_robot_may_use() -> None:
    """With a kit, of which there is none, or by hand for 5 J, of which the robot has 4."""
    tree = grounded(xor_(leaf("kit", uses={"kits": 1}), leaf("hands", uses={"energy_j": 5})))
    reason = told(tree, trivial_fleet(limits={"energy_j": 4}), Terms(stock={"kits": 0}))
    assert reason.message == (
        "Together these cannot be kept: kits in the stock of the scene (0), and energy_j of type r (4, 1 robot)."
    )
    assert "raise kits in the stock of the scene" in reason.hint


def test_a_second_clash_is_admitted() -> None:
    """Each task alone is too much, for a reason of its own: neither limit alone is enough to loosen."""
    tree = grounded(and_(leaf("a", "cart", uses={"energy_j": 7}), leaf("b", "drone", uses={"energy_j": 5})))
    clash = found(flat_of(tree, BUDGETS_OF_TWO))
    assert (clash.limits, clash.irreducible, clash.enough) == ((Limit("robots", "cart", "energy_j"),), True, ())
    assert told(tree, BUDGETS_OF_TWO).hint == "Other limits clash as well, so that to loosen one is not enough."


def test_what_no_limit_is_to_blame_for_is_no_clash() -> None:
    fleet = trivial_fleet(limits={"energy_j": 4})
    nobody = grounded(and_(leaf("a", uses={"energy_j": 3}), xor_(label="nobody")))
    assert [reason.rule for reason in ranked(flat_of(nobody, fleet)).reasons] == ["no_robot_able"]
    # One role that two robot types fill at once cannot be done by anybody, whatever the limits.
    torn = grounded(and_(leaf("a", "a", "x", uses={"energy_j": 1}), leaf("b", "b", "x")))
    flat = flat_of(torn, trivial_fleet(("a", "b"), limits={"energy_j": 4}))
    assert clash_of(flat, Control()) is None
    assert [reason.rule for reason in ranked(flat).reasons] == ["role_torn"]


def test_what_can_be_done_says_nothing_of_clashes() -> None:
    assert ranked(flat_of(loads(3), trivial_fleet(limits={"energy_j": 5}))).reasons == ()


def test_a_question_that_is_not_answered_leaves_its_limits_in(monkeypatch: pytest.MonkeyPatch) -> None:
    """Three questions may be asked: without any limit, of one alone, and without the cart's; nobody knows whether the drones' is needed."""
    flat = flat_of(grounded(and_(*(by_cart_or_drone(name, 4) for name in "abcd"))), BUDGETS_OF_TWO)
    monkeypatch.setattr(clashing, "MOST_WORK", 3 * len(flat.kind))
    clash = found(flat)
    assert (len(clash.limits), clash.irreducible, clash.enough) == (2, False, None)
    reason = reason_of(flat, clash)
    assert reason.message.startswith("These limits clash; it may be that fewer do: ")
    assert reason.hint == "Loosen one of them; it is not known whether that is enough."


def test_no_time_is_said_and_nothing_is_claimed() -> None:
    flat = flat_of(loads(3, 3, 3), trivial_fleet({"r": 2}, limits={"energy_j": 5}))
    ended = with_clash(ranked(flat), flat, Control(time_limit_s=0))
    assert ended.reasons[-1].rule == "clash_not_sought"
    assert "in the time given" in ended.reasons[-1].message


def test_large_trees_are_let_be_and_that_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    for module in (clashing, clash_wording):
        monkeypatch.setattr(module, "MOST_NODES", 3)
    reasons = ranked(flat_of(loads(3, 3, 3), trivial_fleet({"r": 2}, limits={"energy_j": 5}))).reasons
    assert [reason.rule for reason in reasons][-1] == "clash_not_sought"
    assert reasons[-1].message == "Which limits clash was not looked for: the tree has 4 nodes, more than 3."


def test_many_limits_are_counted() -> None:
    """Fifteen robots of types of their own with 1 J each, and one more load than they can take."""
    types = [f"t{number}" for number in range(15)]
    task = [xor_(*(leaf(f"{name}{n}", name, f"r{n}", uses={"energy_j": 1}) for name in types)) for n in range(16)]
    fleet = trivial_fleet(types, limits={"energy_j": 1})
    clash = found(flat_of(grounded(and_(*task)), fleet))
    assert (len(clash.limits), clash.irreducible) == (15, True)
    assert reason_of(flat_of(grounded(and_(*task)), fleet), clash).message.endswith("; and 3 more limits.")


def random_ruled(rng: Random) -> Case:
    return random_case(rng, [name for name in RULES if rng.random() < 0.4])


def truth(flat: Flat, case: Case) -> bool:
    """Whether there is an alternative, by trying all."""
    status = Exhaustive()(flat, case.fleet, case.weights, 1, Control()).status
    assert status in {"exact", "infeasible"}
    return status == "exact"


@settings(max_examples=150, deadline=None)
@given(st.randoms(use_true_random=False))
def test_a_clash_cannot_be_kept_and_could_be_without_any_one_of_its_limits(rng: Random) -> None:
    case = random_ruled(rng)
    flat = case.flat
    if truth(flat, case):
        return
    clash = clash_of(flat, Control())
    if clash is None:
        assert not truth(without_limits(flat, limits_of(flat)), case)
        return
    assert clash.irreducible
    assert not truth(only(flat, *clash.limits), case)
    for limit in clash.limits:
        assert truth(only(flat, *(other for other in clash.limits if other != limit)), case)
        assert clash.enough is not None
        assert truth(without_limits(flat, [limit]), case) == (limit in clash.enough)
    assert reason_of(flat, clash).message


@settings(max_examples=100, deadline=None)
@given(st.randoms(use_true_random=False))
def test_whether_there_is_any_alternative_is_what_trying_all_tells(rng: Random) -> None:
    case = random_ruled(rng)
    assert any_alternative(case.flat, Control()) == truth(case.flat, case)
