"""The pool: feasible alternatives by cheap methods, in order, whatever time there is."""

from __future__ import annotations

from hypothesis import given, settings

from benchmarks.random_trees import Case
from benchmarks.tied_budget import tied_mission
from missiontree.allocation.core import Core, core_of
from missiontree.allocation.coupling import couples
from missiontree.allocation.exchanges import Around, improved, near_pairs, neighbours, repaired
from missiontree.allocation.exhaustive import Exhaustive
from missiontree.allocation.feasibility import Feasibility
from missiontree.allocation.flat import Flat, flatten
from missiontree.allocation.pool import Pool, fill, start
from missiontree.allocation.possible import possible_nodes
from missiontree.allocation.purses import Purses, purses_of
from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree
from tests.strategies import cases


def parts(tree: GroundedTree, fleet: Fleet, weights: Weights | None = None) -> tuple[Flat, Core, Purses, list[bool]]:
    flat = flatten(tree, fleet, weights or Weights())
    possible = list(possible_nodes(flat).possible)
    purses = purses_of(flat, possible)
    return flat, core_of(flat, possible, purses), purses, possible


def cheapest(core: Core, price: int) -> list[int]:
    """Of each pick, the option that earns most after that price for a unit of the first purse; all options are leaves here."""
    earned = [
        utility - price * sum(amount for _, amount in uses)
        for utility, uses in zip(core.utility, core.uses, strict=True)
    ]
    return [
        max(range(len(options)), key=lambda index: (earned[options[index].part], -index)) if options else 0
        for options in core.options
    ]


def pool_of(flat: Flat, possible: list[bool], k: int) -> Pool:
    return Pool(flat, possible, Feasibility(flat) if couples(flat) else None, k)


@settings(max_examples=100)
@given(cases())
def test_the_pool_is_feasible_in_order_and_below_the_bound(case: Case) -> None:
    truth = Exhaustive()(case.tree, case.fleet, case.weights, 10**6, Control()).alternatives
    flat = flatten(case.tree, case.fleet, case.weights)
    if not possible_nodes(flat).possible[0]:
        return
    flat, core, purses, possible = parts(case.tree, case.fleet, case.weights)
    pool = pool_of(flat, possible, 3)
    advised = [[0] * len(core), [len(options) - 1 for options in core.options]]
    ways = start(pool, core, purses, None, advised[0], advised[1:], [0.0] * len(purses.limits), Control())
    fill(pool, core, purses, ways, advised[0], Control())
    ranks = {tuple((choice.xor, choice.child) for choice in entry.choices): entry.rank for entry in truth}
    listed = [ranks[entry.selection.choices] for entry in pool.listed() if entry.verdict.answer == "yes"]
    assert listed == sorted(set(listed))


def test_repair_takes_the_cheapest_relief() -> None:
    _, core, purses, _ = parts(*tied_mission(5, {"a": 3}))
    advised = cheapest(core, 0)
    # Without a price everybody takes a; two must give it up, which costs 0.1 each: 3 + 2 * 0.9 = 4.8.
    way = repaired(core, purses, advised)
    assert way is not None
    assert core.way_under(len(core) - 1, way)[1:] == (4_800_000, {0: 3})
    # From there every exchange of an a for a b keeps the purse, and none of a b for an a does.
    assert [core.way_under(len(core) - 1, near)[1] for near in neighbours(core, purses, way, advised)] == [
        4_700_000
    ] * 3


def test_improvement_uses_what_is_left() -> None:
    _, core, purses, _ = parts(*tied_mission(5, {"a": 3}))
    advised = cheapest(core, 1_000_000)  # at a price of 1 for each use nobody takes a
    way = core.way_under(len(core) - 1, advised)[0]
    around = Around(core, purses, advised, way)
    assert [(entry.gain, entry.change) for entry in around.exchanges()] == [(100_000, {0: 1})] * 5
    better = improved(core, purses, way, advised, lambda: False)
    assert core.way_under(len(core) - 1, better)[1:] == (4_800_000, {0: 3})
    assert improved(core, purses, way, advised, lambda: True) == way


def test_the_kth_and_what_was_refused() -> None:
    tree, fleet = tied_mission(2, {"a": 1})
    flat, _, _, possible = parts(tree, fleet)
    pool = pool_of(flat, possible, 2)
    xors = [node for node, kind in enumerate(flat.kind) if kind == "xor"]
    assert not pool.offer(dict.fromkeys(xors, 0))  # a twice, where the budget holds one
    assert pool.offer(dict.fromkeys(xors, 1))
    assert (pool.highest, pool.kth) == (1_800_000, None)
    assert pool.offer({xors[0]: 0, xors[1]: 1})
    assert (pool.highest, pool.kth, len(pool.listed())) == (1_900_000, 1_800_000, 2)


def test_two_exchanges_reach_what_one_does_not() -> None:
    """From a, b, b every way with one a is two exchanges away, and from a, a, b, where the purse holds one, none is."""
    _, core, purses, _ = parts(*tied_mission(3, {"a": 1}))
    picks = [part for part, options in enumerate(core.options) if options]
    way = dict(zip(picks, (0, 1, 1), strict=True))
    found = near_pairs(core, purses, way, cheapest(core, 1_000_000), [100_000.0], 5)
    assert [core.way_under(len(core) - 1, near)[1:] for near in found] == [(2_800_000, {0: 1})] * 2
    assert way not in found


def test_something_to_show_when_time_is_up() -> None:
    flat, core, purses, possible = parts(*tied_mission(30, {"a": 3}))
    pool = pool_of(flat, possible, 4)
    ways = start(pool, core, purses, None, cheapest(core, 0), [cheapest(core, 0)], [0.0], Control(time_limit_s=0))
    assert (pool.highest, len(ways)) == (27_300_000, 1)


def test_equal_ones_are_counted() -> None:
    tree, fleet = tied_mission(3, {"a": 1})
    flat, _, _, possible = parts(tree, fleet)
    pool = pool_of(flat, possible, 2)
    xors = [node for node, kind in enumerate(flat.kind) if kind == "xor"]
    for chosen in range(3):
        pool.offer({xor: int(place != chosen) for place, xor in enumerate(xors)})
    pool.offer(dict.fromkeys(xors, 1))
    assert (pool.found(2_700_000), pool.kth, pool.tied) == (4, 2_800_000, 3)
    assert [pool.better_than(utility) for utility in (2_800_000, 2_700_000)] == [0, 2]
