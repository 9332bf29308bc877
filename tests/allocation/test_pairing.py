"""Exchanges of picks: ways stay within the purses, get better, and a chain in vain leaves no trace."""

from __future__ import annotations

import pytest

from missiontree.allocation.compiled import PLAIN, fast_engine
from missiontree.allocation.kernel.columns import NEG
from missiontree.allocation.kernel.mending import exchange
from missiontree.allocation.kernel.pairing import pair_up
from missiontree.allocation.kernel.pricing import fits, follow, reach, sweep
from missiontree.allocation.preorder import preorder
from missiontree.allocation.searched import Searched, scale_of
from tests.allocation.test_rounds import mission


def searched(seed: int, engine: object = PLAIN) -> Searched:
    problem = mission(120, 5, seed)
    scale = scale_of(problem.core)
    search = Searched(problem.core, problem.purses, preorder(problem.flat), engine, scale, deep=False)  # type: ignore[arg-type]
    search.price()
    return search


@pytest.mark.parametrize("seed", [0, 1, 3, 4, 5, 6, 7])
def test_exchanges_earn_more_and_keep_the_purses(seed: int) -> None:
    search = searched(seed)
    tree, room = search.tree, search.room
    reach(tree, room)
    sweep(tree, room, room.prices)
    for purse, price in enumerate(room.prices):
        room.trial[purse] = 4 * price + 1_000_000
    follow(tree, room)
    for _ in range(20):
        exchange(tree, room)
        if follow(tree, room) > NEG and fits(tree, room):
            break
        for purse in range(len(tree.limits)):
            room.trial[purse] *= 2
    assert fits(tree, room)
    for _ in range(6):
        before = follow(tree, room)
        changed = pair_up(tree, room)
        told = list(room.used)
        after = follow(tree, room)
        assert told == list(room.used)  # what was counted on the way is what the way uses
        assert fits(tree, room)
        assert after > before if changed else after == before


def test_mending_goes_on_where_it_stopped_and_tells_only_what_is_better() -> None:
    for engine in (PLAIN, fast_engine()):
        search = searched(3, engine)
        first = search.mended(10)
        assert first is not None
        core = search.core
        best = core.way_under(len(core) - 1, first)[1]
        for _ in range(5):
            way = search.mended(10, fresh=False)
            if way is not None:
                earned = core.way_under(len(core) - 1, way)[1]
                assert earned > best
                best = earned
