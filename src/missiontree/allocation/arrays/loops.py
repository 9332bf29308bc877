"""The sweeps at either speed: as they stand, or compiled by numba; the same integers come out."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from heapq import nsmallest
from importlib import import_module
from typing import Any

from missiontree.allocation.compiled import compiled
from missiontree.allocation.kernel import sweeping

_Column = Any  # a list, or an array of 64-bit integers


@dataclass(frozen=True, slots=True)
class Loops:
    """
    The sweeps and the columns they work on.

    Parameters
    ----------
    best_below, losses, follow_best, first_in_order
        As in :mod:`missiontree.allocation.kernel.sweeping`.
    column
        A column of numbers of one's own, from any other.
    filled
        A column of so many equal numbers.
    joined
        Parts of columns, one behind the other.
    gathered
        A column's numbers at some places.
    smallest
        Which number has so many before it when a column is sorted.
    parted
        Of options with their losses: those with less than a given loss, and those with exactly that.
    """

    best_below: Callable[..., int]
    losses: Callable[..., int]
    follow_best: Callable[..., tuple[int, int]]
    first_in_order: Callable[..., int]
    column: Callable[[Sequence[int]], _Column]
    filled: Callable[[int, int], _Column]
    joined: Callable[[Sequence[_Column]], _Column]
    gathered: Callable[[_Column, _Column], _Column]
    smallest: Callable[[_Column, int], int]
    parted: Callable[[_Column, _Column, int], tuple[list[int], list[int]]]


ENTRIES = ("best_below", "losses", "follow_best", "first_in_order")
WHOLE_BITS = 61  # of a sum of utilities; the difference of two has one more
MANY = 1_000  # from here on sorting is quicker than picking


def _joined(parts: Sequence[list[int]]) -> list[int]:
    whole: list[int] = []
    for part in parts:
        whole += part
    return whole


PLAIN = Loops(
    **{name: getattr(sweeping, name) for name in ENTRIES},
    column=list,
    filled=lambda length, number: [number] * length,
    joined=_joined,
    gathered=lambda column, places: list(map(column.__getitem__, places)),
    smallest=lambda column, place: nsmallest(place + 1, column)[-1] if place < MANY else sorted(column)[place],
    parted=lambda option, lost, most: (
        [node for node, less in zip(option, lost, strict=True) if less < most],
        [node for node, less in zip(option, lost, strict=True) if less == most],
    ),
)


def fits(span: int) -> bool:
    """Whether sums of utilities of no more than this, or less than its negative, can be added up compiled."""
    return span.bit_length() <= WHOLE_BITS


def are_compiled() -> bool:
    """Whether they were compiled or loaded already, so that they cost nothing more."""
    return fast_loops.cache_info().currsize > 0


@lru_cache(maxsize=1)
def fast_loops() -> Loops:
    """The compiled sweeps; compiled when they are first called, and kept on disk beside the package from then on."""
    np = import_module("numpy")
    names = compiled((sweeping,))
    return Loops(
        **{name: names[name] for name in ENTRIES},
        column=lambda numbers: np.array(numbers, dtype=np.int64),
        filled=lambda length, number: np.full(length, number, dtype=np.int64),
        joined=np.concatenate,
        gathered=lambda column, places: column[places],
        smallest=lambda column, place: int(np.partition(column, place)[place]),
        parted=lambda option, lost, most: (option[lost < most].tolist(), option[lost == most].tolist()),
    )
