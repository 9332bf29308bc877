"""
The highest alpha * q - beta * d - gamma * c, d being the time of a schedule.

Alternatives come in the order of what each could come to at best, so that the search is over once the next could not beat the best found.
With team time that order is alpha * q - gamma * c, from which beta times the makespan is taken; who ends later than the best worth allows
is not even drawn. With robot time each action takes beta times its least time from its own worth.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from missiontree.choosing.drawing import Draws
from missiontree.choosing.fronts import option_of, order
from missiontree.choosing.trying import NEVER, Trials, Tried
from missiontree.mission.alternative import Alternative, selected_leaves
from missiontree.mission.brief import MissionBrief
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control
from missiontree.mission.estimate import MICRO, Weights
from missiontree.mission.front import Chosen
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.schedule import Schedule
from missiontree.mission.search_limit import SearchLimit
from missiontree.mission.ticks import TICKS_PER_S, ticks

METHOD = "best_first"


@dataclass(frozen=True)
class Scale:
    """
    What alternatives and schedules come to, in millionths.

    Parameters
    ----------
    tree, brief
        The mission.
    by_robot
        Whether the time of all robots counts, instead of the team's.
    """

    tree: GroundedTree
    brief: MissionBrief
    by_robot: bool

    @cached_property
    def of_a_tick(self) -> Fraction:
        """What a tick of time takes away."""
        return Fraction(self.brief.weights.beta) * MICRO / TICKS_PER_S

    @cached_property
    def timeless(self) -> dict[int, int]:
        """What quality and cost of each leaf come to."""
        weights = Weights(self.brief.weights.alpha, 0.0, self.brief.weights.gamma)
        actions = ((leaf, node.action) for leaf, node in enumerate(self.tree.nodes))
        return {leaf: weights.utility_micro(action.estimate) for leaf, action in actions if action is not None}

    @cached_property
    def at_best(self) -> dict[int, int]:
        """What each leaf comes to at best: rounded up, so that no sum of them is too low."""
        return {leaf: worth - int(self.of_a_tick * self._least[leaf]) for leaf, worth in self.timeless.items()}

    def order(self, alternative: Alternative) -> int:
        """By what alternatives are drawn: what they come to at best, before the makespan is taken off where that counts."""
        return sum(self.at_best[leaf] for leaf in selected_leaves(self.tree, alternative.choices))

    def bound(self, alternative: Alternative, least: int) -> Fraction:
        """What an alternative comes to at best, no schedule of it being shorter than so many ticks."""
        leaves = selected_leaves(self.tree, alternative.choices)
        timeless = sum(self.timeless[leaf] for leaf in leaves)
        return timeless - self.of_a_tick * (sum(self._least[leaf] for leaf in leaves) if self.by_robot else least)

    def worth(self, alternative: Alternative, schedule: Schedule) -> Fraction:
        """What an alternative comes to with a schedule."""
        timeless = sum(self.timeless[leaf] for leaf in selected_leaves(self.tree, alternative.choices))
        return timeless - self.of_a_tick * self._time(schedule)

    def _time(self, schedule: Schedule) -> int:
        if not self.by_robot:
            return round(schedule.makespan_s * TICKS_PER_S)
        moves = {done.leaf for done in schedule.actions if self.tree.action(done.leaf).moves}
        acting = [(done.start_s, done.end_s) for done in schedule.actions]
        own = {leg for leg in schedule.legs if leg.leaf in moves}  # the leg of a move is the move
        under_way = [(leg.start_s, leg.end_s) for leg in schedule.ways if leg not in own]
        spans = (*acting, *under_way)
        return sum(round(end * TICKS_PER_S) - round(start * TICKS_PER_S) for start, end in spans)

    @cached_property
    def _least(self) -> dict[int, int]:
        """Least time of a robot at each leaf, in ticks; 0 where the time of robots does not count."""
        ended = {link.first for link in self.tree.links if link.kind == "until"}
        return {leaf: self._least_time(leaf, ended) if self.by_robot else 0 for leaf in self.timeless}

    def _least_time(self, leaf: int, ended: set[int]) -> int:
        action = self.tree.action(leaf)
        if action.open_ended and self._below(leaf, ended):
            return 0  # it may end with another node, whenever that is
        return ticks(action.travel_at_least_s if action.moves else action.duration_s)

    def _below(self, node: int, tops: set[int]) -> bool:
        while node >= 0 and node not in tops:
            node = self.tree.nodes[node].parent
        return node >= 0


class _Weighing:
    """One search."""

    def __init__(self, scale: Scale, draws: Draws, trials: Trials) -> None:
        self._scale, self._draws, self._trials = scale, draws, trials
        self.best: Tried | None = None
        self.worth = Fraction(0)
        self.whole = False  # those not drawn come to no more than the best
        self.next: Fraction | None = None  # what those not drawn come to at best, once that is known
        self.limit: SearchLimit | None = None
        self._soonest = 0 if scale.by_robot else draws.soonest()

    def run(self) -> None:
        """Draw until nothing can beat the best, or a limit."""
        for tried in self._trials.found():
            self._take(tried)
        highest: int | None = None
        while True:
            line = self._draws.under(self._deadline(highest))
            in_order = True
            for alternative in line:
                in_order &= alternative.certificate.claim == "proven"
                if in_order:
                    height = self._scale.order(alternative)
                    highest = height if highest is None else highest
                    self.next = height - self._scale.of_a_tick * self._soonest
                    if self.best is not None and self.next <= self.worth:
                        self.whole = True
                        return
                if (limit := self._trials.limit()) is not None:
                    self.limit = limit
                    return
                if self._try(alternative) and self._deadline(highest) is not None:
                    break
            else:
                self.whole, self.limit = line.whole, line.limit
                return

    def _try(self, alternative: Alternative) -> bool:
        """Schedule an alternative unless it cannot be better; whether it is."""
        tried = self._trials.least(alternative)
        if tried.least == NEVER or (self.best is not None and self.at_best(tried) <= self.worth):
            return False
        return self._take(self._trials.scheduled(alternative))

    def at_best(self, tried: Tried) -> Fraction:
        """What an alternative that was tried comes to at best."""
        return self._scale.bound(tried.alternative, tried.least)

    def open(self, tried: Tried) -> bool:
        """Whether an alternative may come to more than what was found of it."""
        return tried.least != NEVER and (self._scale.by_robot or not tried.settled)

    def _take(self, tried: Tried) -> bool:
        if tried.makespan is None or tried.schedule is None:
            return False
        worth = self._scale.worth(tried.alternative, tried.schedule)
        if self.best is not None and (-worth, *order(tried)) >= (-self.worth, *order(self.best)):
            return False
        self.best, self.worth = tried, worth
        return True

    def _deadline(self, highest: int | None) -> int | None:
        """The last tick at which anybody can end who is better than the best."""
        if self.best is None or highest is None or self._scale.by_robot:
            return None
        return -int(-(highest - self.worth) // self._scale.of_a_tick) - 1


def weightiest(tree: GroundedTree, brief: MissionBrief, trials: Trials, control: Control) -> Chosen | None:
    """
    Seek the highest worth; None if nothing has a schedule.

    Parameters
    ----------
    tree, brief
        The mission; its objective is one of the weighted ones, and its beta above 0.
    trials
        Where alternatives are scheduled.
    control
        Limits of every single search.
    """
    scale = Scale(tree, brief, brief.objective == "weighted-sum")
    search = _Weighing(scale, Draws(tree, brief, control, scale.at_best), trials)
    search.run()
    best = search.best
    if best is None:
        return None
    certificate = _certificate(search, trials)
    worth = round(float(search.worth / MICRO), 6)
    assert best.schedule is not None
    return Chosen(option=option_of(best, 1, certificate), worth=worth)


def _certificate(search: _Weighing, trials: Trials) -> Certificate:
    if not search.whole and search.next is None:
        detail = "It was found; nothing is known of others."
        return Certificate(claim="unproven", method=METHOD, detail=detail, limit=search.limit)
    known = [search.at_best(one) for one in trials if search.open(one)]
    bound = max([search.worth, *known, *([] if search.whole or search.next is None else [search.next])])
    if bound == search.worth:
        detail = "No alternative comes to more with any schedule."
        return Certificate(claim="proven", method=METHOD, bound=round(float(bound / MICRO), 6), detail=detail)
    detail = "Something may come to more, but to no more than the bound."
    return Certificate(claim="bounded", method=METHOD, bound=_rounded_up(bound), detail=detail, limit=search.limit)


def _rounded_up(worth: Fraction) -> float:
    return -int(-worth // 1) / MICRO
