"""
The k best alternatives, exactly: candidates in order, best first, and a referee who sees them in order.

The first k candidates that keep all rules are the k best, and that is their proof. Candidates come from a lazy stream that knows
nothing of budgets; where it has to be refused too often, they come from the states of use, which keep pooled budgets by
themselves (:mod:`deepening`). Whatever stops the search earlier, the next candidate's utility and the prices of the budgets
bound everything not listed, and a pool of feasible alternatives (:mod:`pool`) stands in for what was not proven.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from missiontree.allocation.core import Core, core_of
from missiontree.allocation.coupling import couples
from missiontree.allocation.deepening import Deepening
from missiontree.allocation.feasibility import DEFAULT_STEPS, Feasibility
from missiontree.allocation.flat import flatten
from missiontree.allocation.item import Item, choices_of
from missiontree.allocation.multipliers import SCALE, Relaxed
from missiontree.allocation.order import Order, order_of
from missiontree.allocation.pool import fill
from missiontree.allocation.possible import possible_nodes, reasons_of
from missiontree.allocation.purses import Purses, purses_of
from missiontree.allocation.search import BY_STATE, METHOD, Search
from missiontree.allocation.selection import Selection, select
from missiontree.allocation.states import Problem
from missiontree.allocation.streams import Stream, best_first, stream_of
from missiontree.allocation.writing import impossible, no_robot_able, require_count
from missiontree.mission.alternative import Ranking
from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree

PATIENCE_NODES = 1_000_000


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
        Candidates of the plain stream looked at before states of use are counted; fewer in large trees. Default 256.
    max_states
        States of use kept at once; 0 does without them. Default 200,000.
    """

    max_examined: int = 200_000
    packing_steps: int = DEFAULT_STEPS
    patience: int = 256
    max_states: int = 200_000

    def __call__(self, tree: GroundedTree, fleet: Fleet, weights: Weights, k: int, control: Control) -> Ranking:
        """See :class:`missiontree.allocation.allocator.Allocator`."""
        require_count(k)
        flat = flatten(tree, fleet, weights)
        possibility = possible_nodes(flat)
        stream = stream_of(flat, possibility.possible)
        if stream is None:
            reasons = reasons_of(flat, possibility, "error") or no_robot_able(flat)
            return impossible("least_use", "No selection stays within what there is.", reasons)
        referee = Feasibility(flat, self.packing_steps) if couples(flat) else None
        search = Search(flat, possibility, referee, k, control)
        return _Road(search, stream, possibility.possible, self).walk()


class _Road:
    """The stages of one search, each of which may finish it."""

    def __init__(self, search: Search, stream: Stream, possible: Sequence[bool], settings: ExactKBest) -> None:
        self.search, self.possible, self.settings = search, possible, settings
        self.flat, self.control = search.flat, search.control
        self.items = best_first(stream)
        self.waiting: Item | None = None  # drawn from the plain stream and not looked at yet
        self.order: Order | None = None
        self.last: tuple[int, Selection] | None = None  # the plain stream's last candidate that was looked at
        self.passed: int | None = None  # score of the last candidate that was looked at among the states

    def walk(self) -> Ranking:
        """All stages."""
        search, settings = self.search, self.settings
        if self._plainly(self._patience()):
            return search.finished()
        purses = purses_of(self.flat, self.possible)
        core = core_of(self.flat, self.possible, purses)
        relaxed: Relaxed | None = None
        if purses.names and not self._given_up(settings.max_examined):
            relaxed = fill(search.pool, core, purses, self.control)
            if self._by_state(core, purses, relaxed):
                return search.finished()
        if self._plainly(settings.max_examined):
            return search.finished()
        search.bound_by((relaxed or fill(search.pool, core, purses, self.control)).bound)
        return search.stopped()

    def _patience(self) -> int:
        """The larger the tree, the longer a candidate takes, and the less likely it is that one near the best is allowed."""
        settings = self.settings
        if self.search.referee is None:
            return settings.max_examined
        return min(settings.patience, settings.max_examined, max(4, PATIENCE_NODES // len(self.flat.kind)))

    def _given_up(self, most: int) -> bool:
        return self.search.examined >= most or self.control.ended()

    def _plainly(self, most: int) -> bool:
        """Look at candidates of the plain stream, up to so many in all; whether that finished the search."""
        while not self.search.full:
            item = self.waiting or next(self.items, None)
            if item is None:
                return True
            self.waiting = item
            self.search.bound_by(item.utility)
            if self._given_up(most):
                return False
            selection = select(self.flat, choices_of(item), self.possible)
            if self.passed is None or self._score(item.utility, selection) < self.passed:
                self.search.look_at(item.utility, selection)
            self.waiting = None
            self.last = (item.utility, selection)
        return True

    def _score(self, utility: int, selection: Selection) -> int:
        assert self.order is not None
        return self.order.score(utility * SCALE, selection.choices)

    def _by_state(self, core: Core, purses: Purses, relaxed: Relaxed) -> bool:
        """Look at the candidates that keep all pooled budgets; whether that finished the search."""
        search, settings = self.search, self.settings
        search.bound_by(relaxed.bound)
        self.order = order_of(self.flat, self.possible) if settings.max_states else None
        if self.order is None:
            return False
        last = self._score(*self.last) if self.last is not None else None
        rounds = Deepening(
            Problem(core, purses, self.order, relaxed), search.pool, settings.max_states, self.control.ended, last
        )
        search.method = BY_STATE
        for utility, way in rounds.candidates():
            search.bound_by(utility)
            if self._given_up(settings.max_examined):
                break
            search.look_at(utility, select(self.flat, core.taken(way), self.possible))
            self.passed = rounds.last
            if search.full:
                return True
        else:
            search.bound_by(rounds.bound)
            if rounds.bound is None:
                return True
        search.method = METHOD
        return False
