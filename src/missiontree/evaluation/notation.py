"""The short notation of suites: routine calls such as ``Reach(Anna) by social_robot``, and order such as ``1 < 2``."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

from missiontree.mission.value import Count, Id, Value

Relation = Literal["<", "~"]
_CALL = re.compile(r"\s*([A-Za-z][A-Za-z0-9_-]*)\s*\(([^()]*)\)(?:\s+(not\s+by|by)\s+(.*\S))?\s*")
_TYPES = re.compile(r"\s*,\s*")
_ORDER = re.compile(r"\s*([0-9]{1,4})\s*([<~])\s*([0-9]{1,4})\s*")
ANYTHING = "*"
"""Stands for an argument of which nothing is said."""
_IN_BRACKETS = "within square brackets a call with a comma needs quotes"


@dataclass(frozen=True, slots=True, kw_only=True)
class PlannedCall(Value):
    """
    One routine of an expected plan, or one that must or must not be in it.

    Parameters
    ----------
    routine
        Its id.
    arguments
        What it is about, by name, in the routine's order; ``*`` where that is left open.
    by
        Robot types that alone may do it; None means no such restriction.
    not_by
        Robot types that may not do it.
    """

    routine: Id
    arguments: tuple[str, ...]
    by: tuple[Id, ...] | None = None
    not_by: tuple[Id, ...] = ()

    def _check(self) -> None:
        if not self.arguments or not all(name.strip() for name in self.arguments):
            raise ValueError(f"the routine {self.routine!r} has an argument without a name.")

    @property
    def types(self) -> tuple[str, ...]:
        """Robot types that it names."""
        return (*(self.by or ()), *self.not_by)


@dataclass(frozen=True, slots=True)
class Order(Value):
    """
    A relation between two routines of an expected plan, which are numbered from 1 as they are written.

    Parameters
    ----------
    first, second
        Numbers of the routines.
    relation
        ``<``: the first ends before the second starts. ``~``: the first lasts until the second ends.
    """

    first: Count
    second: Count
    relation: Relation = "<"

    def _check(self) -> None:
        if self.first == self.second:
            raise ValueError(f"routine {self.first} is related to itself.")


def call_from(text: str) -> PlannedCall:
    """
    The routine call that a text stands for.

    Raises
    ------
    ValueError
        If it is none; quotes the text.
    """
    match = _CALL.fullmatch(text)
    if match is None:
        more = f"; {_IN_BRACKETS}" if text.count("(") != text.count(")") else ""
        raise ValueError(
            f"{text!r} is not of the form 'Routine(A, B)', with 'by type' or 'not by type' behind it{more}."
        )
    types = tuple(_TYPES.split(match[4])) if match[4] else ()
    names = tuple(" ".join(name.split()) for name in match[2].split(","))
    try:
        if match[3] == "by":
            return PlannedCall(routine=match[1], arguments=names, by=types)
        return PlannedCall(routine=match[1], arguments=names, not_by=types)
    except ValueError as error:
        raise ValueError(f"{text!r} cannot be understood; {error}") from error


def order_from(text: str) -> Order:
    """
    The relation that a text stands for.

    Raises
    ------
    ValueError
        If it is none; quotes the text.
    """
    match = _ORDER.fullmatch(text)
    if match is None:
        raise ValueError(f"{text!r} is not of the form '1 < 2' (ends before) or '1 ~ 2' (lasts until the end of).")
    try:
        return Order(int(match[1]), int(match[3]), "<" if match[2] == "<" else "~")
    except ValueError as error:
        raise ValueError(f"{text!r} cannot be kept; {error}") from error
