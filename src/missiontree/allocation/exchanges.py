"""
Other ways near a way: take one other option at one pick.

With them a way that overdraws purses is repaired, the cheapest relief first, and one that does not is improved. Both work in
passes over all exchanges, so that large trees need few sweeps; below an option newly taken, the way goes on as the prices of the
purses advise.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from missiontree.allocation.core import Core, Way
from missiontree.allocation.purses import Purses

MAX_PASSES = 20
MOST_PAIRED = 200  # exchanges that are combined two by two


@dataclass(frozen=True, slots=True)
class Exchange:
    """
    One other option at one pick.

    Parameters
    ----------
    pick, option
        What is taken where.
    gain
        Of utility, in millionths.
    change
        Of use, by purse.
    way
        The picks below it then.
    dropped
        The picks that are reached no more.
    """

    pick: int
    option: int
    gain: int
    change: Mapping[int, int]
    way: Way
    dropped: frozenset[int]

    def applied(self, way: Way) -> Way:
        """The way after the exchange."""
        kept = {pick: option for pick, option in way.items() if pick not in self.dropped}
        return {**kept, self.pick: self.option, **self.way}


def exchanges(core: Core, way: Way, advised: Sequence[int]) -> Iterator[Exchange]:
    """All exchanges of a way; new picks take the advised options."""
    for pick, taken in sorted(way.items()):
        before, utility, used = core.way_under(core.options[pick][taken].part, way)
        dropped = frozenset(before)
        for index, option in enumerate(core.options[pick]):
            if index != taken:
                after, other_utility, other_used = core.way_under(option.part, advised)
                change = {
                    purse: other_used.get(purse, 0) - used.get(purse, 0) for purse in (used.keys() | other_used.keys())
                }
                yield Exchange(pick, index, other_utility - utility, change, after, dropped)


def repaired(core: Core, purses: Purses, advised: Sequence[int]) -> Way | None:
    """The advised way after exchanges that keep every purse; None if passes do not suffice."""
    way, _, used = core.way_under(len(core) - 1, advised)
    state = _State(purses, used)
    for _ in range(MAX_PASSES):
        if state.fits({}):
            return way
        rated = sorted(
            (-exchange.gain / relief, exchange.pick, exchange.option, exchange)
            for exchange in exchanges(core, way, advised)
            if (relief := state.relief(exchange.change)) > 0
        )
        changed = state.apply(way, [exchange for *_, exchange in rated], repairing=True)
        if changed == way:
            return None
        way = changed
    return way if state.fits({}) else None


def improved(core: Core, purses: Purses, way: Way, advised: Sequence[int], ended: Callable[[], bool]) -> Way:
    """The way after exchanges that gain utility and keep every purse, until there are none, or somebody says stop."""
    state = _State(purses, core.way_under(len(core) - 1, way)[2])
    for _ in range(MAX_PASSES):
        if ended():
            break
        better = [entry for entry in exchanges(core, way, advised) if entry.gain > 0 and state.fits(entry.change)]
        better.sort(key=lambda exchange: (-exchange.gain, exchange.pick, exchange.option))
        if not better:
            break
        way = state.apply(way, better, repairing=False)
    return way


def neighbours(core: Core, purses: Purses, way: Way, advised: Sequence[int]) -> list[Way]:
    """All ways one exchange away that keep every purse, best first."""
    state = _State(purses, core.way_under(len(core) - 1, way)[2])
    near = [entry for entry in exchanges(core, way, advised) if state.fits(entry.change)]
    near.sort(key=lambda exchange: (-exchange.gain, exchange.pick, exchange.option))
    return [exchange.applied(way) for exchange in near]


def near_pairs(
    core: Core, purses: Purses, way: Way, advised: Sequence[int], prices: Sequence[float], count: int
) -> list[Way]:
    """
    Ways two exchanges away that keep every purse: so many of the best, best first.

    Only exchanges that lose least after prices are combined, and none inside another.
    """
    state = _State(purses, core.way_under(len(core) - 1, way)[2])
    rated = [
        (entry.gain - sum(prices[purse] * by for purse, by in entry.change.items()), entry)
        for entry in exchanges(core, way, advised)
    ]
    rated.sort(key=lambda pair: (-pair[0], pair[1].pick, pair[1].option))
    close = [entry for _, entry in rated[:MOST_PAIRED]]
    best: list[tuple[int, int, int]] = []  # heap of gain, places (negative, so that earlier ones stay)
    for place, one in enumerate(close):
        for later in range(place + 1, len(close)):
            other = close[later]
            gain = one.gain + other.gain
            if len(best) == count and gain <= best[0][0]:
                continue
            if one.pick == other.pick or one.pick in other.dropped or other.pick in one.dropped:
                continue
            change = dict(one.change)
            for purse, by in other.change.items():
                change[purse] = change.get(purse, 0) + by
            if state.fits_after(change):
                (heapq.heappush if len(best) < count else heapq.heappushpop)(best, (gain, -place, -later))
    return [close[-later].applied(close[-place].applied(way)) for _, place, later in sorted(best, reverse=True)]


class _State:
    """What is taken from the purses so far."""

    def __init__(self, purses: Purses, used: Mapping[int, int]) -> None:
        self.limits = purses.limits
        self.used = [used.get(purse, 0) for purse in range(len(purses.limits))]

    def fits(self, change: Mapping[int, int]) -> bool:
        """Whether no purse is overdrawn after the change."""
        if change:
            return all(self.used[purse] + by <= self.limits[purse] for purse, by in change.items() if by > 0)
        return all(used <= limit for used, limit in zip(self.used, self.limits, strict=True))

    def fits_after(self, change: Mapping[int, int]) -> bool:
        """Whether a way within the purses stays within them."""
        return all(self.used[purse] + by <= self.limits[purse] for purse, by in change.items())

    def relief(self, change: Mapping[int, int]) -> float:
        """By how much less the purses are overdrawn after the change, as shares of their limits."""
        return sum(
            (max(0, self.used[purse] - self.limits[purse]) - max(0, self.used[purse] + by - self.limits[purse]))
            / max(1, self.limits[purse])
            for purse, by in change.items()
        )

    def apply(self, way: Way, wanted: Sequence[Exchange], repairing: bool) -> Way:
        """The way after all wanted exchanges that still help and do not stand inside one another."""
        gone, touched = set[int](), set[int]()
        kept, new = dict(way), Way()
        for exchange in wanted:
            if exchange.pick in gone or not exchange.dropped.isdisjoint(touched):
                continue
            if self.relief(exchange.change) <= 0 if repairing else not self.fits(exchange.change):
                continue
            for purse, by in exchange.change.items():
                self.used[purse] += by
            touched.add(exchange.pick)
            gone |= {exchange.pick, *exchange.dropped}
            for pick in exchange.dropped:
                kept.pop(pick, None)
            kept[exchange.pick] = exchange.option
            new.update(exchange.way)
        return {**kept, **new}
