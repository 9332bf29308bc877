"""The steps in which a number is changed: thousandths of its unit, and whole robots."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction

from missiontree.mission.change import Change, ChangeKind

WHOLE: frozenset[ChangeKind] = frozenset({"add_robot", "raise_in_use", "raise_capacity"})
DOWN: frozenset[ChangeKind] = frozenset({"lower_min_quality", "move_release", "come_earlier", "lower_limit"})
STEPS = 1000
"""Steps to a unit: a time is found to the tick, a mass to the gram."""


def sized(change: Change) -> bool:
    """Whether a change stands for a number that is still to be found."""
    return change.was is not None and change.to is None


def at_step(change: Change, step: int) -> Change:
    """A change by so many steps. What is lowered does not fall below 0."""
    assert change.was is not None, "only numbers have steps"
    if change.kind in WHOLE:
        return replace(change, to=change.was + step)
    was = _exact(change.was) * STEPS
    at = math.ceil(was) - step if change.kind in DOWN else math.floor(was) + step
    return replace(change, to=max(0, at) / STEPS)


def step_of(change: Change, to: float) -> int:
    """The least step by which a change reaches a number."""
    assert change.was is not None, "only numbers have steps"
    if change.kind in WHOLE:
        return math.ceil(to - change.was)
    was, wanted = _exact(change.was) * STEPS, _exact(to) * STEPS
    return math.ceil(was) - math.floor(wanted) if change.kind in DOWN else math.ceil(wanted) - math.floor(was)


def last_step(change: Change, most_added: int) -> int | None:
    """The step beyond which there is nothing: all robots that are added at most, or 0; None if there is no end."""
    assert change.was is not None, "only numbers have steps"
    if change.kind == "add_robot":
        return most_added
    return math.ceil(_exact(change.was) * STEPS) if change.kind in DOWN else None


def _exact(number: float) -> Fraction:
    """A number as it is written: 0.1 is a tenth, not the nearest binary fraction."""
    return Fraction(repr(number))
