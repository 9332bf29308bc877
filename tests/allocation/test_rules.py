"""Rules for the mission as a whole: totals, stocks, robots in use, who is left out and who must take part."""

from __future__ import annotations

from dataclasses import replace
from random import Random

import pytest

from benchmarks.allocation_agreement import EVERYTHING, exact_faults, run
from benchmarks.random_rules import RULES, TREE_RULES
from benchmarks.random_trees import Case, random_case
from missiontree.allocation import ALLOCATORS
from missiontree.allocation.exhaustive import Exhaustive
from missiontree.allocation.feasibility import Feasibility
from missiontree.allocation.flat import AMOUNT_SCALE, EVERYBODY, Flat, Shared, Stock, flatten
from missiontree.allocation.packing import Load, pack
from missiontree.allocation.possible import possible_nodes
from missiontree.allocation.purses import purses_of
from missiontree.allocation.selection import select
from missiontree.errors import InputError
from missiontree.mission.alternative import Ranking
from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.limit_use import LimitUse
from missiontree.mission.terms import NO_TERMS, Terms
from tests.builders import Spec, and_, grounded, leaf, trivial_fleet, xor_

PER_RULE = 300
TRULY = ["exact", "exhaustive"]


def ranked(allocator: str, tree: GroundedTree, fleet: Fleet, terms: Terms = NO_TERMS, k: int = 9) -> Ranking:
    return ALLOCATORS[allocator](flatten(tree, fleet, Weights(), terms), fleet, Weights(), k, Control())


def utilities(ranking: Ranking) -> list[float]:
    return [alternative.utility for alternative in ranking.alternatives]


def either(name: str, use: str = "energy_j") -> Spec:
    """Done by type a for 3 at a use of 5, or by type b for 2 at a use of 2."""
    return xor_(
        leaf(f"{name} by a", "a", role=name, quality=3, uses={use: 5}),
        leaf(f"{name} by b", "b", role=name, quality=2, uses={use: 2}),
        label=name,
    )


TWO = grounded(and_(either("x"), either("y")))


@pytest.mark.parametrize("rule", [*RULES, *TREE_RULES])
def test_exact_and_the_oracle_agree_under_every_rule(rule: str) -> None:
    """Lists, order, status, bounds and witnesses on 300 trees for each rule; each rule refuses something in many of them."""
    refusing = 0
    for index in range(PER_RULE):
        case = random_case(Random(f"{rule}:{index}"), (rule,))  # noqa: S311 - luck for tests, not for secrets
        truth = run(Exhaustive(), case, EVERYTHING)
        assert list(exact_faults(case, truth)) == [], f"case {index}"
        bare = Case(_untimed(case.tree), _unruled(case.fleet), case.weights, case.k, case.coupled)
        refusing += len(run(Exhaustive(), bare, EVERYTHING).alternatives) > len(truth.alternatives)
    assert refusing > PER_RULE // 30


def _untimed(tree: GroundedTree) -> GroundedTree:
    return replace(tree, nodes=tuple(replace(node, release_s=0.0, deadline_s=None) for node in tree.nodes))


def _unruled(fleet: Fleet) -> Fleet:
    types = (
        RobotType(id=kind.id, limits=kind.limits, total_limits=kind.total_limits, count=kind.count, robots=kind.robots)
        for kind in fleet.types
    )
    return Fleet(tuple(types))


@pytest.mark.parametrize("allocator", TRULY)
def test_a_total_for_all_robots_counts_every_type(allocator: str) -> None:
    """By a and a 10 J, by a and b 7 J in two ways, by b and b 4 J: of at most 9 J the first is left out, of 6 J three are."""
    fleet = trivial_fleet(("a", "b"))
    assert utilities(ranked(allocator, TWO, fleet)) == [6, 5, 5, 4]
    nine = Fleet(fleet.types, total_limits={"energy_j": 9})
    assert utilities(ranked(allocator, TWO, nine)) == [5, 5, 4]
    six = Fleet(fleet.types, total_limits={"energy_j": 6})
    assert utilities(ranked(allocator, TWO, six)) == [4]


@pytest.mark.parametrize("allocator", TRULY)
def test_a_stock_is_taken_from_by_whoever_does_it(allocator: str) -> None:
    """The same numbers, of kits; and a limit of type a's own, of 4 kits, lets only b work."""
    tree = grounded(and_(either("x", "kits"), either("y", "kits")))
    fleet = trivial_fleet(("a", "b"))
    assert utilities(ranked(allocator, tree, fleet, Terms(stock={"kits": 7}))) == [5, 5, 4]
    own = Fleet((RobotType(id="a", count=1, limits={"kits": 4}), RobotType(id="b", count=1)))
    assert utilities(ranked(allocator, tree, own, Terms(stock={"kits": 7}))) == [4]


def test_of_a_total_and_a_stock_of_one_name_the_smaller_counts() -> None:
    fleet = Fleet(trivial_fleet(("a", "b")).types, total_limits={"energy_j": 8})
    assert flatten(TWO, fleet, Weights(), Terms(stock={"energy_j": 9})).shared == {
        "energy_j": Shared(8 * AMOUNT_SCALE, "fleet")
    }
    assert flatten(TWO, fleet, Weights(), Terms(stock={"energy_j": 7})).shared == {
        "energy_j": Shared(7 * AMOUNT_SCALE, "scene")
    }


def test_what_nothing_uses_is_no_shared_budget() -> None:
    assert flatten(TWO, trivial_fleet(("a", "b")), Weights(), Terms(stock={"kits": 1})).shared == {}


def test_a_leaf_takes_from_the_purse_of_its_type_and_of_the_mission() -> None:
    """Type a uses up to 10 of 9, the mission up to 10 of 8; both count in units of 1 J, the greatest that divides 5 and 2, and of 5 J."""
    fleet = Fleet(
        (RobotType(id="a", count=1, total_limits={"energy_j": 9}), RobotType(id="b", count=1)),
        total_limits={"energy_j": 8},
    )
    flat = flatten(TWO, fleet, Weights())
    purses = purses_of(flat, [True] * len(flat.kind))
    assert purses.names == ((EVERYBODY, "energy_j"), ("a", "energy_j"))
    assert purses.limits == (8, 1)
    of_a, of_b = (flat.label.index(f"x by {name}") for name in "ab")
    assert purses.of_leaves(flat)[of_a] == ((1, 1), (0, 5))
    assert purses.of_leaves(flat)[of_b] == ((0, 2),)


def test_what_is_used_whatever_is_chosen_is_refused_before_the_search() -> None:
    """At least 2 + 2 J of 3."""
    fleet = Fleet(trivial_fleet(("a", "b")).types, total_limits={"energy_j": 3})
    ranking = ranked("exact", TWO, fleet)
    assert (ranking.status, ranking.examined) == ("infeasible", 0)
    assert [reason.message for reason in ranking.reasons] == [
        'Whatever is chosen, "and" uses 4 of energy_j, and all robots of the mission together may use 3.'
    ]
    assert "total_limits of the fleet" in ranking.reasons[0].hint
    stocked = ranked("exact", TWO, trivial_fleet(("a", "b")), Terms(stock={"energy_j": 3}))
    assert "the whole mission may use 3" in stocked.reasons[0].message
    assert "stock of the scene" in stocked.reasons[0].hint


def test_pruned_keeps_what_the_whole_mission_may_use() -> None:
    """Totals and stocks are declared budgets, as those of types are."""
    fleet = Fleet(trivial_fleet(("a", "b")).types, total_limits={"energy_j": 9})
    assert utilities(ranked("pruned", TWO, fleet)) == [5, 5, 4]


def test_what_is_used_of_the_mission_is_told_last() -> None:
    """By a and b 5 + 2 J of 9."""
    fleet = Fleet(trivial_fleet(("a", "b")).types, total_limits={"energy_j": 9})
    best = [ranked(allocator, TWO, fleet).alternatives[0] for allocator in ("exact", "exhaustive", "pruned")]
    assert [alternative.uses for alternative in best] == [(LimitUse("mission", "", "energy_j", 7.0, 9.0),)] * 3


def named(*names: str, energy: tuple[float, ...] = (), **common: object) -> Fleet:
    robots = tuple(
        Robot(id=name, remaining={"energy_j": energy[place]} if energy else {}) for place, name in enumerate(names)
    )
    return Fleet((RobotType(id="r", robots=robots, **common),))  # type: ignore[arg-type]


def loads(*uses: float) -> GroundedTree:
    return grounded(and_(*(leaf(f"l{place}", uses={"energy_j": use}) for place, use in enumerate(uses))))


def witness_of(ranking: Ranking) -> list[str]:
    return [filled.robot for filled in ranking.alternatives[0].witness]


@pytest.mark.parametrize("allocator", TRULY)
def test_packing_finds_which_robots_are_in_use(allocator: str) -> None:
    """Loads of 6, 3 and 3 J on two of three robots with 4, 6 and 7 J: only the last two together have 12."""
    fleet = named("p", "q", "s", energy=(4, 6, 7), max_in_use=2)
    assert witness_of(ranked(allocator, loads(6, 3, 3), fleet)) == ["q", "s", "s"]
    # 5, 5 and 3 J are 13 of 13, and leave 1 and 2 J: only p, as a third, could take the last.
    assert ranked(allocator, loads(5, 5, 3), fleet).status == "infeasible"
    assert witness_of(ranked(allocator, loads(5, 5, 3), named("p", "q", "s", energy=(4, 6, 7)))) == ["q", "s", "p"]


def test_the_reason_names_how_many_may_be_in_use() -> None:
    """Two loads of 4 J and one of 3: each of the three robots with 5 J takes one, and two of them cannot take all."""
    ranking = ranked("exact", loads(4, 4, 3), named("p", "q", "s", energy=(5, 5, 5), max_in_use=2))
    # 11 J are wanted and the best two have 10: that is told first, as a budget.
    assert [reason.rule for reason in ranking.reasons] == ["limits_clash", "budget_exceeded"]
    ranking = ranked("exact", loads(4, 4, 4), named("p", "q", "s", energy=(6, 6, 6), max_in_use=2))
    assert [reason.rule for reason in ranking.reasons] == ["limits_clash", "max_in_use_exceeded"]
    assert "out to at most 2 robots of type r" in ranking.reasons[1].message


def test_a_team_needs_robots_that_may_be_in_use() -> None:
    team = grounded(and_(leaf("one"), leaf("two")), teams={"one": 1, "two": 1})
    assert ranked("exact", team, named("p", "q", "s")).status == "exact"
    assert ranked("exact", team, named("p", "q", "s", max_in_use=1)).status == "infeasible"


@pytest.mark.parametrize("allocator", TRULY)
def test_a_required_type_stands_in_every_alternative(allocator: str) -> None:
    """Of a-a 6, a-b 5, b-a 5 and b-b 4 the first has no b."""
    assert utilities(ranked(allocator, TWO, trivial_fleet(("a", "b")), Terms(require=("b",)))) == [5, 5, 4]


@pytest.mark.parametrize("allocator", TRULY)
def test_a_required_robot_is_handed_a_role(allocator: str) -> None:
    """Without a budget the first robot would do: with q and s required, both do, of three roles."""
    ranking = ranked(allocator, loads(0, 0, 0), named("p", "q", "s"), Terms(require=("s", "q")))
    assert {"q", "s"} <= set(witness_of(ranking))


def test_more_robots_required_than_there_are_roles_is_impossible() -> None:
    ranking = ranked("exact", loads(0), named("p", "q"), Terms(require=("p", "q")))
    assert (ranking.status, ranking.examined) == ("infeasible", 0)
    clash, reason = ranking.reasons
    assert clash.message == "Together these cannot be kept: p must take part, and q must take part."
    assert (reason.rule, reason.found, reason.needed) == ("required_idle", "1 role", "at least 2 roles")
    assert reason.message == "The mission requires p and q, and robots of type r fill 1 role at most."


def test_a_required_robot_that_is_too_weak_for_every_load_is_told() -> None:
    """Loads of 4 J; p has 3."""
    ranking = ranked("exact", loads(4, 4), named("p", "q", energy=(3, 9)), Terms(require=("p",)))
    assert (ranking.status, ranking.reasons[1].rule) == ("infeasible", "required_idle")
    assert "p must take part" in ranking.reasons[1].message


def test_a_required_type_with_nothing_to_do_is_told_before_the_search() -> None:
    fleet = trivial_fleet(("a", "b", "c"))
    ranking = ranked("exact", TWO, fleet, Terms(require=("c",)))
    assert (ranking.status, ranking.examined) == ("infeasible", 0)
    assert ranking.reasons[0].message == "The mission requires type c, and no robot of type c fills a role."
    assert possible_nodes(flatten(TWO, fleet, Weights(), Terms(require=("c",)))).idle == {"c": 0}


def test_a_requirement_far_below_the_best_is_proven_all_the_same() -> None:
    """
    Of 20 tasks one must go to d, at 0.1 instead of 1.0: 20 ways of 19.1 share the first rank.

    Above them stand more than 400,000 ways without d (nine tasks or fewer by b, the others by a), which a search that only looks at
    candidates in order would have to refuse one by one.
    """
    tasks = (
        xor_(
            *(leaf(f"{place} {name}", name, role=f"{place}", quality=good) for name, good in QUALITIES),
            label=f"{place}",
        )
        for place in range(20)
    )
    ranking = ranked("exact", grounded(and_(*tasks)), trivial_fleet("abcd"), Terms(require=("d",)), k=4)
    assert (ranking.status, utilities(ranking)) == ("exact", [19.1] * 4)
    assert ranking.examined < 100
    assert [alternative.certificate.claim for alternative in ranking.alternatives] == ["proven"] * 4


QUALITIES = (("a", 1.0), ("b", 0.9), ("c", 0.85), ("d", 0.1))


def test_a_refusal_names_the_robot_that_was_required() -> None:
    """Not the type alone, which the operator did not name."""
    fleet = Fleet((*trivial_fleet(("a",)).types, RobotType(id="b", robots=(Robot(id="blue"),))))
    flat = flatten(TWO, fleet, Weights(), Terms(require=("blue",)))
    by_a = select(flat, {node: 0 for node, kind in enumerate(flat.kind) if kind == "xor"}, [True] * len(flat.kind))
    reason = Feasibility(flat).decide(by_a).reason
    assert reason is not None
    assert reason.message == "The mission requires blue, and no robot of type b fills a role."
    assert "Take blue off 'require'" in reason.hint


@pytest.mark.parametrize("allocator", TRULY)
def test_a_robot_left_out_fills_no_role_and_brings_no_budget(allocator: str) -> None:
    """Two loads of 4 J need two robots with 5 J each: with p left out, one is left."""
    fleet = named("p", "q", "s", energy=(5, 5, 5))
    assert set(witness_of(ranked(allocator, loads(4, 4), fleet, Terms(without=("p",))))) == {"q", "s"}
    assert ranked(allocator, loads(4, 4), fleet, Terms(without=("p", "q"))).status == "infeasible"


def test_a_tree_with_a_type_that_is_left_out_is_refused() -> None:
    with pytest.raises(InputError, match="robot type 'b'"):
        flatten(TWO, trivial_fleet(("a", "b")), Weights(), Terms(without=("b",)))


def test_algorithm_1_drops_at_the_end_what_lacks_a_required_type() -> None:
    """It keeps its best two ways, 6 and 5, knowing nothing of the rule; the first has no b."""
    ranking = ranked("pruned", TWO, trivial_fleet(("a", "b")), Terms(require=("b",)), k=2)
    assert (utilities(ranking), ranking.status) == ([5], "partial")


def test_idle_robots_that_are_required_keep_their_place() -> None:
    """Three robots, two in use, the last required: the load of 9 J fits the first alone, so the others go to the last."""
    stock = Stock(("p", "q", "s"), ({"e": 9}, {"e": 9}, {"e": 5}), {}, max_in_use=2, required=(2,))
    packed = pack(stock, [Load(group, {"e": use}, frozenset()) for group, use in enumerate((9, 2, 3))], 1000)
    assert packed.answer == "yes"
    assert {packed.robots[1], packed.robots[2]} == {2}


def test_a_requirement_that_the_best_keeps_costs_one_look() -> None:
    assert ranked("exact", TWO, trivial_fleet(("a", "b")), Terms(require=("a",)), k=1).examined == 1


def test_flat_forms_without_rules_are_what_they_were() -> None:
    flat = flatten(TWO, trivial_fleet(("a", "b")), Weights())
    assert isinstance(flat, Flat)
    assert (flat.shared, flat.required, flat.uses) == ({}, {}, ({},) * len(flat.kind))
