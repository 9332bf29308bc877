"""
Lagrangian multipliers: a price on every purse instead of a limit.

With prices the best way through the tree is found by one sweep, and what it earns, plus the prices of all that the purses hold,
is no less than what any way within the limits earns. A few dozen subgradient steps look for prices that make this bound low
(Held, Wolfe and Crowder, "Validation of subgradient optimization", 1974). Steps are taken in floats; the bound itself, and
every bound on a part, is computed in integers from prices rounded once, so that it holds exactly.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from missiontree.allocation.core import Core
from missiontree.allocation.purses import Purses

SCALE = 1 << 32  # steps of a price in one millionth of utility
STEPS = 60
MAX_SWEPT = 3_000_000  # parts swept in all steps together

Visit = Callable[[list[int], float], int | None]


@dataclass(frozen=True, slots=True)
class Relaxed:
    """
    What prices prove.

    Parameters
    ----------
    bound
        No way within the purses has more utility, in millionths.
    prices
        Per purse and unit, in ``SCALE`` parts of a millionth.
    held
        The prices of all that the purses hold.
    outside
        Per part, the most that the rest of a way through it can earn after prices.
    """

    bound: int
    prices: tuple[int, ...]
    held: int
    outside: tuple[int, ...]

    def least(self, part: int, utility: int) -> int:
        """What ways of doing the part must earn after prices, if a whole way through them reaches that utility."""
        return SCALE * utility - self.held - self.outside[part]


def sweep(core: Core, prices: Sequence[float], scale: int = 1) -> tuple[list[float], list[int]]:
    """The most every part can earn after prices, and the option picked for it; exact if prices are integers."""
    most: list[float] = []
    picked = [0] * len(core)
    rows = zip(core.utility, core.uses, core.pair, core.options, strict=True)
    for part, (utility, uses, pair, options) in enumerate(rows):
        if pair is not None:
            most.append(most[pair[0]] + most[pair[1]])
        elif options:
            best, at = most[options[0].part], 0
            for index, option in enumerate(options):
                if most[option.part] > best:
                    best, at = most[option.part], index
            most.append(best)
            picked[part] = at
        else:
            most.append(scale * utility - sum(prices[purse] * amount for purse, amount in uses))
    return most, picked


def relax(core: Core, purses: Purses, visit: Visit, ended: Callable[[], bool]) -> Relaxed:
    """
    Look for good prices.

    Parameters
    ----------
    core, purses
        The problem.
    visit
        Shown the options picked at every step and its bound (millionths); answers with the best feasible utility so far.
    ended
        Whether to stop; one step is always taken.
    """
    prices = [0.0] * len(purses.limits)
    best, best_prices, stride, idle = float("inf"), list(prices), 1.0, 0
    for _ in range(max(4, min(STEPS, MAX_SWEPT // len(core)))):
        most, picked = sweep(core, prices)
        earned = most[-1] + sum(price * limit for price, limit in zip(prices, purses.limits, strict=True))
        if earned < best:
            best, best_prices, idle = earned, list(prices), 0
        else:
            idle += 1
        if idle == 5:
            prices, stride, idle = list(best_prices), stride / 2, 0
            continue
        known = visit(picked, best)
        _, _, used = core.way_under(len(core) - 1, picked)
        lacking = [(used.get(index, 0) - limit) / max(1, limit) for index, limit in enumerate(purses.limits)]
        length = sum(over * over for over, price in zip(lacking, prices, strict=True) if over > 0 or price > 0)
        gap = earned - known if known is not None else abs(earned) / 20
        if not length or gap < 1 or ended():
            break
        step = stride * gap / length
        prices = [
            max(0.0, price + step * over / max(1, limit))
            for price, over, limit in zip(prices, lacking, purses.limits, strict=True)
        ]
    return _proven(core, purses, best_prices)


def _proven(core: Core, purses: Purses, prices: Sequence[float]) -> Relaxed:
    exact = tuple(round(price * SCALE) for price in prices)
    floats, _ = sweep(core, exact, SCALE)
    most = [int(value) for value in floats]  # they are integers already, since the prices are
    held = sum(price * limit for price, limit in zip(exact, purses.limits, strict=True))
    outside = [0] * len(core)
    for part in range(len(core) - 1, -1, -1):
        pair = core.pair[part]
        if pair is not None:
            outside[pair[0]] = outside[part] + most[pair[1]]
            outside[pair[1]] = outside[part] + most[pair[0]]
        for option in core.options[part]:
            outside[option.part] = outside[part]
    return Relaxed((most[-1] + held) // SCALE, exact, held, tuple(outside))
