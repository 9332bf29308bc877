"""Algorithm 1: exact where nothing couples, never a false claim where something does."""

from __future__ import annotations

from missiontree.allocation.pruned import Pruned
from missiontree.mission.alternative import Ranking
from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.search_limit import SearchLimit
from tests.builders import Spec, and_, grounded, leaf, trivial_fleet, xor_


def rank(tree: GroundedTree, fleet: Fleet | None = None, k: int = 2, settings: Pruned | None = None) -> Ranking:
    return (settings or Pruned())(tree, fleet or trivial_fleet(), Weights(), k, Control())


def utilities(result: Ranking) -> list[float]:
    return [alternative.utility for alternative in result.alternatives]


def either(label: str, *qualities_and_energies: tuple[float, float]) -> Spec:
    return xor_(
        *(
            leaf(f"{label}{place}", quality=quality, uses={"energy_j": energy})
            for place, (quality, energy) in enumerate(qualities_and_energies)
        )
    )


def test_exact_where_nothing_couples() -> None:
    tree = grounded(and_(either("x", (2, 0), (1, 0)), either("y", (2, 0), (1, 0))))
    result = rank(tree, k=3)
    # 2 + 2, then 3 twice.
    assert (utilities(result), result.status, result.certificate.claim) == ([4.0, 3.0, 3.0], "exact", "proven")


def test_a_small_rho_is_not_exact() -> None:
    tree = grounded(and_(either("x", (2, 0), (1, 0)), either("y", (2, 0), (1, 0))))
    result = rank(tree, k=3, settings=Pruned(rho=1))
    assert (utilities(result), result.status) == ([4.0], "partial")


def test_what_is_pruned_early_may_be_what_fits_later() -> None:
    """The price of pruning: with rho 1 the greedy way of x is kept, and nothing is left for y."""
    tree = grounded(and_(either("x", (9, 5), (1, 1)), either("y", (1, 3))))
    fleet = trivial_fleet(limits={"energy_j": 5})
    result = rank(tree, fleet, k=1)
    assert (utilities(result), result.status) == ([], "unknown")
    assert [reason.rule for reason in result.reasons] == ["all_pruned"]
    # With rho 2 the frugal way (1 of energy) survives: 1 + 1 = 2 with 4 of 5.
    result = rank(tree, fleet, k=1, settings=Pruned(rho=2))
    assert (utilities(result), result.status) == ([2.0], "partial")
    assert result.alternatives[0].certificate.claim == "unproven"


def test_a_team_it_does_not_know_is_dropped_not_delivered() -> None:
    tree = grounded(and_(leaf("a"), leaf("b")), teams={"a": 0, "b": 0})
    result = rank(tree)
    assert (utilities(result), result.status) == ([], "unknown")
    assert [reason.rule for reason in result.reasons] == ["too_few_robots"]


def test_an_impossible_child_is_no_empty_plan() -> None:
    """As printed, Algorithm 1 returns one empty alternative here."""
    tree = grounded(and_(leaf("a"), xor_()))
    for as_printed in (False, True):
        result = rank(tree, settings=Pruned(as_printed=as_printed))
        assert (result.alternatives, result.status, result.certificate.claim) == ((), "infeasible", "proven")


def test_the_printed_form_gives_the_same_list_until_its_product_explodes() -> None:
    def tree_of(count: int) -> GroundedTree:
        return grounded(and_(*(either(f"x{number}_", (1, 0), (0, 0)) for number in range(count))))

    printed = Pruned(as_printed=True, max_product=1000)
    # 2**9 = 512 combinations are within 1000; all ones make 9, giving up one makes 8.
    assert utilities(rank(tree_of(9), settings=printed)) == [9.0, 8.0] == utilities(rank(tree_of(9)))
    result = rank(tree_of(10), settings=printed)
    assert (utilities(result), result.status) == ([], "unknown")
    assert [reason.rule for reason in result.reasons] == ["product_too_large"]
    assert result.certificate.limit == SearchLimit("combinations", 1000)


def test_the_printed_form_tests_budgets_per_combination() -> None:
    tree = grounded(and_(either("x", (9, 5), (1, 1)), either("y", (1, 3))))
    # The product has two combinations, 5 + 3 and 1 + 3 of 5; only the second stands, though k (and rho) is 2.
    result = rank(tree, trivial_fleet(limits={"energy_j": 5}), settings=Pruned(as_printed=True))
    assert utilities(result) == [2.0]


def test_no_time_is_unknown() -> None:
    tree = grounded(and_(leaf("a"), leaf("b")))
    result = Pruned()(tree, trivial_fleet(), Weights(), 2, Control(time_limit_s=0))
    assert (result.status, [reason.rule for reason in result.reasons]) == ("unknown", ["stopped"])
    assert result.certificate.limit == SearchLimit("time_s", 0)


def test_wide_and_deep() -> None:
    wide = grounded(and_(*(xor_(leaf(f"a{n}", quality=1), leaf(f"b{n}", quality=0)) for n in range(20_000))))
    assert utilities(rank(wide, k=2)) == [20000.0, 19999.0]
    spec = leaf("end")
    for level in range(2_500):
        spec = and_(xor_(spec), xor_(leaf(f"a{level}", quality=1), leaf(f"b{level}", quality=0)))
    assert utilities(rank(grounded(spec), k=2)) == [2501.0, 2500.0]
