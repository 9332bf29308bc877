"""
The k best within the purses, by branch and bound in rounds that reach deeper and deeper below the bound.

A round looks for all ways with a wanted utility. Prices rule out every option through which no way reaches it, and what is left is
searched depth first, with prices of its own at every node. The nearer the wanted utility is to the bound, the fewer options are left,
so the first rounds cost next to nothing; the last one goes no deeper than the k-th best found. The bound is Lagrangian (Geoffrion,
"Lagrangean relaxation for integer programming", 1974), the narrowing that of reduced costs, the search Land and Doig's (1960).
Everything that decides is an integer, so a finished round is a proof.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from math import log
from typing import Literal

from missiontree.allocation.compiled import PLAIN, Engine, can_compile
from missiontree.allocation.core import Core, Way
from missiontree.allocation.crew import Crew
from missiontree.allocation.exchanges import repaired
from missiontree.allocation.kernel.columns import FINISHED, LAST, PAUSED
from missiontree.allocation.pool import Pool, look_around, start
from missiontree.allocation.purses import Purses
from missiontree.allocation.searched import Scale, Searched, scale_of
from missiontree.allocation.warming import engine_unless, is_warm
from missiontree.mission.control import Control

STEPS = 20
LARGE = 5_000  # parts from which compiling pays from the start
EARLY = 1_200  # parts from which ways are sought before anything is searched
TRIED_PLAIN = 150  # nodes at the slow speed before the fast one is taken
SLICES = {True: 2_000, False: 10}  # nodes between two looks at the clock
MENDED_IN_ONE_GO = {True: 200_000, False: 2_000}  # parts looked at by exchanges before the next look at the clock
MENDING = {True: 50_000_000, False: 50_000}  # parts looked at by exchanges
FEWEST_PASSES, PASSES_PER_PART, MOST_PASSES = 20, 10, 1_000
GIANT = 20_000  # parts of a core in which exchanges do more than searching
MENDING_ON = {True: 2_000_000_000, False: 10_000_000}  # parts looked at by exchanges in such cores
MENDED_AT_ONCE = 20  # passes between two looks at the clock
HURRIED = 20_000  # parts looked at by exchanges even when time is up, if nothing is found yet
UNAIDED = 300  # nodes without k ways found, after which cheap methods are to find some
RAISED = (102, 106, 115, 140)  # per cent of the best prices; the higher, the more careful the advice
GROWTH = 0.5  # of the depth of a round, while nothing is found
DENSITY = 50  # ways sought per way found, as it were; the more, the smaller the steps
TIES = 16  # ways beyond the k wanted, of the same utility as the last, before the order of choices is settled apart

Ended = Literal["finished", "stopped"]


def takes_long_to_begin(core: Core) -> bool:
    """Whether the compiled functions are waited for, in which time one way could be found without them."""
    return LARGE <= len(core) < GIANT and can_compile() and not is_warm()


def begun(core: Core, purses: Purses, pool: Pool, control: Control) -> int:
    """
    Put one way into the pool by plain means, even when time is up, and then wait for the compiled functions, until it is.

    Returns
    -------
    int
        Nothing has more utility (millionths): the best way, whatever it uses.
    """
    best, advised = core.best()
    way = repaired(core, purses, advised)
    if way is not None:
        pool.offer(core.taken(way))
    if not control.ended():
        engine_unless(control.ended)
    return best


class Rounds:
    """
    One search.

    Parameters
    ----------
    core, purses
        What there is to choose.
    rank
        Place of each node of the tree in preorder.
    pool
        Takes up what is found, and knows the k-th best.
    control
        Whether to stop.
    max_nodes
        Nodes looked at in all rounds, at the fast and at the slow speed.
    hands
        How many searchers may go on side by side at the fast speed. Default 1.

    Attributes
    ----------
    bound
        Nothing that is not in the pool has more utility (millionths); None if there is nothing else.
    prices
        The best prices of the whole.
    """

    def __init__(
        self,
        core: Core,
        purses: Purses,
        rank: Sequence[int],
        pool: Pool,
        control: Control,
        max_nodes: tuple[int, int],
        hands: int = 1,
    ) -> None:
        self.core, self.purses, self.rank, self.pool, self.control = core, purses, rank, pool, control
        self.scale: Scale = scale_of(core)
        self.base = self._searched(core, self._engine(len(core)), deep=False)
        self.bound: int | None = self.base.price(ended=control.ended)
        self.prices = self.base.prices
        self.nodes, self.max_nodes, self.hands = 0, max_nodes, hands
        self._started: list[Way] | None = None
        self._mended = False

    def run(self) -> bool:
        """Whether the pool holds the k best, or all there are, and their order is settled."""
        assert self.bound is not None
        top, bottom = self.bound, least_utility(self.core)
        depth = max(self.scale.unit, (top - bottom) >> 16)
        if len(self.core) >= EARLY:
            # It takes long there, and nobody knows when time will be up.
            look_around(self.pool, self.core, self.purses, self.start(), self.advised, self.control)
        while True:
            wanted = top - depth
            if self.pool.kth is not None:
                wanted = max(wanted, self.pool.kth)
            wanted = max(wanted, bottom)
            if self.control.ended() or self._round(wanted) == "stopped":
                return False
            if self.pool.kth is not None and self.pool.kth >= wanted:
                self.bound = self.pool.kth
                return not self._crowded() or self._settle_ties(self.pool.kth)
            if wanted == bottom:
                self.bound = None
                return True
            self.bound = min(top, wanted - 1)
            depth += max(self.scale.unit, int(depth * self._growth(wanted)))

    @cached_property
    def advised(self) -> list[int]:
        """By pick, the index of the option that the best prices advise."""
        return self.base.advised()

    def _growth(self, wanted: int) -> float:
        """How much deeper to go, as a share: the number of ways grows about exponentially with depth, so the more are there, the less."""
        found = min(self.pool.found(wanted), self.pool.k)
        if not found:
            return GROWTH
        return min(GROWTH, log(DENSITY * (self.pool.k + 2)) / log(DENSITY * found) - 1)

    def start(self) -> list[Way]:
        """Put first ways into the pool; once. Where time is up, exchanges alone are tried only if nothing else finds a way."""
        if self._started is None:
            hurried = self.control.ended()
            self._started = start(
                self.pool,
                self.core,
                self.purses,
                None if hurried else self._mended_at_first(),
                self.advised,
                (self.base.advised(raised) for raised in RAISED),
                self.base.true_prices(self.purses),
                self.control,
            )
            if hurried and not self._started:
                mended = self._mended_at_first()
                if mended is not None and self.pool.offer(self.core.taken(mended)) is not None:
                    self._started = [mended]
        return self._started

    def _mended_at_first(self) -> Way | None:
        """A way found by exchanges alone; once there is one, it is bettered only while there is time."""
        parts, fast = len(self.core), self.base.engine.fast
        passes = max(FEWEST_PASSES, min(MOST_PASSES, PASSES_PER_PART * parts, MENDING[fast] // parts))
        at_once = max(1, MENDED_IN_ONE_GO[fast] // parts)
        best: Way | None = None
        for done in range(0, passes, at_once):
            best = self.base.mended(min(at_once, passes - done), fresh=not done) or best
            if self.control.ended() and (best is not None or done * parts >= HURRIED):
                break
        return best

    def _mend_on(self) -> None:
        """Go on with exchanges, once: so many choices are not searched to the end, but ways get better for a long time."""
        if self._mended:
            return
        self._mended, best = True, None
        for _ in range(MENDING_ON[self.base.engine.fast] // (MENDED_AT_ONCE * len(self.core))):
            if self.control.ended():
                break
            best = self.base.mended(MENDED_AT_ONCE, fresh=False) or best
        if best is not None:
            self.pool.offer(self.core.taken(best))

    def _round(self, wanted: int) -> Ended:
        """Find all ways with that utility, or with that of the k-th best if it is more."""
        core = self.base.narrowed(wanted)
        if core is None:
            return "finished"
        quickly = self._engine(len(core))
        ended = self._search(core, quickly, wanted, quickly.fast or not can_compile())
        if ended is None:
            fast = engine_unless(self.control.ended)
            ended = "stopped" if fast is None else self._search(core, fast, wanted, True)
        assert ended is not None
        return ended

    def _search(self, core: Core, engine: Engine, wanted: int, to_the_end: bool) -> Ended | None:
        """None if the search was given up because it can be done faster."""
        search = self._searched(core, engine, self.prices)
        search.price(ended=self.control.ended)
        above = self.bound
        assert above is not None
        with Crew(search, self.hands if engine.fast else 1) as crew:
            while True:
                before = crew.nodes
                ways = crew.step(self._target(wanted), STEPS, self._slice(engine))
                self.nodes += crew.nodes - before
                for way in ways:
                    self.pool.offer(core.taken(way))
                if crew.finished:
                    return "finished"
                if ways:
                    continue
                if self.nodes >= UNAIDED and self.pool.kth is None:
                    self.start()
                if self.nodes >= UNAIDED and len(self.core) >= GIANT:
                    self._mend_on()
                if self._given_up(engine):
                    self.bound = max(wanted - 1, self.pool.kth or wanted - 1, crew.bound(above))
                    return "stopped"
                if not to_the_end and crew.nodes >= TRIED_PLAIN:
                    return None

    def _target(self, wanted: int) -> int:
        """Scaled utility that is of interest: the k-th best's, and beyond a number of equal ones only better ones."""
        kth = self.pool.kth
        if kth is None or kth < wanted:
            return self.scale.up(wanted)
        return self.scale.up(kth + 1 if self._crowded() else kth)

    def _crowded(self) -> bool:
        return self.pool.tied > self.pool.k + TIES

    def _settle_ties(self, utility: int) -> bool:
        """Find the ways of the k-th best's utility that come first in the order of choices; whether that succeeded."""
        core = self.base.narrowed(utility)
        assert core is not None
        fast = engine_unless(self.control.ended) if can_compile() and self.nodes > TRIED_PLAIN else None
        engine = fast or self._engine(len(core))
        search = self._searched(core, engine, self.prices)
        search.price(ended=self.control.ended)
        missing, target, done = self.pool.k - self.pool.better_than(utility), self.scale.up(utility), 0
        while missing > 0:
            status = search.branch(target, STEPS, True, self._slice(engine))
            self.nodes, done = self.nodes + search.nodes - done, search.nodes
            if status == LAST:
                found = self.pool.offer(core.taken(search.candidate()))
                missing -= found is not None and found.utility == utility
            if status == FINISHED:
                break
            if status == PAUSED and self._given_up(engine):
                return False
        return True

    def _slice(self, engine: Engine) -> int:
        """Nodes until the next look at the clock."""
        return max(0, min(SLICES[engine.fast], self.max_nodes[0 if engine.fast else 1] - self.nodes))

    def _given_up(self, engine: Engine) -> bool:
        return self.control.ended() or self.nodes >= self.max_nodes[0 if engine.fast else 1]

    def _searched(self, core: Core, engine: Engine, prices: Sequence[int] = (), deep: bool = True) -> Searched:
        return Searched(core, self.purses, self.rank, engine, self.scale, prices, deep)

    def _engine(self, parts: int) -> Engine:
        wanted = can_compile() and (is_warm() or parts >= LARGE)
        return (engine_unless(self.control.ended) if wanted else None) or PLAIN


def least_utility(core: Core) -> int:
    """No way has less utility than this."""
    least: list[int] = []
    for part, options in enumerate(core.options):
        if options:
            least.append(min(least[option.part] for option in options))
        else:
            least.append(core.utility[part] + sum(least[below] for below in core.parts[part]))
    return least[-1]
