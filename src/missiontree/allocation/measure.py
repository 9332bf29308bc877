"""What an alternative is worth: the sum, the mean or the least of its actions' utilities, as an exact fraction."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import ceil

from missiontree.allocation.flat import Flat
from missiontree.mission.aim import Accumulate
from missiontree.mission.alternative import Alternative
from missiontree.mission.estimate import MICRO

NOISE = 2**-50  # of a bound that came as a float: more than what writing it down may have taken away, as a share


def worth_of(flat: Flat, leaves: Sequence[int], accumulate: Accumulate) -> Fraction:
    """Worth of an alternative with these leaves, in millionths; 0 if it has none."""
    utilities = [flat.utility[leaf] for leaf in leaves]
    if not utilities:
        return Fraction(0)
    if accumulate == "min":
        return Fraction(min(utilities))
    return Fraction(sum(utilities), len(utilities) if accumulate == "mean" else 1)


def told(worth: Fraction) -> float:
    """A worth as alternatives tell it, in steps of 1e-6, rounded half to even."""
    return round(worth) / MICRO


def told_bound(bound: Fraction) -> float:
    """A bound as certificates tell it, in steps of 1e-6, rounded up."""
    return ceil(bound) / MICRO


def bound_of(bound: float) -> Fraction:
    """A bound that a certificate tells, in millionths; never below the number that the float stands for."""
    exact = Fraction(bound) * MICRO
    return exact + abs(exact) * Fraction(NOISE)


def leaves_of(flat: Flat, alternative: Alternative) -> list[int]:
    """Selected leaves, in preorder."""
    taken = {choice.xor: choice.child for choice in alternative.choices}
    leaves, stack = [], [0]
    while stack:
        node = stack.pop()
        if flat.kind[node] == "action":
            leaves.append(node)
        elif flat.kind[node] == "xor":
            stack.append(taken[node])
        else:
            stack.extend(flat.children[node][::-1])
    return leaves


def places_of(flat: Flat, alternative: Alternative) -> tuple[int, ...]:
    """Choice indices in preorder, by which equals are ordered."""
    return tuple(flat.children[choice.xor].index(choice.child) for choice in alternative.choices)


def team_of(alternative: Alternative) -> frozenset[str]:
    """The robot types that take part."""
    return frozenset(filled.robot_type for filled in alternative.roles)
