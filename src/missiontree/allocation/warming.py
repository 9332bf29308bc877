"""The compiled inner loops, ready to be used: they are compiled, or loaded, beforehand, and nobody has to wait for it."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

from missiontree.allocation.compiled import Engine, fast_engine
from missiontree.allocation.core import Core, Option
from missiontree.allocation.purses import Purses
from missiontree.allocation.searched import Searched, scale_of
from missiontree.mission.aside import aside

STEPS, NODES = 1, 4


@lru_cache(maxsize=1)
def warm_engine() -> Engine:
    """The compiled functions, each of them called once on a choice between two actions under one budget."""
    core = Core()
    dear, cheap = core.add(2, ((0, 2),)), core.add(1)
    core.add(options=(Option(dear, 0, 0, 1), Option(cheap, 0, 1, 2)))
    search = Searched(core, Purses((("", "budget"),), (1,), (1,)), (0, 1, 2), engine := fast_engine(), scale_of(core))
    bound = search.price(STEPS)
    search.mended(1)
    search.narrowed(0)
    search.branch(search.scale.up(0), STEPS, False, NODES)
    search.bound(bound)
    search.advised()
    return engine


def is_warm() -> bool:
    """Whether they are ready, so that they cost nothing more."""
    return warm_engine.cache_info().currsize > 0


def engine_unless(ended: Callable[[], bool]) -> Engine | None:
    """The compiled functions; None if somebody says stop before they are ready."""
    return warm_engine() if is_warm() else aside(warm_engine, ended, whole=True)
