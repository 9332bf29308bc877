"""A routine and whom or what it is about, as files write it: ``ReachAndTransport(keys, Anna)``."""

from __future__ import annotations

import re
from dataclasses import dataclass

_CALL = re.compile(r"\s*([A-Za-z][A-Za-z0-9_-]*)\s*\((.*)\)\s*", re.DOTALL)


@dataclass(frozen=True, slots=True)
class Call:
    """
    A routine and its arguments.

    Parameters
    ----------
    routine
        Id of the routine.
    arguments
        What stands between the commas, in order, without the blanks around it; an empty one is an empty text.
    """

    routine: str
    arguments: tuple[str, ...]


def call_of(text: str) -> Call | None:
    """The call that a text stands for; None if it is not of the form ``Routine(a, b)``."""
    found = _CALL.fullmatch(text)
    return Call(found[1], tuple(part.strip() for part in found[2].split(","))) if found else None
