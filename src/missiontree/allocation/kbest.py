"""
The k best alternatives, exactly: candidates in order, best first, and a referee who sees them in order.

The first k candidates that keep all rules are the k best, and that is their proof. Candidates come from a lazy stream that knows
nothing of budgets; where it has to be refused too often, prices on the budgets take over, and branch and bound with them
(:mod:`rounds`). Whatever stops the search earlier, the next candidate's utility and the prices of the budgets bound everything not
listed, and a pool of feasible alternatives (:mod:`pool`) stands in for what was not proven.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

from missiontree.allocation.arrays.ways import Draft
from missiontree.allocation.clash_wording import with_clash
from missiontree.allocation.core import core_of
from missiontree.allocation.coupling import couples
from missiontree.allocation.feasibility import DEFAULT_STEPS, Feasibility
from missiontree.allocation.first_ways import ways_in_order
from missiontree.allocation.flat import Flat, flatten
from missiontree.allocation.pool import fill
from missiontree.allocation.possible import Possibility, possible_nodes, reasons_of
from missiontree.allocation.preorder import preorder
from missiontree.allocation.purses import purses_of
from missiontree.allocation.rounds import Rounds, begun, takes_long_to_begin
from missiontree.allocation.search import BY_BOUNDS, Search
from missiontree.allocation.uncoupled import Uncoupled, Written
from missiontree.allocation.writing import impossible, no_robot_able, require_count
from missiontree.mission.alternative import Ranking
from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.search_limit import SearchLimit

PATIENCE_NODES = 1_000_000
LARGE = 100_000  # nodes
HURRIED = 10  # candidates of a large tree without coupling that are looked at even when time is up


@dataclass(frozen=True, slots=True)
class ExactKBest:
    """
    The default allocator.

    Parameters
    ----------
    max_examined
        Candidates looked at before the search is given up. Default 200,000.
    packing_steps
        Steps of packing per candidate and robot type before a candidate is kept as undecided. Default 20,000.
    patience
        Candidates of the plain stream refused before prices are used; fewer in large trees. Default 8.
    max_nodes
        Nodes of branch and bound looked at before it is given up: compiled, and in plain Python. Default 50,000,000 and 50,000.
    hands
        Threads that search side by side where the search is compiled and long. Default 2; what is found does not depend on it.
    explain
        Whether the limits that clash are sought where there is no alternative. Default true.
    """

    max_examined: int = 200_000
    packing_steps: int = DEFAULT_STEPS
    patience: int = 8
    max_nodes: tuple[int, int] = (50_000_000, 50_000)
    hands: int = 2
    explain: bool = True

    def __call__(self, tree: GroundedTree | Flat, fleet: Fleet, weights: Weights, k: int, control: Control) -> Ranking:
        """See :class:`missiontree.allocation.allocator.Allocator`."""
        require_count(k)
        flat = flatten(tree, fleet, weights)
        ranking = self._ranked(flat, k, control)
        return with_clash(ranking, flat, control) if self.explain else ranking

    def _ranked(self, flat: Flat, k: int, control: Control) -> Ranking:
        if not couples(flat):
            return self._uncoupled(flat, k, control)
        possibility = possible_nodes(flat)
        if not possibility.possible[0]:
            return _none(flat, possibility)
        search = Search(flat, possibility, Feasibility(flat, self.packing_steps), k, control)
        return _Road(search, _drawn(search, k + self.patience_with(flat)), self).walk()

    def patience_with(self, flat: Flat) -> int:
        """The larger the tree, the longer a candidate takes, and the less likely it is that one near the best is allowed."""
        return min(self.patience, max(2, PATIENCE_NODES // len(flat.kind)))

    def _uncoupled(self, flat: Flat, k: int, control: Control) -> Ranking:
        problem = Uncoupled(flat)
        possibility = Possibility(problem.possible)
        best = problem.best(k)
        if best is None:
            return _none(flat, possibility)
        search = Search(flat, possibility, None, k, control)
        return _Road(search, _written(search, best), self).walk()


class Candidate(NamedTuple):
    """
    The next in the order of alternatives.

    Parameters
    ----------
    utility
        In millionths.
    look
        Shows it to the search.
    """

    utility: int
    look: Callable[[], None]


def _none(flat: Flat, possibility: Possibility) -> Ranking:
    reasons = reasons_of(flat, possibility, "error") or no_robot_able(flat)
    detail = "No selection stays within what there is" + (" and meets its deadlines." if possibility.late else ".")
    return impossible("least_use", detail, reasons)


def _drawn(search: Search, first: int) -> Iterator[Candidate]:
    """All ways through the tree, for the referee to decide; how many of them are likely to be looked at."""
    for utility, selection in ways_in_order(search.flat, search.possibility.possible, first):
        yield Candidate(utility, partial(search.look_at, utility, selection))


def _written(search: Search, best: Written) -> Iterator[Candidate]:
    """The k best ways, which nobody has to decide."""
    for draft in best:
        yield Candidate(draft.utility, partial(_list, search, best, draft))


def _list(search: Search, best: Written, draft: Draft) -> None:
    search.list_next(draft.utility, best.parts(draft))


class _Road:
    """The stages of one search, each of which may finish it."""

    def __init__(self, search: Search, candidates: Iterator[Candidate], settings: ExactKBest) -> None:
        self.search, self.candidates, self.settings = search, candidates, settings
        self.flat, self.possible, self.control = search.flat, search.possibility.possible, search.control
        self.waiting: Candidate | None = None  # drawn and not looked at yet

    def walk(self) -> Ranking:
        """All stages."""
        search, settings = self.search, self.settings
        patience = settings.max_examined if search.referee is None else settings.patience_with(self.flat)
        if not self.control.ended() and self._plainly(settings.max_examined, patience):
            return search.finished()
        if search.referee is None and len(self.flat.kind) >= LARGE:
            return search.finished() if self._hurriedly() else search.stopped(self._limit(0))
        purses = purses_of(self.flat, self.possible)
        core = core_of(self.flat, self.possible, purses)
        if purses.names and takes_long_to_begin(core):
            search.bound_by(begun(core, purses, search.pool, self.control))
            if self.control.ended() and search.pool.highest is not None:
                return search.stopped(self._limit(0))
        rounds = Rounds(
            core, purses, preorder(self.flat), search.pool, self.control, settings.max_nodes, settings.hands
        )
        if purses.names and not self._given_up(settings.max_examined):
            search.bound_by(rounds.bound)
            if rounds.run():
                search.method = BY_BOUNDS
                search.look_at_all(search.pool.listed())
                return search.finished()
        elif self._plainly(settings.max_examined, settings.max_examined):
            return search.finished()
        limit = self._limit(rounds.nodes)
        fill(search.pool, core, purses, rounds.start(), rounds.advised, self.control)
        undecided = search.pool.undecided
        search.bound_by(rounds.bound if undecided is None or rounds.bound is None else max(rounds.bound, undecided))
        return search.stopped(limit)

    def _limit(self, nodes: int) -> SearchLimit:
        """What has just ended the search, after so many nodes of branch and bound."""
        ended = self.control.ended_by()
        if ended is not None:
            return ended
        settings = self.settings
        if self.search.examined >= settings.max_examined:
            return SearchLimit("candidates", settings.max_examined)
        fast, plain = settings.max_nodes
        return SearchLimit("nodes", fast if nodes >= fast else plain)

    def _given_up(self, most: int) -> bool:
        return self.search.examined >= most or self.control.ended()

    def _plainly(self, most: int, patience: int) -> bool:
        """Look at candidates of the plain stream, up to so many in all or refused; whether that finished the search."""
        while not self.search.full:
            candidate = self.waiting or next(self.candidates, None)
            if candidate is None:
                return True
            self.waiting = candidate
            self.search.bound_by(candidate.utility)
            if self._given_up(most) or self.search.refused >= patience:
                return False
            candidate.look()
            self.waiting = None
        return True

    def _hurriedly(self) -> bool:
        """Time is up, but in a large tree that nothing couples the next few candidates take less than any other way to fill the list."""
        for _ in range(HURRIED):
            candidate = self.waiting or next(self.candidates, None)
            self.waiting = None
            if candidate is None or self.search.full:
                return True
            self.search.bound_by(candidate.utility)
            candidate.look()
        return self.search.full
