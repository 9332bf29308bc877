"""
What times allow and no order of events does, because something takes no time; schedules are made from orders.

The giver of a hand-over ends when the taker starts, and both are one moment: an activity without length could stand there, after the
one for some reason and before the other for another. What lasts until something ends is over then, so that its robot could go on to
just that, if it takes no time. And of two things that a robot does at one moment, one could be first for the robot and the other for
what they move. Rules of schedules speak of times, and do not forbid it. So nothing but answers may be taken from a model that does.
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
    """Keep activities without length out of hand-overs, robots from waiting for themselves, and one order of what a robot does."""
    for pair in sorted(ordering.literals):
        for first, second in (pair, pair[::-1]):
            for arc in _arcs(problem, tours, first, second):
                model.implies((arc,), ordering.before(first, second))
    for open_ended, ends in sorted(problem.graph.until.items()):
        for one in sorted(ends):
            for arc in _arcs(problem, tours, open_ended, one):
                model.clause(negated(arc))
            for both in _by_one(problem, heads, open_ended, one):
                model.at_least(times.start[open_ended], times.end[one], when=both)
    _keep_hand_overs_whole(model, problem, times, ordering, tours, heads)


def _keep_hand_overs_whole(
    model: Model, problem: Problem, times: Times, ordering: Ordering, tours: Sequence[Tours], heads: Sequence[Staff]
) -> None:
    """
    Keep activities without length out of hand-overs.

    Reasons to come after a giver or before a taker are a resource without room for both, one robot for both, an order that is certain, or
    that a robot does the one role right after the other. Longer chains of activities without length are left out.
    """
    rivals = {frozenset(pair) for name in problem.sharing.capacity for pair in problem.sharing.rivals(name)}
    instants = [one for one in range(len(times.start)) if not problem.bounds.duration[one]]
    for giver, taker in sorted(problem.hand_overs.taker.items()):
        for one in instants:
            if one in (giver, taker):
                continue
            after_giver, before_taker = (
                [()]
                if frozenset((one, side)) in rivals or _one_robot(problem, one, side)
                else list(_by_one(problem, heads, one, side))
                for side in (giver, taker)
            )
            for both in product(after_giver, before_taker):
                when, first = (*both[0], *both[1]), model.boolean()
                model.at_least(times.start[giver], times.end[one], when=(first, *when))
                model.at_least(times.start[one], times.end[taker], when=(negated(first), *when))
            for when in () if () in before_taker else after_giver:
                for literal in _reasons(model, problem, ordering, tours, one, taker):
                    model.at_least(times.start[giver], times.end[one], when=(literal, *when))
            for when in () if () in after_giver else before_taker:
                for literal in _reasons(model, problem, ordering, tours, giver, one):
                    model.at_least(times.start[one], times.end[taker], when=(literal, *when))


def _one_robot(problem: Problem, one: int, other: int) -> bool:
    """Whether one robot does both, whoever it is."""
    group_of = problem.staffing.group_of
    mine, its = ({group_of[role] for role in _roles(problem, activity)} for activity in (one, other))
    return bool(mine & its)


def _roles(problem: Problem, activity: int) -> set[int]:
    return {problem.graph.tree.action(leaf).role for leaf in problem.graph.activities[activity]}


def _reasons(
    model: Model, problem: Problem, ordering: Ordering, tours: Sequence[Tours], first: int, second: int
) -> Iterator[int]:
    """Literals that each make one activity come before another."""
    if ordering.certain(first, second):
        yield model.true
    yield from _arcs(problem, tours, first, second)


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
