"""Trying out the last picks: whether a way is left is told rightly."""

from __future__ import annotations

from itertools import product

from hypothesis import given, settings

from benchmarks.random_trees import Case
from missiontree.allocation.kernel.columns import BASE, TOPS
from missiontree.allocation.kernel.finishing import may_hold
from missiontree.allocation.kernel.pricing import reach, shrink
from missiontree.allocation.searched import Searched
from tests.allocation.test_searched import boiled
from tests.builders import and_, grounded, leaf, trivial_fleet, xor_
from tests.strategies import cases


@given(case=cases())
@settings(max_examples=200)
def test_whether_a_way_is_left_is_told_rightly(case: Case) -> None:
    problem = boiled(case.tree, case.fleet, case.weights)
    if problem is None or not problem.purses.limits:
        return
    search = problem.searched()
    bound = search.scale.up(search.price())
    for loss in range(0, 40, 4):
        target = bound - loss * search.scale.factor
        for edge in range(len(search.room.alive)):
            search.room.alive[edge] = 1
        reach(search.tree, search.room)
        tight = shrink(search.tree, search.room, target)
        left = utilities_left(search) if tight >= target else None
        if left is not None:
            assert may_hold(search.tree, search.room, tight - target) == any(utility >= target for utility in left)


def test_a_pick_whose_options_go_on_is_not_tried() -> None:
    search = nested()
    reach(search.tree, search.room)
    shrink(search.tree, search.room, -(1 << 40))
    assert utilities_left(search) is None
    assert may_hold(search.tree, search.room, -1)  # a no would need a look further down


def nested() -> Searched:
    """One of two: an action, or one of two others; each uses all that there is."""
    acts = [leaf(name, quality=quality, uses={"energy_j": 5}) for name, quality in (("a", 3), ("b", 2), ("c", 1))]
    tree = grounded(and_(xor_(acts[0], and_(acts[1], xor_(acts[2], leaf("d"))))))
    problem = boiled(tree, trivial_fleet(limits={"energy_j": 5}))
    assert problem is not None
    return problem.searched()


def utilities_left(search: Searched) -> list[int] | None:
    """Scaled utilities of the ways left that keep the purses, by plain counting; None if some option is not settled, or none is open."""
    tree, room = search.tree, search.room
    picks = [room.tops[place] for place in range(room.numbers[TOPS])]
    open_edges = [
        [edge for edge in range(tree.first[part], tree.first[part + 1]) if room.alive[edge]] for part in picks
    ]
    children = [tree.below[edge] for edges in open_edges for edge in edges]
    if not picks or any(tree.first[child] != tree.first[child + 1] for child in children):
        return None
    found = []
    for edges in product(*open_edges):
        used, earned = list(room.base_used), room.numbers[BASE]
        for edge in edges:
            child = tree.below[edge]
            earned += tree.value[child]
            for entry in range(tree.use_first[child], tree.use_first[child + 1]):
                used[tree.use_purse[entry]] += tree.use_amount[entry]
        if all(amount <= limit for amount, limit in zip(used, tree.limits, strict=True)):
            found.append(earned)
    return found
