"""
What times allow and no order of events does, because something takes no time; schedules are made from orders.

The giver of a hand-over ends when the taker starts, and both are one moment: an activity without length could stand there, after the
one for some reason and before the other for another. What lasts until something ends is over then, so that its robot could go on to
just that, if it takes no time, or what it holds could be passed on to what comes before that. And of two things that a robot does at
one moment, one could be first for the robot and the other for what they move. Rules of schedules speak of times, and do not forbid it.
So nothing but answers may be taken from a model that does.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product

from missiontree.scheduling.cpsat.model import Model, negated
from missiontree.scheduling.cpsat.ordering import Ordering
from missiontree.scheduling.cpsat.staff import Staff
from missiontree.scheduling.cpsat.times import Times
from missiontree.scheduling.cpsat.tours import Tours
from missiontree.scheduling.problem import Problem

MOST_MEMBERS = 8
"""Of a crew that need not travel: in a larger one, somebody else is seldom far, and there would be much to say."""


def keep_to_orders(
    model: Model, problem: Problem, times: Times, ordering: Ordering, tours: Sequence[Tours], heads: Sequence[Staff]
) -> None:
    """Keep what has no length out of hand-overs and untils, robots from waiting for themselves, and one order of what a robot does."""
    for pair in sorted(ordering.literals):
        for first, second in (pair, pair[::-1]):
            for arc in _arcs(problem, tours, first, second):
                model.implies((arc,), ordering.before(first, second))
    between = _Between(model, problem, times, ordering, tours, heads)
    for open_ended, ends in sorted(problem.graph.until.items()):
        for one in sorted(ends):
            for arc in _arcs(problem, tours, open_ended, one):
                model.clause(negated(arc))
            for both in _by_one(problem, heads, open_ended, one):
                model.at_least(times.start[open_ended], times.end[one], when=both)
            between.what_lasts(open_ended, one)
    for giver, taker in sorted(problem.hand_overs.taker.items()):
        between.hand_over(giver, taker)


class _Between:
    """
    Keeps activities without length from coming after what they must come before, all at one moment.

    Reasons to come before or after something are a resource without room for both, one robot for both, an order that is certain, or that
    a robot does the one role right after the other. Longer chains of activities without length are left out.
    """

    def __init__(
        self,
        model: Model,
        problem: Problem,
        times: Times,
        ordering: Ordering,
        tours: Sequence[Tours],
        heads: Sequence[Staff],
    ) -> None:
        self._model, self._problem, self._times = model, problem, times
        self._ordering, self._tours, self._heads = ordering, tours, heads
        self._rivals = {frozenset(pair) for name in problem.sharing.capacity for pair in problem.sharing.rivals(name)}
        self._instants = [one for one in range(len(times.start)) if not problem.bounds.duration[one]]

    def what_lasts(self, open_ended: int, end: int) -> None:
        """What cannot be done while something lasts, and comes before what that lasts until, is over when it begins."""
        for one in self._others(open_ended, end):
            for when in self._not_both(one, open_ended):
                for literal in self._reasons(one, end):
                    self._after(open_ended, one, (literal, *when))

    def hand_over(self, giver: int, taker: int) -> None:
        """Nothing is done between giving and taking."""
        for one in self._others(giver, taker):
            not_giving, not_taking = self._not_both(one, giver), self._not_both(one, taker)
            for both in product(not_giving, not_taking):
                when, first = (*both[0], *both[1]), self._model.boolean()
                self._after(giver, one, (first, *when))
                self._after(one, taker, (negated(first), *when))
            for when in () if () in not_taking else not_giving:
                for literal in self._reasons(one, taker):
                    self._after(giver, one, (literal, *when))
            for when in () if () in not_giving else not_taking:
                for literal in self._reasons(giver, one):
                    self._after(one, taker, (literal, *when))

    def _others(self, *sides: int) -> list[int]:
        return [one for one in self._instants if one not in sides]

    def _after(self, later: int, earlier: int, when: Sequence[int]) -> None:
        """One activity starts when another is over, where all these literals hold."""
        self._model.at_least(self._times.start[later], self._times.end[earlier], when=when)

    def _not_both(self, one: int, other: int) -> list[tuple[int, ...]]:
        """Literals that together let two activities not be done at once; none for two that never are."""
        if frozenset((one, other)) in self._rivals or _one_robot(self._problem, one, other):
            return [()]
        return [*_by_one(self._problem, self._heads, one, other)]

    def _reasons(self, first: int, second: int) -> Iterator[int]:
        """Literals that each make one activity come before another."""
        if self._ordering.certain(first, second):
            yield self._model.true
        yield from _arcs(self._problem, self._tours, first, second)


def _one_robot(problem: Problem, one: int, other: int) -> bool:
    """Whether one robot does both, whoever it is."""
    group_of = problem.staffing.group_of
    mine, its = ({group_of[role] for role in _roles(problem, activity)} for activity in (one, other))
    return bool(mine & its)


def _roles(problem: Problem, activity: int) -> set[int]:
    return {problem.graph.tree.action(leaf).role for leaf in problem.graph.activities[activity]}


def _arcs(problem: Problem, tours: Sequence[Tours], first: int, second: int) -> Iterator[int]:
    """Literals that each make one robot do a role of an activity, and right after it one of another."""
    mine, its = _roles(problem, first), _roles(problem, second)
    for one in tours:
        nodes = [{one.node(role) for role in one.crew.roles if role in side} for side in (mine, its)]
        yield from (literal for (tail, head), literal in one.arcs.items() if tail in nodes[0] and head in nodes[1])


def _by_one(problem: Problem, heads: Sequence[Staff], one: int, other: int) -> Iterator[tuple[int, ...]]:
    """Literals that together make one robot of those that need not travel do a role of each, one after the other."""
    group_of = problem.staffing.group_of
    mine, its = ({group_of[role] for role in _roles(problem, activity)} for activity in (one, other))
    for staff in heads:
        members = range(len(staff.crew.members))
        if len(members) <= MOST_MEMBERS:
            groups = staff.crew.groups
            pairs = product((group for group in groups if group in mine), (group for group in groups if group in its))
            for first, second in pairs:
                yield from ((staff.fills[first, number], staff.fills[second, number]) for number in members)
