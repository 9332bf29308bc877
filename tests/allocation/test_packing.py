"""Dealing roles out to robots: exact, and honest when it gives up."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product

from hypothesis import given, settings

from missiontree.allocation.flat import Stock
from missiontree.allocation.packing import Load, pack
from tests.strategies import packings

NOBODY: frozenset[int] = frozenset()
PLENTY = 10**6


def keeps(stock: Stock, loads: list[Load], robots: Mapping[int, int]) -> bool:
    """The rules, read off an assignment of groups to robots."""
    busy = set(robots.values())
    if not set(stock.required) <= busy or (stock.max_in_use is not None and len(busy) > stock.max_in_use):
        return False
    for robot, budget in enumerate(stock.budgets):
        mine = [load for load in loads if robots[load.group] == robot]
        if any(load.group in other.apart for load in mine for other in mine):
            return False
        if any(sum(load.uses.get(name, 0) for load in mine) > limit for name, limit in budget.items()):
            return False
    return True


@settings(max_examples=600)
@given(packings())
def test_packing_agrees_with_trying_everything(problem: tuple[Stock, list[Load]]) -> None:
    """Yes comes with an assignment that keeps the rules; no means that none of all assignments does."""
    stock, loads = problem
    groups = [load.group for load in loads]
    everything = (
        dict(zip(groups, tried, strict=True)) for tried in product(range(len(stock.robots)), repeat=len(groups))
    )
    packed = pack(stock, loads, PLENTY)
    assert packed.answer == ("yes" if any(keeps(stock, loads, robots) for robots in everything) else "no")
    assert packed.answer == "no" or keeps(stock, loads, packed.robots)


@settings(max_examples=200)
@given(packings())
def test_giving_up_is_never_a_wrong_answer(problem: tuple[Stock, list[Load]]) -> None:
    """With few steps the answer may be undecided, but never the opposite of the truth."""
    stock, loads = problem
    assert pack(stock, loads, 2).answer in {"undecided", pack(stock, loads, PLENTY).answer}


def test_loads_that_fit_together_but_on_no_robot() -> None:
    # Two robots with 10 each, three loads of 6: 18 of 20 in sum, but two of them on one robot make 12.
    stock = Stock(("a", "b"), ({"e": 10}, {"e": 10}), {})
    packed = pack(stock, [Load(group, {"e": 6}, NOBODY) for group in range(3)], PLENTY)
    assert (packed.answer, packed.name) == ("no", "e")


def test_greedy_is_not_enough() -> None:
    # 5 + 5 and 4 + 3 + 3 fill two robots of 10; putting 5 and 4 together (9) leaves no room for the rest.
    stock = Stock(("a", "b"), ({"e": 10}, {"e": 10}), {})
    loads = [Load(group, {"e": used}, NOBODY) for group, used in enumerate((5, 4, 3, 5, 3))]
    packed = pack(stock, loads, PLENTY)
    assert packed.robots[0] == packed.robots[3] != packed.robots[1]


def test_too_many_to_keep_apart_blames_no_budget() -> None:
    # Three loads that need three robots, and there are two; the budget of 9 would do.
    stock = Stock(("a", "b"), ({"e": 9}, {"e": 9}), {})
    everybody = frozenset(range(3))
    packed = pack(stock, [Load(group, {"e": 1}, everybody - {group}) for group in range(3)], PLENTY)
    assert (packed.answer, packed.name) == ("no", "")


def test_many_equal_robots_are_one_case() -> None:
    # 30 robots of 10 and 31 loads of 6: no robot takes two. Without symmetry there would be 30! orders to refuse.
    stock = Stock(tuple(f"r{index}" for index in range(30)), ({"e": 10},) * 30, {})
    assert pack(stock, [Load(group, {"e": 6}, NOBODY) for group in range(31)], 1000).answer == "no"


def test_free_work_is_spread() -> None:
    # Nothing restricts three loads on two robots, so they alternate.
    packed = pack(Stock(("a", "b"), ({}, {}), {}), [Load(group, {}, NOBODY) for group in range(3)], PLENTY)
    assert packed.robots == {0: 0, 1: 1, 2: 0}


def test_robots_with_equal_budgets_left_differ_by_whom_they_hold() -> None:
    # b and a go first, to r0 and r1, and leave 6 on both. c fits either, but only with a does it leave r0 to d.
    b, a, c, d, e = range(5)
    apart = {b: {a, e}, a: {b, d}, c: {d}, d: {a, c}, e: {b}}
    uses = {b: 3, a: 3, c: 2, d: 1, e: 1}
    loads = [Load(group, {"e": uses[group]}, frozenset(apart[group])) for group in range(5)]
    packed = pack(Stock(("r0", "r1"), ({"e": 9}, {"e": 9}), {}), loads, PLENTY)
    assert packed.robots == {b: 0, a: 1, c: 1, d: 0, e: 1}
