"""
When everything starts and ends: one variable per activity, and one per inner event that a precedence needs.

An activity that takes a known time has a start, and its end is that start plus the time. One whose length depends on where its robot
comes from (a move), or on others (until), has an end of its own.
"""

from __future__ import annotations

from missiontree.mission.ticks import ticks
from missiontree.scheduling.cpsat.model import FAR, Affine, Linear, Model
from missiontree.scheduling.cpsat.net import precedences
from missiontree.scheduling.cpsat.placing import Stations
from missiontree.scheduling.problem import Problem


class Times:
    """
    Start and end of every activity in a model.

    Parameters
    ----------
    model, problem, stations
        What is built, of what, and where its actions are done.
    horizon
        Ticks at which everything must be over.
    """

    def __init__(self, model: Model, problem: Problem, stations: Stations, horizon: int) -> None:
        self.model, self.problem, self.horizon = model, problem, horizon
        graph, bounds = problem.graph, problem.bounds
        self.start: list[Affine] = []
        self.end: list[Affine] = []
        self.makespan = model.integer(min(bounds.makespan, horizon), horizon)
        for activity in range(len(graph.activities)):
            start = Affine(self._between(2 * activity))
            longest, certain = (0, False) if activity in graph.until else self._length(activity, stations)
            end = start + longest if certain else Affine(self._between(2 * activity + 1))
            if not certain:
                self.model.at_least(end, start, max(longest, bounds.duration[activity]))
            self.start.append(start)
            self.end.append(end)
        self.event: dict[int, Affine] = {}
        self._order()
        self._under_way()
        for giver, taker in sorted(problem.hand_overs.taker.items()):
            self.model.at_least(self.end[giver], self.start[taker])  # and no sooner, by the order
        for activity, deadline in sorted(graph.deadline.items()):
            self.model.at_least(Affine(None, deadline), self.end[activity])

    def of(self, event: int) -> Affine:
        """When an event is."""
        if event < 2 * len(self.start):
            return (self.end if event % 2 else self.start)[event // 2]
        if event not in self.event:
            self.event[event] = Affine(self.model.integer(0, self.horizon))
        return self.event[event]

    def lasts(self, activity: int, length: int, when: tuple[int, ...] = ()) -> None:
        """An activity takes at least so long."""
        self.model.at_least(self.end[activity], self.start[activity], length, when)

    def _between(self, event: int) -> int:
        least = self.problem.bounds.heads[event]
        return self.model.integer(least, max(least, self.horizon - self.problem.bounds.tails[event]))

    def _length(self, activity: int, stations: Stations) -> tuple[int, bool]:
        """How long an activity takes as far as that is known beforehand, and whether it is."""
        graph, longest, certain = self.problem.graph, 0, True
        for leaf in graph.activities[activity]:
            action = graph.tree.action(leaf)
            length = stations.length_of_move(leaf) if action.moves else ticks(action.duration_s)
            certain &= length is not None
            longest = max(longest, length or 0)
        return longest, certain

    def _order(self) -> None:
        followed = set()
        for earlier, later in precedences(self.problem.graph):
            followed.add(earlier)
            self.model.at_least(self.of(later), self.of(earlier))
        makespan = Affine(self.makespan)
        for activity, end in enumerate(self.end):
            if 2 * activity + 1 not in followed:
                self.model.at_least(makespan, end)

    def _under_way(self) -> None:
        """An open-ended action has begun before the last of those that set its end has ended."""
        self.latest: dict[tuple[int, int], int] = {}
        for open_ended, ends in sorted(self.problem.graph.until.items()):
            for one in sorted(ends):
                literal = self.latest[open_ended, one] = self.model.true if len(ends) == 1 else self.model.boolean()
                self.model.at_least(self.end[one], self.start[open_ended], 1, (literal,))
            if ends:
                self.model.clause(*(self.latest[open_ended, one] for one in sorted(ends)))

    def total_of_ends(self) -> tuple[tuple[tuple[int, int], ...], int]:
        """The sum of the ends of all actions: terms and a number."""
        counts: dict[int, int] = {}
        offset = 0
        for activity, leaves in enumerate(self.problem.graph.activities):
            end = self.end[activity]
            offset += end.offset * len(leaves)
            if end.var is not None:
                counts[end.var] = counts.get(end.var, 0) + len(leaves)
        return tuple((count, variable) for variable, count in counts.items()), offset

    def no_later(self, terms: tuple[tuple[int, int], ...], most: int) -> None:
        """A sum stays as good as it was found to be."""
        self.model.add(Linear(terms, -FAR, most))
