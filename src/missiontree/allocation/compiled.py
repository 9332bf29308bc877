"""The inner loops at either speed: as they stand, or compiled by numba where that is installed and worth the wait."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from importlib import import_module
from importlib.util import find_spec
from types import FunctionType, ModuleType
from typing import Any

from missiontree.allocation.kernel import branching, columns, finishing, mending, oscillating, pairing, pricing

SOURCES = (pricing, mending, pairing, oscillating, finishing, branching)


@dataclass(frozen=True, slots=True)
class Engine:
    """
    Functions of the kernel and the columns they work on.

    Parameters
    ----------
    reach, sweep, lower, shrink, mend, branch, open_bound
        As in :mod:`missiontree.allocation.kernel`.
    column
        Makes a column of integers.
    fast
        Whether they are compiled.
    """

    reach: Callable[..., int]
    sweep: Callable[..., int]
    lower: Callable[..., tuple[int, int]]
    shrink: Callable[..., int]
    mend: Callable[..., int]
    branch: Callable[..., int]
    open_bound: Callable[..., int]
    column: Callable[[Sequence[int]], Any]
    fast: bool


ENTRIES = ("reach", "sweep", "lower", "shrink", "mend", "branch", "open_bound")


def functions_of(sources: Sequence[ModuleType]) -> dict[str, FunctionType]:
    """Functions of some files of the kernel by name, each after those it calls."""
    return {
        name: function
        for source in sources
        for name, function in vars(source).items()
        if isinstance(function, FunctionType) and function.__module__ == source.__name__
    }


PLAIN = Engine(**{name: functions_of(SOURCES)[name] for name in ENTRIES}, column=list, fast=False)


def can_compile() -> bool:
    """Whether numba is installed (the extra ``fast``)."""
    return find_spec("numba") is not None


@lru_cache(maxsize=1)
def fast_engine() -> Engine:
    """The compiled functions; compiled at the first call, and kept on disk beside the package from then on."""
    np = import_module("numpy")
    names = compiled(SOURCES, columns)

    def column(values: Sequence[int]) -> Any:
        return np.array(values if len(values) else [0], dtype=np.int64)

    return Engine(**{name: names[name] for name in ENTRIES}, column=column, fast=True)


def compiled(sources: Sequence[ModuleType], *constants: ModuleType) -> dict[str, Any]:
    """
    Functions of some files of the kernel by name, each compiled when it is first called.

    They call each other by name, so each is given a namespace in which those names are compiled, too, and which holds the constants
    of these files and of others.
    """
    # Imported here, for it takes a second, and only large problems need it.
    numba = import_module("numba")
    names: dict[str, Any] = {"__name__": __name__}
    for source in (*constants, *sources):
        names.update((name, value) for name, value in vars(source).items() if name.isupper())
    for name, function in functions_of(sources).items():
        copy = FunctionType(function.__code__, names, name)
        copy.__module__ = function.__module__
        names[name] = numba.njit(cache=True, nogil=True)(copy)
    return names
