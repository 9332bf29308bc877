"""Where actions can possibly happen, whatever the schedule: the ground of everything that is claimed as proven."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.mission.grounded import Action
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.trips import Spot, Trips

Spots = frozenset[Spot]

MANY_SPOTS = 48
"""Of one type, beyond which nothing is said of its travel unless there is time for it, so that bounds stay cheaper than schedules."""


class Places:
    """
    Possible spots of every action of one alternative.

    An entity that nobody moves is where the scene has it. One that is moved is where the last move before the action took it, if
    all its moves are ordered against the action; else it may be anywhere that any of them takes it.

    Parameters
    ----------
    graph
        A task graph without a cycle.
    order
        Its events in order.
    trips
        The scene.
    """

    def __init__(self, graph: TaskGraph, order: Sequence[int], trips: Trips) -> None:
        self._trips = trips
        self._movers: dict[str, list[int]] = {}
        leaves = [leaf for leaves in graph.activities for leaf in leaves]
        for leaf in leaves:
            for name in graph.tree.action(leaf).brings:
                self._movers.setdefault(name, []).append(leaf)
        self._graph = graph
        touching = {leaf for movers in self._movers.values() for leaf in movers}
        touching |= {leaf for leaf in leaves if graph.tree.action(leaf).at in self._movers}
        self._bit = {leaf: 1 << index for index, leaf in enumerate(sorted(touching))}
        marks: dict[int, int] = {}
        for leaf, bit in self._bit.items():
            marks[graph.end(leaf)] = marks.get(graph.end(leaf), 0) | bit
        self._before = graph.marks_before(order, marks) if self._bit else []
        self._anywhere = self._all_spots()
        self.of: dict[int, Spots] = {}
        for event in order:
            if event % 2 == 0 and event // 2 < len(graph.activities):
                for leaf in graph.activities[event // 2]:
                    self.of[leaf] = self._spots(leaf, graph.tree.action(leaf))

    def _all_spots(self) -> dict[str, Spots]:
        """Everywhere a moved entity may ever be; grows until nothing is added."""
        spots = {name: frozenset({self._trips.spot(name)}) for name in self._movers}
        changed = True
        while changed:
            changed = False
            for name, movers in self._movers.items():
                grown = set(spots[name])
                for leaf in movers:
                    at = self._graph.tree.action(leaf).at
                    grown |= {None} if at is None else spots.get(at, frozenset({self._trips.spot(at)}))
                if len(grown) > len(spots[name]):
                    spots[name], changed = frozenset(grown), True
        return spots

    def _spots(self, leaf: int, action: Action) -> Spots:
        if action.at is None:
            return frozenset({None})
        movers = self._movers.get(action.at)
        if movers is None:
            return frozenset({self._trips.spot(action.at)})
        start = self._graph.start(leaf)
        earlier = [m for m in movers if self._before[start] & self._bit[m]]
        later = [m for m in movers if m not in earlier and self._before[self._graph.start(m)] & self._bit[leaf]]
        if len(earlier) + len(later) < len(movers):
            return self._anywhere[action.at]
        last = [m for m in earlier if not any(self._before[self._graph.start(n)] & self._bit[m] for n in earlier)]
        if not last:
            return frozenset({self._trips.spot(action.at)})
        return frozenset[Spot]().union(*(self.of[m] for m in last))
