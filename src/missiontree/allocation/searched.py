"""
A core and its purses as the columns that the inner loops search, and what comes back from there.

Utilities are counted in the greatest unit that divides all of them, amounts in units that leave some twenty bits to each limit:
what a part uses is rounded down then, and so is the limit, which lets more ways pass than there are and none fewer. Bounds hold, and
the referee decides of each way with the true amounts.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import copy
from dataclasses import dataclass
from math import gcd
from random import Random
from typing import Any

from missiontree.allocation.compiled import Engine
from missiontree.allocation.core import Core, Way, narrowed
from missiontree.allocation.kernel.columns import (
    CHAIN,
    DEPTH,
    DESCENTS,
    FEW,
    FEW_PURSES,
    MARGIN,
    NEG,
    NODES,
    NUMBERS,
    PICK,
    SETTLED,
    SUM,
    TRAIL,
    Room,
    Tree,
)
from missiontree.allocation.purses import Purses
from missiontree.mission.control import never

SHIFT = 20  # bits behind the point of a scaled utility
WHOLE_BITS = 59  # of all that is added up
LIMIT_BITS = 20
REMEMBERED = 4096
LEVELS = 64  # each holds three quarters of the one before at most
ROOT_STEPS = 60
PRICED_IN_ONE_GO = {True: 3_000_000, False: 15_000}  # parts looked at by prices before the next look at the clock
DESCENT = 4
QUICKLY_DESCENDED = 1_000  # parts
HURRIED_STEPS = 3  # where time is up before any price is known
AIMS = (0.02, 0.006, 0.002, 0.0006, 0.0002, 0.00006, 0.005, 0.001, 0.0002, 0.00004)


@dataclass(frozen=True, slots=True)
class Scale:
    """
    How utilities are scaled.

    Parameters
    ----------
    unit
        Millionths in a unit.
    factor
        Steps in a unit.
    """

    unit: int
    factor: int

    def up(self, utility: int) -> int:
        """The least scaled utility of ways with at least that utility, in millionths."""
        return -(-utility // self.unit) * self.factor

    def down(self, scaled: int) -> int:
        """The most utility, in millionths, that a bound leaves room for."""
        return scaled // self.factor * self.unit


def scale_of(core: Core) -> Scale:
    """The finest scale at which no sum leaves its bits; coarser than a millionth only for sums beyond 10^11."""
    unit = gcd(*core.utility) or 1
    span = sum(map(abs, core.utility)) // unit + len(core)
    bits = span.bit_length()
    if bits > WHOLE_BITS:
        unit <<= bits - WHOLE_BITS
        bits = WHOLE_BITS
    return Scale(unit, 1 << min(SHIFT, WHOLE_BITS - bits))


class Searched:
    """
    One core, ready to be searched at the speed of an engine.

    Parameters
    ----------
    core, purses
        The problem.
    rank
        Place of each node of the tree in preorder.
    engine
        The inner loops.
    scale
        Of utilities.
    prices
        To begin with, scaled. Default: none.
    deep
        Whether it will be searched, and not only priced.
    """

    def __init__(
        self,
        core: Core,
        purses: Purses,
        rank: Sequence[int],
        engine: Engine,
        scale: Scale,
        prices: Sequence[int] = (),
        deep: bool = True,
    ) -> None:
        self.core, self.engine, self.scale, self._purses = core, engine, scale, len(purses.limits)
        self.tree = _tree(core, purses, rank, engine, scale)
        self.room = _room(self.tree, engine, prices, deep)
        self.room.numbers[MARGIN] = scale.factor // 2
        quick = engine.fast or len(core) <= QUICKLY_DESCENDED
        self.room.numbers[DESCENTS] = DESCENT if quick else 0  # nothing can interrupt them
        self._whole = -NEG

    def price(self, steps: int = ROOT_STEPS, ended: Callable[[], bool] = never, aims: Sequence[float] = AIMS) -> int:
        """Look for good prices of the whole, until somebody says stop; the bound they prove, in millionths."""
        self.engine.reach(self.tree, self.room)
        bound = -NEG
        at_once = max(1, PRICED_IN_ONE_GO[self.engine.fast] // len(self.core))
        for aim in aims:
            done = 0
            while not done or (done < steps and not self.room.numbers[SETTLED] and not ended()):
                taken = min(at_once, steps - done, HURRIED_STEPS if ended() else steps)
                bound = min(bound, self.engine.lower(self.tree, self.room, taken, NEG, aim, done > 0)[0])
                done += taken
            if ended():
                break
        return self.scale.down(int(bound))

    @property
    def prices(self) -> list[int]:
        """By purse, scaled."""
        return [int(price) for price in self.room.prices][: self._purses]

    def true_prices(self, purses: Purses) -> list[float]:
        """By purse, in millionths for a unit of the purse."""
        return [
            price / (1 << coarsened(limit)) * self.scale.unit / self.scale.factor
            for price, limit in zip(self.prices, purses.limits, strict=True)
        ]

    @property
    def nodes(self) -> int:
        """Nodes looked at so far."""
        return int(self.room.numbers[NODES])

    def narrowed(self, utility: int) -> Core | None:
        """The core of all ways with at least that utility, as far as the prices tell; None if there is none."""
        self._take_back()
        target = self.scale.up(utility)
        self.engine.reach(self.tree, self.room)
        if self.engine.shrink(self.tree, self.room, target) < target:
            return None
        alive, first = self.room.alive, self.tree.first
        kept = [
            [index for index in range(len(options)) if alive[first[part] + index]]
            for part, options in enumerate(self.core.options)
        ]
        return narrowed(self.core, kept)

    def _take_back(self) -> None:
        """Make all options stand again."""
        for edge in range(len(self.room.alive)):
            self.room.alive[edge] = 1
        self.room.numbers[TRAIL] = 0

    def branch(self, target: int, steps: int, in_order: bool, nodes: int) -> int:
        """See :func:`missiontree.allocation.kernel.branching.branch`; the target is scaled."""
        return int(self.engine.branch(self.tree, self.room, target, steps, in_order, nodes))

    def parted(self, target: int) -> Searched | None:
        """
        Part with the uppermost corner that is still to be searched; None if there is none.

        Parameters
        ----------
        target
            Corners without a way of so much scaled utility are of no interest.
        """
        room = self.room
        for depth in range(int(room.numbers[DEPTH])):
            if room.frame_open[depth] and room.frame_bound[depth] >= target:
                break
        else:
            return None
        room.frame_open[depth] = 0
        prices = [int(price) for price in room.frame_prices[depth * self._purses : (depth + 1) * self._purses]]
        taker = copy(self)
        taker.room = _room(self.tree, self.engine, prices, deep=True)
        taker.room.numbers[MARGIN] = room.numbers[MARGIN]
        gone = [*room.trail[: room.frame_trail[depth]], room.frame_edge[depth]]
        for place, edge in enumerate(gone):
            taker.room.alive[edge] = 0
            taker.room.trail[place] = edge
        taker.room.numbers[TRAIL] = len(gone)
        taker._whole = int(room.frame_bound[depth])
        return taker

    def bound(self, above: int) -> int:
        """Nothing that was not searched yet has more utility, in millionths; after a pause. ``above``: the same before the search."""
        if not self.room.numbers[DEPTH]:
            return min(above, self.scale.down(self._whole))
        return min(above, self.scale.down(int(self.engine.open_bound(self.room))))

    def candidate(self) -> Way:
        """The way that was told last."""
        return self._way(self.room.candidate)

    def mended(self, passes: int, fresh: bool = True) -> Way | None:
        """
        A good way within the purses, near what the prices advise; None if none is met in so many passes.

        Parameters
        ----------
        passes
            Over all picks.
        fresh
            Whether to begin anew; else it goes on from the last call, and only what is better than the best so far is told.
        """
        self._take_back()
        if self.engine.mend(self.tree, self.room, passes, fresh) == NEG:
            return None
        return self.candidate()

    def advised(self, per_cent: int = 100) -> list[int]:
        """By pick, the index of the option that so many per cent of the prices advise; of picks that no way reaches, the first."""
        self._take_back()
        self.engine.reach(self.tree, self.room)
        prices = self.engine.column([int(price) * per_cent // 100 for price in self.room.prices])
        self.engine.sweep(self.tree, self.room, prices)
        taken, first = self.room.taken, self.tree.first
        places = (int(taken[part]) - int(first[part]) for part in range(len(self.core)))
        return [
            place if 0 <= place < len(options) else 0 for place, options in zip(places, self.core.options, strict=True)
        ]

    def _way(self, taken: Sequence[int]) -> Way:
        way, stack = Way(), [len(self.core) - 1]
        while stack:
            part = stack.pop()
            if self.core.options[part]:
                way[part] = int(taken[part]) - int(self.tree.first[part])
                stack.append(self.core.options[part][way[part]].part)
            else:
                stack += self.core.parts[part]
        return way


def coarsened(limit: int) -> int:
    """Bits by which amounts are shortened."""
    return max(0, limit.bit_length() - LIMIT_BITS)


def _tree(core: Core, purses: Purses, rank: Sequence[int], engine: Engine, scale: Scale) -> Tree:
    first, below, priority = [0], list[int](), [0] * len(core)
    use_first, use_purse, use_amount = [0], list[int](), list[int]()
    shifts = [coarsened(limit) for limit in purses.limits]
    limits = [limit >> shift for limit, shift in zip(purses.limits, shifts, strict=True)]
    most = list(limits)
    for part, options in enumerate(core.options):
        below += [option.part for option in options] if options else core.parts[part]
        first.append(len(below))
        if options:
            priority[part] = len(rank) - rank[options[0].xor]
        for purse, amount in core.uses[part]:
            used = min(amount >> shifts[purse], limits[purse] + 1)  # more than there is, is too much
            use_purse.append(purse)
            use_amount.append(used)
            most[purse] += used
        use_first.append(len(use_purse))
    budget = 1 << WHOLE_BITS
    caps = [budget // (max(1, len(limits)) * max(1, there)) for there in most]
    chance = Random(0)  # noqa: S311 - spreads fingerprints
    column = engine.column
    return Tree(
        kind=column([PICK if options else SUM for options in core.options]),
        value=column([-(-utility // scale.unit) * scale.factor for utility in core.utility]),
        first=column(first),
        below=column(below),
        use_first=column(use_first),
        use_purse=column(use_purse),
        use_amount=column(use_amount),
        limits=column(limits),
        caps=column(caps),
        priority=column(priority),
        marks=column([chance.getrandbits(60) for _ in below]),
    )


def _room(tree: Tree, engine: Engine, prices: Sequence[int], deep: bool) -> Room:
    parts, edges, purses = len(tree.kind), len(tree.below), len(tree.limits)
    depth = edges + 1 if deep else 0  # every frame takes an edge away
    levels = LEVELS if deep else 0

    def blank(length: int, value: int = 0) -> Any:
        return engine.column([value] * length)

    known = list(prices) or [0] * purses
    capped = [min(price, cap) for price, cap in zip(known, tree.caps, strict=False)]
    return Room(
        alive=blank(edges, 1),
        prices=engine.column([int(price) for price in capped]),
        trial=blank(purses),
        most=blank(parts),
        taken=blank(parts),
        candidate=blank(parts),
        outside=blank(parts),
        active=blank(parts),
        tops=blank(parts),
        base_used=blank(purses),
        level_first=engine.column([0] + [parts] * (levels + 1)),
        level_top=engine.column([0] + [1] * (levels + 1)),
        level_value=blank(levels + 1),
        level_used=blank((levels + 1) * max(1, purses)),
        kept=engine.column([*range(parts), *[0] * (3 * parts if deep else 0)]),
        kept_tops=engine.column([parts - 1, *[0] * (3 * parts if deep else 0)]),
        on_way=blank(0 if deep else parts),
        over=blank(0 if deep else parts),
        user_head=blank(0 if deep else purses),
        user_next=blank(0 if deep else len(tree.use_purse)),
        user_pick=blank(0 if deep else len(tree.use_purse)),
        seen=blank(parts),
        way=blank(parts),
        other_way=blank(parts),
        used=blank(purses),
        drift=blank(purses),
        touched=blank(purses),
        listed=blank(purses),
        frame_edge=blank(depth),
        frame_open=blank(depth),
        frame_trail=blank(depth),
        frame_bound=blank(depth),
        frame_level=blank(depth),
        frame_prices=blank(depth * max(1, purses)),
        chain_pick=blank(CHAIN),
        chain_was=blank(CHAIN),
        chain_entry=blank(CHAIN),
        chain_option=blank(CHAIN),
        chain_purse=blank(CHAIN),
        chain_gain=blank(CHAIN),
        end_edge=blank(FEW),
        end_slack=blank(FEW),
        end_used=blank((FEW + 1) * FEW_PURSES),
        end_least=blank((FEW + 1) * FEW_PURSES),
        end_most=blank((FEW + 1) * FEW_PURSES),
        trail=blank(edges + 1),
        remembered=blank(REMEMBERED, -1),
        numbers=blank(NUMBERS),
    )
