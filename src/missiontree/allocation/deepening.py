"""
All ways that reach a utility, for lower and lower utilities, until enough of them pass the referee.

The prices bound every way from above; the pool of feasible ways bounds the k-th best from below. The nearer a wanted utility
is to the upper bound, the fewer states can reach it, so the first rounds are cheap, and the last need not go below the pool.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from missiontree.allocation.core import Core, Way
from missiontree.allocation.pool import Pool
from missiontree.allocation.state_streams import best_first
from missiontree.allocation.states import Problem, TooMany, tables_of

FAILED_ROUNDS = 3


class Deepening:
    """
    The rounds of one search.

    Parameters
    ----------
    problem
        The mission.
    pool
        What is known to be feasible; it may grow meanwhile.
    cap
        States kept in one round.
    ended
        Asked now and then whether to stop.
    last
        Score of the last candidate that was looked at before; None if none was.

    Attributes
    ----------
    bound
        Nothing that was not drawn has more utility (millionths); None if there is nothing left at all.
    """

    def __init__(self, problem: Problem, pool: Pool, cap: int, ended: Callable[[], bool], last: int | None) -> None:
        self.problem, self.pool, self.cap, self.ended, self.last = problem, pool, cap, ended, last
        self.bound: int | None = problem.relaxed.bound
        self._top, self._bottom = problem.relaxed.bound, least_utility(problem.core)

    def candidates(self) -> Iterator[tuple[int, Way]]:
        """Utilities and ways within all purses, in the order of alternatives, without a gap; fewer than all if rounds fail."""
        depth, reached, failed = self._first_depth(), 0, 0
        while True:
            wanted = self._wanted(depth)
            try:
                tables = tables_of(self.problem, wanted, self.cap, self.ended)
            except TooMany:
                failed += 1
                depth = (depth + reached) // 2
                if self.ended() or failed == FAILED_ROUNDS or depth <= reached:
                    return
                continue
            for score, way in best_first(tables):
                utility = self.problem.utility(score)
                if wanted is not None and utility < wanted:
                    break
                if self.last is None or score < self.last:
                    self.last = score
                    self.bound = min(utility, self._top)
                    yield utility, way
            if wanted is None:
                self.bound = None
                return
            self.bound = min(wanted - 1, self._top)
            if failed or wanted == self.pool.kth:
                return
            reached, depth = depth, depth * 3

    def _first_depth(self) -> int:
        floor = self.pool.kth
        if floor is not None:
            return max(1, (self._top - floor) // 4)
        return max(1, (self._top - self._bottom) // 64)

    def _wanted(self, depth: int) -> int | None:
        wanted = self._top - depth
        if self.pool.kth is not None:
            wanted = max(wanted, self.pool.kth)
        return wanted if wanted > self._bottom else None


def least_utility(core: Core) -> int:
    """No way has less utility than this."""
    least: list[int] = []
    for part in range(len(core)):
        pair = core.pair[part]
        if pair is not None:
            least.append(least[pair[0]] + least[pair[1]])
        elif core.options[part]:
            least.append(min(least[option.part] for option in core.options[part]))
        else:
            least.append(core.utility[part])
    return least[-1]
