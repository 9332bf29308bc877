"""The oracle, held against lists written by hand."""

from __future__ import annotations

from missiontree.allocation.exhaustive import Exhaustive, every_selection
from missiontree.allocation.flat import flatten
from missiontree.mission.alternative import Choice, Ranking
from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.search_limit import SearchLimit
from tests.builders import and_, grounded, leaf, trivial_fleet, xor_

# 0 and, 1 xor, 2 a, 3 and, 4 b, 5 xor (nobody), 6 xor, 7 c, 8 d
TREE = grounded(and_(xor_(leaf("a"), and_(leaf("b"), xor_())), xor_(leaf("c", quality=1), leaf("d", quality=2))))


def rank(tree: GroundedTree, fleet: Fleet | None = None, k: int = 10, settings: Exhaustive | None = None) -> Ranking:
    return (settings or Exhaustive())(tree, fleet or trivial_fleet(), Weights(), k, Control())


def test_every_way_by_choice_indices() -> None:
    flat = flatten(TREE, trivial_fleet(), Weights())
    ways = [None if way is None else (way.choices, way.leaves) for way in every_selection(flat)]
    # The third runs into the XOR that nobody can do, before it reaches node 6.
    assert ways == [(((1, 2), (6, 7)), (2, 7)), (((1, 2), (6, 8)), (2, 8)), None]


def test_best_first() -> None:
    result = rank(TREE)
    assert [(entry.utility, entry.choices) for entry in result.alternatives] == [
        (3.0, (Choice(1, 2), Choice(6, 8))),
        (2.0, (Choice(1, 2), Choice(6, 7))),
    ]
    assert (result.status, result.examined) == ("exact", 2)


def test_it_tries_every_assignment() -> None:
    # 3, 3 and 4 on two robots of 6: 4 stands alone. With 5 each no two stand together.
    tree = grounded(and_(*(leaf(name, uses={"e": used}) for name, used in (("a", 3), ("b", 3), ("c", 4)))))
    result = rank(tree, trivial_fleet({"r": 2}, limits={"e": 6}))
    assert [entry.robot for entry in result.alternatives[0].witness] == ["r-1", "r-1", "r-2"]
    assert rank(tree, trivial_fleet({"r": 2}, limits={"e": 5})).status == "infeasible"


def test_links_and_teams_are_read_off() -> None:
    both = and_(leaf("a"), leaf("b"))
    two, one = trivial_fleet({"r": 2}), trivial_fleet({"r": 1})
    assert rank(grounded(both, teams={"a": 0, "b": 0}), one).status == "infeasible"
    assert rank(grounded(both, [("a", "b", "different_robot")]), one).status == "infeasible"
    assert rank(grounded(both, [("a", "b", "different_robot")]), two).status == "exact"
    (same,) = rank(grounded(both, [("a", "b", "same_robot")]), two).alternatives
    assert [entry.robot for entry in same.witness] == ["r-1", "r-1"]


def test_giving_up_claims_nothing() -> None:
    result = rank(TREE, settings=Exhaustive(max_examined=1))
    assert (result.status, result.certificate.claim, len(result.alternatives)) == ("partial", "unproven", 1)
    assert result.certificate.limit == SearchLimit("candidates", 1)
    tree = grounded(and_(leaf("a"), leaf("b"), leaf("c")), teams={"a": 0, "b": 0, "c": 0})
    # 2 ** 3 = 8 assignments, none of which keeps three roles apart; after 4 it is not known.
    result = rank(tree, trivial_fleet({"r": 2}), settings=Exhaustive(max_assignments=4))
    assert (result.status, result.alternatives[0].certificate.claim) == ("partial", "unproven")
    assert result.certificate.limit == SearchLimit("steps", 4)
    assert rank(tree, trivial_fleet({"r": 2})).status == "infeasible"
