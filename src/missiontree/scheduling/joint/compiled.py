"""The kernel at either speed: as it stands, or compiled by numba where that is installed (the extra ``fast``)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from importlib import import_module
from importlib.util import find_spec
from types import FunctionType
from typing import Any

from missiontree.mission.aside import aside
from missiontree.scheduling.joint.kernel import shop, tabu

SOURCES = (shop, tabu)
WORTH_ACTIONS, WORTH_S = 40, 5.0


@dataclass(frozen=True, slots=True)
class Engine:
    """
    Functions of the kernel and the columns they work on.

    Parameters
    ----------
    measure, keep, improve
        As in :mod:`missiontree.scheduling.joint.kernel`.
    column
        Makes a column of integers.
    slice
        Iterations between two looks at the clock.
    """

    measure: Callable[..., int]
    keep: Callable[..., None]
    improve: Callable[..., int]
    column: Callable[[Sequence[int]], Any]
    slice: int


PLAIN = Engine(shop.measure, shop.keep, tabu.improve, list, 20)


def can_compile() -> bool:
    """Whether numba is installed."""
    return find_spec("numba") is not None


@lru_cache(maxsize=1)
def fast_engine() -> Engine:
    """The compiled functions; compiled once, and kept on disk beside the package from then on."""
    # Imported here, for it takes a second, and only what a list schedule does not settle needs it.
    numba, np = import_module("numba"), import_module("numpy")
    names: dict[str, Any] = {"__name__": __name__}
    for source in SOURCES:
        names.update((name, value) for name, value in vars(source).items() if name.isupper())
    for source in SOURCES:
        for name, function in vars(source).items():
            if isinstance(function, FunctionType) and function.__module__ == source.__name__:
                copy = FunctionType(function.__code__, names, name)
                copy.__module__ = function.__module__
                names[name] = numba.njit(cache=True)(copy)

    def column(values: Sequence[int]) -> Any:
        return np.array(values if len(values) else [0], dtype=np.int64)

    engine = Engine(names["measure"], names["keep"], names["improve"], column, 100)
    _call_once(engine)
    return engine


def _call_once(engine: Engine) -> None:
    """Have all of it compiled, or loaded, by a search in a shop of one action."""
    column = engine.column
    one, none, empty = column([0]), column([-1]), column([])
    shop_of_one = shop.Shop(column([0, 1]), one, column([1]), column([0, 0]), empty, column([0, 0]), empty)
    numbers = column([0, 1 << 60, 1, 0, 0])
    columns = (one, none, none, one, *[one] * 5, one, none, one, one, numbers)
    state = shop.State(*[column(list(each)) for each in columns])
    engine.measure(shop_of_one, state)
    engine.keep(state)
    engine.improve(shop_of_one, state, 1, 0)


def engine_for(actions: int, limit_s: float, ended: Callable[[], bool]) -> Engine:
    """
    The quicker one for a search.

    Parameters
    ----------
    actions
        Of the selection; where there are few, the search is over before a compiler is loaded.
    limit_s
        What the search may take; compiling takes some ten seconds, once after each install.
    ended
        Asked meanwhile whether to stop.
    """
    if actions < WORTH_ACTIONS or not can_compile():
        return PLAIN
    if fast_engine.cache_info().currsize > 0:
        return fast_engine()
    return (aside(fast_engine, ended, whole=True) if limit_s >= WORTH_S else None) or PLAIN
