"""How many roles a required type fills, counted; and the purse that a requirement becomes."""

from __future__ import annotations

from random import Random

from benchmarks.random_trees import random_case
from missiontree.allocation.core import core_of
from missiontree.allocation.exhaustive import every_selection
from missiontree.allocation.flat import Flat, flatten
from missiontree.allocation.possible import possible_nodes, structurally_possible
from missiontree.allocation.purses import TAKING_PART, purses_of
from missiontree.allocation.turnout import Turnout, turnouts
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.terms import Terms
from tests.builders import Spec, and_, grounded, leaf, trivial_fleet, xor_


def both(name: str) -> Spec:
    """Done by type a in two actions of one role, or by type b in one."""
    by_a = and_(leaf(f"{name} a1", "a", role=name), leaf(f"{name} a2", "a", role=name), label=f"{name} by a")
    return xor_(by_a, leaf(f"{name} b", "b", role=name), label=name)


def only(name: str, kind: str) -> Spec:
    return leaf(name, kind, role=name)


def flat_of(*tasks: Spec, require: tuple[str, ...] = ("a",), fleet: Fleet | None = None) -> Flat:
    return flatten(grounded(and_(*tasks)), fleet or trivial_fleet(("a", "b")), Weights(), Terms(require=require))


def turnout_of(flat: Flat) -> Turnout:
    (found,) = turnouts(flat, structurally_possible(flat))
    return found


def test_actions_of_a_role_side_by_side_count_once() -> None:
    """Type a fills 2 roles at most, none in the least; the need of 1 leaves a spare of 1."""
    found = turnout_of(flat_of(both("x"), both("y")))
    assert (found.most[0], found.least, found.needed, found.spare, found.certain) == (2, 0, 1, 1, False)


def test_what_is_done_in_any_case_makes_it_certain() -> None:
    found = turnout_of(flat_of(both("x"), only("y", "a")))
    assert (found.most[0], found.least, found.certain) == (2, 1, True)


def test_a_choice_falls_short_of_the_best_beside_it() -> None:
    flat = flat_of(both("x"), both("y"))
    xor = flat.label.index("x")
    by_a, by_b = flat.children[xor]
    found = turnout_of(flat)
    assert (found.shortfall(xor, by_a), found.shortfall(xor, by_b)) == (0, 1)


def test_each_required_robot_needs_a_role_of_its_own() -> None:
    """Two robots are required: of 2 roles none may be left, of 1 there is one too few."""
    fleet = Fleet((RobotType(id="a", robots=(Robot(id="p"), Robot(id="q"))), RobotType(id="b", count=1)))
    assert turnout_of(flat_of(both("x"), both("y"), require=("p", "q"), fleet=fleet)).spare == 0
    flat = flat_of(both("x"), only("y", "b"), require=("p", "q"), fleet=fleet)
    assert turnout_of(flat).spare == -1
    assert possible_nodes(flat).idle == {"a": 1}


def test_a_requirement_becomes_a_purse_behind_those_of_budgets() -> None:
    """Of 2 roles 1 may be lacking; taking b lacks one, and what is below a choice lacks nothing."""
    flat = flat_of(both("x"), both("y"))
    possible = structurally_possible(flat)
    purses = purses_of(flat, possible)
    assert (purses.names, purses.limits, purses.units) == ((("a", TAKING_PART),), (1,), (1,))
    xor = flat.label.index("y")
    assert [purses.of_choice(xor, child) for child in flat.children[xor]] == [(), ((0, 1),)]
    core = core_of(flat, possible, purses)
    picks = [part for part, options in enumerate(core.options) if options]
    used = [core.way_under(len(core) - 1, dict.fromkeys(picks, index))[2] for index in (0, 1)]
    assert used == [{}, {0: 2}]


def test_what_is_kept_in_any_case_is_no_purse() -> None:
    flat = flat_of(both("x"), only("y", "a"))
    assert purses_of(flat, structurally_possible(flat)).names == ()


def test_no_way_that_keeps_the_requirement_overdraws_its_purse() -> None:
    """On 300 random trees: a way in which a type fills as many roles as it must lacks no more than its purse holds."""
    kept = lacking = 0
    for index in range(300):
        flat = random_case(Random(f"turnout:{index}"), ("robots required",)).flat  # noqa: S311 - luck for tests, not for secrets
        possible = structurally_possible(flat)
        if not possible[0]:
            continue
        for turnout in turnouts(flat, possible):
            for selection in every_selection(flat):
                if selection is None or not all(possible[node] for node in selection.nodes):
                    continue
                roles = {flat.role[one] for one in selection.leaves if flat.robot_type[one] == turnout.type_id}
                short = sum(turnout.shortfall(xor, child) for xor, child in selection.choices)
                if len(roles) >= turnout.needed:
                    kept += 1
                    assert short <= turnout.spare, f"tree {index}"
                else:
                    lacking += short > turnout.spare
    assert kept > 1000
    assert lacking > 1000
