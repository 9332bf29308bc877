"""
How many roles a robot type that must take part fills, at most and at least: counted by one sweep from the leaves up.

A role counts once where its actions stand side by side in one AND, and may count more often elsewhere, so that the count is never
below the number of roles that are filled. What a choice counts less than the best beside it is its *shortfall*. The shortfalls of
all choices together may be no more than what the most leaves beyond the need: so "at least so many" becomes an "at most", and a
requirement can be kept like a budget (:mod:`purses`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from missiontree.allocation.flat import Flat


@dataclass(frozen=True, slots=True)
class Turnout:
    """
    Roles of one required type.

    Parameters
    ----------
    type_id
        The type.
    needed
        How many roles it must fill at least: one, or one for each robot of it that is required.
    most
        How many it fills at most, per node; 0 where nothing is possible.
    least
        How many it fills in any case.
    """

    type_id: str
    needed: int
    most: Sequence[int]
    least: int

    @property
    def spare(self) -> int:
        """All shortfalls together may be no more than this; below 0 if the need cannot be met."""
        return self.most[0] - self.needed

    @property
    def certain(self) -> bool:
        """Whether every way through the tree meets the need, as far as counting tells."""
        return self.least >= self.needed

    def shortfall(self, xor: int, child: int) -> int:
        """How many roles fewer than with the best choice at an XOR."""
        return self.most[xor] - self.most[child]


def turnouts(flat: Flat, possible: Sequence[bool]) -> Iterator[Turnout]:
    """One for each type that is required."""
    for type_id in flat.required:
        stock = flat.stocks.get(type_id)
        needed = max(1, len(stock.required) if stock is not None else 0)
        yield _turnout(flat, possible, type_id, needed)


def _turnout(flat: Flat, possible: Sequence[bool], type_id: str, needed: int) -> Turnout:
    most, least = [0] * len(flat.kind), [0] * len(flat.kind)
    for node in range(len(flat.kind) - 1, -1, -1):
        if not possible[node]:
            continue
        below = [child for child in flat.children[node] if possible[child]]
        if flat.kind[node] == "action":
            most[node] = least[node] = int(flat.robot_type[node] == type_id)
        elif flat.kind[node] == "xor":
            most[node] = max(most[child] for child in below)
            least[node] = min(least[child] for child in below)
        else:
            again = _again(flat, below)
            most[node] = sum(most[child] for child in below if child not in again)
            least[node] = sum(least[child] for child in below if child not in again)
    return Turnout(type_id, needed, most, least[0])


def _again(flat: Flat, siblings: Sequence[int]) -> set[int]:
    """Actions of a role and type of which an earlier sibling in the same AND has one."""
    seen: set[tuple[int, str]] = set()
    found: set[int] = set()
    for node in siblings:
        if flat.kind[node] == "action":
            key = (flat.role[node], flat.robot_type[node])
            if key in seen:
                found.add(node)
            seen.add(key)
    return found
