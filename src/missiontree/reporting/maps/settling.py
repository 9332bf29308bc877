"""Settles many labels at once: each moves to where it is in nobody's way, until all are content or time is up."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from missiontree.reporting.maps.boxes import Box, Cell, cells
from missiontree.reporting.maps.labels import RINGS, Ground, Placed

ROUNDS = 8
_IN_THE_WAY = 45.0
_OF_MORE_WEIGHT = 90.0


@dataclass(frozen=True, slots=True)
class Wish:
    """
    A label that wants room.

    Parameters
    ----------
    mark
        What it names.
    width, height
        Its size.
    weight
        How much it matters: 0 most.
    farthest
        How far from its mark it may stand.
    """

    mark: Box
    width: float
    height: float
    weight: int
    farthest: float = RINGS[-1]


def settle(ground: Ground, wishes: Sequence[Wish]) -> list[Placed | None]:
    """
    Place labels so that none covers another, and take what they cover; None for those that found no room.

    First each takes the place it likes best, whoever else is there. Then, in some rounds, each moves to where its own price and the
    number of those in its way are least together. Who is in the way of one that matters more at the end, or came later, gets the best
    of what is left free. Equal wishes are settled equally.

    Parameters
    ----------
    ground
        Marks and lines.
    wishes
        The labels.
    """
    choices = [sorted(_choices(ground, wish), key=lambda place: place.price) for wish in wishes]
    table = _Table(wishes)
    for number, places in enumerate(choices):
        if places:
            table.put(number, places[0])
    for _ in range(ROUNDS):
        moved = False
        for number, places in enumerate(choices):
            if places:
                moved |= _move(number, places, table)
        if not moved:
            break
    return _final(ground, wishes, table)


def _choices(ground: Ground, wish: Wish) -> list[Placed]:
    return list(ground.places(wish.mark, wish.width, wish.height, wish.farthest))


def _move(number: int, places: Sequence[Placed], table: _Table) -> bool:
    """Let a label take its best place as things are; whether that is another one."""
    before = table.at[number]
    table.lift(number)
    best, least = places[0], float("inf")
    for place in places:
        if place.price >= least:
            break
        price = place.price + table.trouble(number, place)
        if price < least:
            best, least = place, price
    table.put(number, best)
    return best is not before


def _final(ground: Ground, wishes: Sequence[Wish], table: _Table) -> list[Placed | None]:
    """Those in nobody's way stay; the others, those that matter most first, take what is free."""
    result: list[Placed | None] = [None] * len(wishes)
    order = sorted(range(len(wishes)), key=lambda number: (wishes[number].weight, number))
    left = []
    for number in order:
        place = table.at.get(number)
        if place is not None and ground.takes(place, wishes[number].mark):
            result[number] = place
        else:
            left.append(number)
    for number in left:
        wish = wishes[number]
        result[number] = ground.place(wish.mark, wish.width, wish.height, wish.farthest)
    return result


class _Table:
    """Who is where at the moment."""

    def __init__(self, wishes: Sequence[Wish]) -> None:
        self._wishes = wishes
        self._cells: dict[Cell, dict[int, list[Box]]] = {}
        self.at: dict[int, Placed] = {}

    def put(self, number: int, place: Placed) -> None:
        """Let a label stand there."""
        self.at[number] = place
        for box in place.covers():
            for cell in cells(box):
                self._cells.setdefault(cell, {}).setdefault(number, []).append(box)

    def lift(self, number: int) -> None:
        """Take a label up again."""
        for box in self.at.pop(number).covers():
            for cell in cells(box):
                self._cells[cell].pop(number, None)

    def trouble(self, number: int, place: Placed) -> float:
        """What it costs that others stand there."""
        met: set[int] = set()
        for box in place.covers():
            for cell in cells(box):
                for other, boxes in self._cells.get(cell, {}).items():
                    if other not in met and any(box.meets(one) for one in boxes):
                        met.add(other)
        weight = self._wishes[number].weight
        return sum(_OF_MORE_WEIGHT if self._wishes[other].weight < weight else _IN_THE_WAY for other in sorted(met))
