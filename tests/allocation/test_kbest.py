"""The exact allocator: right lists, honest claims, and no tree too deep or too wide."""

from __future__ import annotations

from typing import Any

import pytest

from benchmarks.tied_budget import tied_mission
from missiontree.allocation import kbest
from missiontree.allocation.kbest import ExactKBest
from missiontree.allocation.search import REPORT_EVERY
from missiontree.mission.alternative import Ranking, RoleType
from missiontree.mission.control import Control, Progress
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.search_limit import SearchLimit
from tests.builders import Spec, and_, grounded, leaf, trivial_fleet, xor_

TWO_TYPES = trivial_fleet(("r", "s"), limits={"energy_j": 5})


def rank(tree: GroundedTree, fleet: Fleet | None = None, k: int = 4, control: Control | None = None) -> Ranking:
    return ExactKBest()(tree, fleet or trivial_fleet(), Weights(), k, control or Control())


def task(name: str, r: float, s: float, energy: float = 3) -> Spec:
    """A role that r does with one quality and s with another, either for the same energy."""
    return xor_(
        leaf(f"{name}_r", "r", name, quality=r, uses={"energy_j": energy}),
        leaf(f"{name}_s", "s", name, quality=s, uses={"energy_j": energy}),
        label=name,
    )


def binary_choices(count: int, **fields: Any) -> GroundedTree:
    pairs = (
        xor_(leaf(f"a{n}", role=f"r{n}", quality=1, **fields), leaf(f"b{n}", role=f"r{n}", quality=0, **fields))
        for n in range(count)
    )
    return grounded(and_(*pairs))


def test_the_best_that_keeps_the_budget() -> None:
    # r is better at both (2 + 2) but has energy for one. Left: r, s = 2 + 1 = 3 and s, r = 1 + 2 = 3; s, s breaks s's budget.
    result = rank(grounded(and_(task("x", 2, 1), task("y", 2, 1))), TWO_TYPES)
    assert [alternative.utility for alternative in result.alternatives] == [3.0, 3.0]
    assert result.alternatives[0].roles == (RoleType(0, "r"), RoleType(1, "s"))
    assert (result.status, result.certificate.claim, result.examined) == ("exact", "proven", 4)
    assert result.certificate.detail == "There are no more alternatives."
    assert sorted(reason.robot for reason in result.reasons) == ["r", "s"]


def test_each_rank_carries_its_proof() -> None:
    result = rank(grounded(and_(task("x", 2, 1), task("y", 2, 1))), TWO_TYPES, k=1)
    (only,) = result.alternatives
    assert (only.rank, only.certificate.claim, only.certificate.bound) == (1, "proven", 3.0)
    assert [(entry.role, entry.robot) for entry in only.witness] == [(0, "r-1"), (1, "s-1")]
    # The second alternative is as good as the first, so 3.0 bounds what is not listed.
    assert (result.status, result.certificate.bound) == ("exact", 3.0)


def test_no_witness_where_nothing_couples() -> None:
    assert rank(binary_choices(2)).alternatives[0].witness == ()


def test_refusals_are_counted_not_listed() -> None:
    """Teams of two on one robot: all four candidates break the same rule, and one reason says so."""
    tree = grounded(
        and_(xor_(leaf("a", role="x"), leaf("b", role="x")), xor_(leaf("c", role="y"), leaf("d", role="y"))),
        teams={"x": 0, "y": 0},
    )
    result = rank(tree)
    assert (result.status, result.certificate.claim, result.examined) == ("infeasible", "proven", 4)
    clash, reason = result.reasons
    assert clash.rule == "limits_clash"
    assert (reason.rule, reason.robot, reason.severity) == ("too_few_robots", "r", "error")
    assert reason.message.startswith("4 candidates were refused.")


def test_a_quick_bound_spares_endless_enumeration() -> None:
    """40 XORs of 2 have 2**40 ways, each of which uses 40 of 39."""
    result = rank(binary_choices(40, uses={"energy_j": 1}), trivial_fleet(limits={"energy_j": 39}))
    assert (result.status, result.certificate.claim, result.examined) == ("infeasible", "proven", 0)
    assert result.reasons[0].needed == "energy_j 40"


def test_an_impossible_mission_names_what_nobody_can_do() -> None:
    """A dead end with a way round it is not to blame."""
    result = rank(grounded(and_(xor_(leaf("a"), xor_(label="avoidable")), xor_(label="nobody"))))
    assert (result.status, [reason.rule for reason in result.reasons]) == ("infeasible", ["no_robot_able"])
    assert result.reasons[0].node == "nobody"


def test_no_time_still_lists_what_a_few_sweeps_find() -> None:
    result = rank(binary_choices(3), control=Control(time_limit_s=0))
    # Nothing was examined; three times 1 is the best there is, and nothing that is not listed is better than that.
    assert (result.status, result.examined, result.certificate.claim) == ("partial", 0, "bounded")
    assert (result.alternatives[0].utility, result.certificate.bound) == (3.0, 3.0)
    assert all(alternative.certificate.claim == "bounded" for alternative in result.alternatives)


def test_no_time_still_proves_the_first_of_a_large_tree_that_nothing_couples(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kbest, "LARGE", 1)
    monkeypatch.setattr(kbest, "HURRIED", 4)
    four = rank(binary_choices(3), control=Control(time_limit_s=0))
    assert (four.status, [one.utility for one in four.alternatives]) == ("exact", [3.0, 2.0, 2.0, 2.0])
    six = ExactKBest()(binary_choices(3), trivial_fleet(), Weights(), 6, Control(time_limit_s=0))
    # Four are proven, and the four that follow are no better than the last of them; the pool was not filled.
    assert (six.status, six.examined, six.certificate.claim, six.certificate.bound) == ("partial", 4, "bounded", 2.0)
    assert [one.certificate.claim for one in six.alternatives] == ["proven"] * 4


def test_a_stop_token_keeps_what_was_found() -> None:
    answers = iter([False, False, False])
    result = rank(binary_choices(3), control=Control(stop=lambda: next(answers, True)))
    # 3, then 2 three times: two are found and proven; the next would have been 2, and the pool has the other two.
    assert [alternative.utility for alternative in result.alternatives] == [3.0, 2.0, 2.0, 2.0]
    claims = [alternative.certificate.claim for alternative in result.alternatives]
    assert claims == ["proven", "proven", "bounded", "bounded"]
    assert (result.status, result.certificate.claim, result.certificate.bound) == ("partial", "bounded", 2.0)


def test_a_cap_on_candidates_stops_like_a_time_limit() -> None:
    result = ExactKBest(max_examined=1)(binary_choices(3), trivial_fleet(), Weights(), 4, Control())
    assert (result.status, result.examined, result.certificate.bound) == ("partial", 1, 2.0)
    assert [alternative.certificate.claim for alternative in result.alternatives[:2]] == ["proven", "bounded"]


@pytest.mark.parametrize("k", [4, 10])
def test_countless_ties_above_a_budget(k: int) -> None:
    """2**30 ways, of which those with more than three a are better than any that the budget allows."""
    result = ExactKBest()(*tied_mission(30, {"a": 3}), Weights(), k, Control())
    # Three times 1 and 27 times 0.9, in 4,060 ways, so k of them tie; by choice indices tasks 0, 1 and 2 take a first.
    assert [alternative.utility for alternative in result.alternatives] == [27.3] * k
    assert (result.status, result.certificate.bound) == ("exact", 27.3)
    first = [place for place, choice in enumerate(result.alternatives[0].choices) if choice.child == choice.xor + 1]
    second = [place for place, choice in enumerate(result.alternatives[1].choices) if choice.child == choice.xor + 1]
    assert (first, second) == ([0, 1, 2], [0, 1, 3])


def test_two_budgets_and_no_limit_of_time() -> None:
    result = ExactKBest()(*tied_mission(60, {"a": 20, "b": 25}), Weights(), 4, Control())
    # 20 + 25 * 0.9 + 15 * 0.8 = 54.5
    assert ([entry.utility for entry in result.alternatives], result.status) == ([54.5] * 4, "exact")


def test_where_branch_and_bound_is_given_up_the_pool_and_the_prices_speak() -> None:
    """No node is looked at; prices know that nothing is better than 27.3, where the plain stream alone would say 29.9."""
    exact = ExactKBest(max_nodes=(0, 0))
    result = exact(*tied_mission(30, {"a": 3}), Weights(), 4, Control())
    assert [alternative.utility for alternative in result.alternatives] == [27.3] * 4
    assert (result.status, result.certificate.claim, result.certificate.bound) == ("partial", "bounded", 27.3)


def test_what_branch_and_bound_proves_says_so() -> None:
    result = ExactKBest(patience=0)(*tied_mission(6, {"a": 2}), Weights(), 3, Control())
    # 2 + 4 * 0.9 in 15 ways.
    assert [alternative.utility for alternative in result.alternatives] == [5.6] * 3
    assert {alternative.certificate.method for alternative in result.alternatives} == {"branch_and_bound"}
    assert (result.status, result.certificate.claim) == ("exact", "proven")


def test_all_there_are_when_fewer_are_there_than_wanted() -> None:
    result = ExactKBest(patience=0)(*tied_mission(2, {"a": 1}), Weights(), 9, Control())
    # a and b, b and a, b and b.
    assert [alternative.utility for alternative in result.alternatives] == [1.9, 1.9, 1.8]
    assert (result.status, result.certificate.bound) == ("exact", None)


def test_never_silent_at_no_time_under_budgets() -> None:
    result = ExactKBest()(*tied_mission(30, {"a": 3}), Weights(), 4, Control(time_limit_s=0))
    assert result.status == "partial"
    assert result.alternatives[0].utility <= 27.3 <= (result.certificate.bound or 0)
    assert result.alternatives[0].witness[0].robot in {"a-1", "b-1"}


def test_a_bounded_claim_says_what_ended_the_search_and_a_proof_needs_nothing_of_the_kind() -> None:
    """The time limit is the one that was set, not the share of it that allocation was given."""
    mission, asked = tied_mission(30, {"a": 3}), Control(time_limit_s=0, seed=5).part(0.6)
    answers = iter([False, False])
    ended = [
        ExactKBest()(*mission, Weights(), 4, asked),
        ExactKBest()(*mission, Weights(), 4, Control(stop=lambda: next(answers, True), seed=5)),
        ExactKBest(max_examined=1)(*mission, Weights(), 4, Control(seed=5)),
        ExactKBest(max_nodes=(0, 0))(*mission, Weights(), 4, Control(seed=5)),
    ]
    limits = [result.certificate.limit for result in ended]
    assert limits == [
        SearchLimit("time_s", 0), SearchLimit("stopped"), SearchLimit("candidates", 1), SearchLimit("nodes", 0),
    ]  # fmt: skip
    assert {result.certificate.seed for result in ended} == {5}
    assert all(alternative.certificate.limit is None for result in ended for alternative in result.alternatives)
    proven = ExactKBest()(*mission, Weights(), 4, Control(seed=5)).certificate
    assert (proven.claim, proven.limit, proven.seed) == ("proven", None, None)


def test_undecided_candidates_stay_and_say_so() -> None:
    tree = grounded(and_(*(leaf(name, uses={"energy_j": used}) for name, used in (("a", 3), ("b", 2), ("c", 4)))))
    fleet = trivial_fleet({"r": 2}, limits={"energy_j": 5})
    result = ExactKBest(packing_steps=1)(tree, fleet, Weights(), 1, Control())
    assert (result.status, result.alternatives[0].certificate.claim) == ("partial", "unproven")
    assert result.alternatives[0].certificate.limit == SearchLimit("steps", 1)
    assert rank(tree, fleet, k=1).alternatives[0].certificate.claim == "proven"


def test_progress_is_told() -> None:
    news: list[Progress] = []
    rank(binary_choices(10), k=2 * REPORT_EVERY, control=Control(report=news.append))
    assert [(told.stage, told.done, told.found) for told in news] == [
        ("allocation", REPORT_EVERY, REPORT_EVERY),
        ("allocation", 2 * REPORT_EVERY, 2 * REPORT_EVERY),
        ("allocation", 2 * REPORT_EVERY, 2 * REPORT_EVERY),
    ]


def test_k_below_one_is_refused() -> None:
    with pytest.raises(ValueError, match="k must be at least 1, got 0"):
        rank(binary_choices(1), k=0)


@pytest.mark.parametrize("chain_first", [True, False])
def test_ten_thousand_levels(chain_first: bool) -> None:
    """AND and XOR take turns; at every second level a choice of 1 or 0, so that ties reach to the bottom."""
    spec = leaf("end")
    for level in range(5_000):
        choice = xor_(leaf(f"a{level}", quality=1), leaf(f"b{level}", quality=0))
        chain = xor_(spec)
        spec = and_(chain, choice) if chain_first else and_(choice, chain)
    tree = grounded(spec)
    result = rank(tree, k=4)
    # All ones and the end make 5,001; then one of 5,000 choices is given up, a tie, settled by choice indices.
    assert [alternative.utility for alternative in result.alternatives] == [5001.0, 5000.0, 5000.0, 5000.0]
    assert result.status == "exact"
    best, second = (set(alternative.choices) for alternative in result.alternatives[:2])
    (switched,) = (choice.child for choice in second - best)
    # Given up is the choice that comes last in preorder: the top one where the chain comes first, else the lowest.
    assert tree.nodes[switched].label == ("b4999" if chain_first else "b0")


def test_fifty_thousand_children() -> None:
    leaves = [leaf(f"l{n}", quality=1) for n in range(45_000)]
    choices = [xor_(leaf(f"a{n}", quality=1), leaf(f"b{n}", quality=0)) for n in range(5_000)]
    result = rank(grounded(and_(*leaves, *choices)), k=3)
    assert [alternative.utility for alternative in result.alternatives] == [50000.0, 49999.0, 49999.0]
    # The last XOR is node 1 + 45,000 + 3 * 4,999; the second best switches it to its second child, two nodes on.
    last = 1 + 45_000 + 3 * 4_999
    assert [alternative.choices[-1].child - last for alternative in result.alternatives] == [1, 2, 1]
