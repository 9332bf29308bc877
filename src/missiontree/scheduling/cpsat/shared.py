"""Shared resources: the activities that hold one are intervals, of which no more robots are under way at once than it has room for."""

from __future__ import annotations

from missiontree.scheduling.cpsat.model import Affine, Cumulative, Interval, Model, NoOverlap
from missiontree.scheduling.cpsat.times import Times
from missiontree.scheduling.problem import Problem


def add_sharing(model: Model, problem: Problem, times: Times) -> None:
    """
    Room in every scarce resource.

    Intervals are not optional, so that sizes may vary (see :mod:`missiontree.scheduling.cpsat.heads`). Where several robots have room,
    an activity that takes no time counts nothing: the model allows a little too much there. What is held on ways is left out, too.
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
