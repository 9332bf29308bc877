"""
Other ways near a way: take one other option at one pick.

With them a way that overdraws purses is repaired, the cheapest relief first, and one that does not is improved. Both work in
passes over all exchanges, so that large trees need few sweeps; below an option newly taken, the way goes on as the prices of the
purses advise.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from typing import NamedTuple

from missiontree.allocation.core import Core, Way
from missiontree.allocation.purses import Purses

MAX_PASSES = 20
MOST_PAIRED = 200  # exchanges that are combined two by two


class Exchange(NamedTuple):
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
    """

    pick: int
    option: int
    gain: int
    change: Mapping[int, int]


class Around:
    """
    A way and the exchanges at its picks.

    Parameters
    ----------
    core, purses
        What there is to choose.
    advised
        Options by pick, that new picks take.
    way
        Where to begin. Default: what is advised.
    """

    def __init__(self, core: Core, purses: Purses, advised: Sequence[int], way: Way | None = None) -> None:
        self.core, self.limits, self.advised = core, purses.limits, advised
        self.fresh = self.sums = core.sums().under(advised)
        if way is None:
            self.way = core.picks_under(len(core) - 1, advised)
        else:
            self._be(way)
        self.used = [self.sums.used[-1].get(purse, 0) for purse in range(len(self.limits))]

    def _be(self, way: Way) -> None:
        picked = list(self.advised)
        for pick, option in way.items():
            picked[pick] = option
        self.way, self.sums = way, self.fresh.under(picked)

    def exchanges(self, relieving: Set[int] | None = None) -> Iterator[Exchange]:
        """All exchanges; only those at picks that take from one of some purses, if they are to relieve them."""
        for pick in sorted(self.way):
            options, taken = self.core.options[pick], self.way[pick]
            part = options[taken].part
            used = self.sums.used[part]
            if relieving is not None and relieving.isdisjoint(used):
                continue
            for index, option in enumerate(options):
                if index != taken:
                    other = self.fresh.used[option.part]
                    change = {purse: -amount for purse, amount in used.items()}
                    for purse, amount in other.items():
                        change[purse] = change.get(purse, 0) + amount
                    gain = self.fresh.utility[option.part] - self.sums.utility[part]
                    yield Exchange(pick, index, gain, change)

    def dropped(self, pick: int) -> Way:
        """The picks that are reached no more if something else is taken at this one."""
        return self.core.picks_under(self.core.options[pick][self.way[pick]].part, self.way)

    def reached(self, exchange: Exchange) -> Way:
        """The picks that are reached below what is taken then."""
        return self.core.picks_under(self.core.options[exchange.pick][exchange.option].part, self.advised)

    def after(self, exchange: Exchange) -> Way:
        """The way after one exchange."""
        gone = self.dropped(exchange.pick)
        kept = {pick: option for pick, option in self.way.items() if pick not in gone}
        return {**kept, exchange.pick: exchange.option, **self.reached(exchange)}

    def overdrawn(self) -> set[int]:
        """The purses that more is taken from than they hold."""
        return {purse for purse, (used, limit) in enumerate(zip(self.used, self.limits, strict=True)) if used > limit}

    def fits(self, change: Mapping[int, int]) -> bool:
        """Whether no purse that more is taken from is overdrawn after the change."""
        return all(self.used[purse] + by <= self.limits[purse] for purse, by in change.items() if by > 0)

    def fits_after(self, change: Mapping[int, int]) -> bool:
        """Whether a way within the purses stays within them."""
        return all(self.used[purse] + by <= self.limits[purse] for purse, by in change.items())

    def relief(self, change: Mapping[int, int]) -> float:
        """By how much less the purses are overdrawn after the change, as shares of their limits."""
        less = 0.0
        for purse, by in change.items():
            left = self.limits[purse] - self.used[purse]
            if left < 0 or by > left:
                less += (max(0, -left) - max(0, by - left)) / max(1, self.limits[purse])
        return less

    def move(self, wanted: Sequence[Exchange], repairing: bool) -> bool:
        """Make all wanted exchanges that still help and do not stand inside one another; whether there were any."""
        gone, touched = set[int](), set[int]()
        kept, new = dict(self.way), Way()
        for exchange in wanted:
            if exchange.pick in gone:
                continue
            if self.relief(exchange.change) <= 0 if repairing else not self.fits(exchange.change):
                continue
            dropped = self.dropped(exchange.pick)
            if not touched.isdisjoint(dropped):
                continue
            for purse, by in exchange.change.items():
                self.used[purse] += by
            touched.add(exchange.pick)
            gone |= {exchange.pick, *dropped}
            for pick in dropped:
                kept.pop(pick, None)
            kept[exchange.pick] = exchange.option
            new.update(self.reached(exchange))
        if not touched:
            return False
        self._be({**kept, **new})
        return True


def repaired(core: Core, purses: Purses, advised: Sequence[int]) -> Way | None:
    """The advised way after exchanges that keep every purse; None if passes do not suffice."""
    around = Around(core, purses, advised)
    for _ in range(MAX_PASSES):
        overdrawn = around.overdrawn()
        if not overdrawn:
            return around.way
        rated = [
            (-exchange.gain / relief, exchange.pick, exchange.option, exchange)
            for exchange in around.exchanges(overdrawn)
            if (relief := around.relief(exchange.change)) > 0
        ]
        rated.sort(key=lambda entry: entry[:3])
        if not around.move([exchange for *_, exchange in rated], repairing=True):
            return None
    return None if around.overdrawn() else around.way


def improved(core: Core, purses: Purses, way: Way, advised: Sequence[int], ended: Callable[[], bool]) -> Way:
    """The way after exchanges that gain utility and keep every purse, until there are none, or somebody says stop."""
    if ended():
        return way
    around = Around(core, purses, advised, way)
    for _ in range(MAX_PASSES):
        better = [entry for entry in around.exchanges() if entry.gain > 0 and around.fits(entry.change)]
        better.sort(key=lambda exchange: (-exchange.gain, exchange.pick, exchange.option))
        if not around.move(better, repairing=False) or ended():
            break
    return around.way


def neighbours(core: Core, purses: Purses, way: Way, advised: Sequence[int]) -> list[Way]:
    """All ways one exchange away that keep every purse, best first."""
    around = Around(core, purses, advised, way)
    near = [entry for entry in around.exchanges() if around.fits(entry.change)]
    near.sort(key=lambda exchange: (-exchange.gain, exchange.pick, exchange.option))
    return [around.after(exchange) for exchange in near]


def near_pairs(
    core: Core, purses: Purses, way: Way, advised: Sequence[int], prices: Sequence[float], count: int
) -> list[Way]:
    """
    Ways two exchanges away that keep every purse: so many of the best, best first.

    Only exchanges that lose least after prices are combined, and none inside another.
    """
    around = Around(core, purses, advised, way)
    rated = [
        (entry.gain - sum(prices[purse] * by for purse, by in entry.change.items()), entry)
        for entry in around.exchanges()
    ]
    rated.sort(key=lambda pair: (-pair[0], pair[1].pick, pair[1].option))
    close = [entry for _, entry in rated[:MOST_PAIRED]]
    dropped = {pick: around.dropped(pick) for pick in {entry.pick for entry in close}}
    best: list[tuple[int, int, int]] = []  # heap of gain, places (negative, so that earlier ones stay)
    for place, one in enumerate(close):
        for later in range(place + 1, len(close)):
            other = close[later]
            gain = one.gain + other.gain
            if len(best) == count and gain <= best[0][0]:
                continue
            if one.pick == other.pick or one.pick in dropped[other.pick] or other.pick in dropped[one.pick]:
                continue
            change = dict(one.change)
            for purse, by in other.change.items():
                change[purse] = change.get(purse, 0) + by
            if around.fits_after(change):
                (heapq.heappush if len(best) < count else heapq.heappushpop)(best, (gain, -place, -later))
    return [_both(around, close[-place], close[-later]) for _, place, later in sorted(best, reverse=True)]


def _both(around: Around, one: Exchange, other: Exchange) -> Way:
    """The way after two exchanges, neither inside the other."""
    gone = around.dropped(other.pick)
    kept = {pick: option for pick, option in around.after(one).items() if pick not in gone}
    return {**kept, other.pick: other.option, **around.reached(other)}
