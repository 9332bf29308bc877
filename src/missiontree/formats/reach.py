"""Times and lengths in input files that are too large to be counted exactly (:mod:`missiontree.mission.reach`), with their lines."""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite
from typing import Any

from missiontree.formats.parsed import Parsed
from missiontree.formats.place import Path
from missiontree.mission.reach import MOST_M, MOST_S

INPUTS = frozenset({"fleet", "scene", "routines", "mission", "tree"})
"""Kinds of documents that people write; times of plans are sums, and may be larger."""

_FROM_START = frozenset({"available_from_s", "available_until_s", "deadline_s", "release_s"})
_SECONDS = _FROM_START | {"duration_s", "plus_s", "ride_s"}
_METRES = frozenset({"cell_m", "corners", "height_m", "length_m", "x_m", "y_m"})


def refuse_far(parsed: Parsed) -> None:
    """
    Refuse what lasts, comes, lies or reaches farther than is counted.

    Raises
    ------
    InputError
        With the line of the first such number.
    """
    for path, name, number in _numbers(parsed.data, (), ""):
        if name in _SECONDS and number > MOST_S:
            hint = "Times count from the start of the mission." if name in _FROM_START else ""
            raise parsed.refusal(f"{number:g} s is too long", path, f"seconds from 0 to {MOST_S:,.0f}", hint)
        if name in _METRES and abs(number) > MOST_M:
            raise parsed.refusal(f"{number:g} m is too far", path, f"metres up to {MOST_M:,.0f}")


def _numbers(data: Any, path: Path, name: str) -> Iterator[tuple[Path, str, float]]:
    """Finite numbers with their paths and the names of the fields they stand in; others are refused elsewhere."""
    if isinstance(data, dict):
        for key, member in data.items():
            yield from _numbers(member, (*path, key), str(key))
    elif isinstance(data, list):
        for index, member in enumerate(data):
            yield from _numbers(member, (*path, index), name)
    elif isinstance(data, int | float) and not isinstance(data, bool) and isfinite(data):
        yield path, name, data
