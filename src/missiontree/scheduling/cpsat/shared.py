"""Shared resources: the activities that hold one are intervals, of which no more robots are under way at once than it has room for."""

from __future__ import annotations

from missiontree.scheduling.cpsat.model import Affine, Cumulative, Interval, Linear, Model, NoOverlap, negated
from missiontree.scheduling.cpsat.times import Times
from missiontree.scheduling.problem import Problem

MOST_HOLDERS = 60
"""Of a resource with several places, beyond which what takes no time counts nothing: there are as many pairs as their square."""


def add_sharing(model: Model, problem: Problem, times: Times) -> None:
    """
    Room in every scarce resource.

    Intervals are not optional, so that sizes may vary (see :mod:`missiontree.scheduling.cpsat.heads`). What is held on ways is left out.
    """
    intervals: dict[int, int] = {}
    for activity in sorted(problem.sharing.demand):
        start, end = times.start[activity], times.end[activity]
        fixed = start.var == end.var
        size = Affine(None, end.offset - start.offset) if fixed else Affine(model.integer(0, times.horizon))
        intervals[activity] = model.add(Interval(start, size, end))
    for name, capacity in problem.sharing.capacity.items():
        holders = problem.sharing.holders(name)
        taken = tuple(intervals[activity] for activity in holders)
        if not taken:
            continue  # held on ways only, which the model leaves out
        if capacity == 1:
            model.add(NoOverlap(taken))
        else:
            model.add(Cumulative(taken, capacity, tuple(holders.values())))
            if len(holders) <= MOST_HOLDERS:
                _keep_instants_out(model, problem, times, name)


def _keep_instants_out(model: Model, problem: Problem, times: Times, name: str) -> None:
    """
    Keep what takes no time out of a resource that is full.

    An interval of no length is no load to the solver where several have room, so that it could pass a lift that others fill. Of every such
    holder, each other one starts at its moment or later, or has ended by it, or is inside around it; the places of those who are inside,
    and its own, are no more than there are.
    """
    holders, capacity = problem.sharing.holders(name), problem.sharing.capacity[name]
    for one, robots in holders.items():
        if problem.bounds.duration[one]:
            continue
        start, end, inside = times.start[one], times.end[one], list[tuple[int, int]]()
        when: tuple[int, ...] = ()
        if start.var != end.var:  # how long it takes is not known
            when = (model.boolean(),)
            model.at_least(end, start, 1, when=(negated(when[0]),))
        for other, taken in holders.items():
            if other != one:
                before, within = model.boolean(), model.boolean()
                model.at_least(times.start[other], start, when=(before, *when))
                model.at_least(start, times.end[other], when=(negated(before), negated(within), *when))
                inside.append((taken, within))
        model.add(Linear(tuple(inside), 0, capacity - robots, when))
