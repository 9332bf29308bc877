"""Travel inside roles: as long as the way from one place to the next, wherever they turn out to be."""

from __future__ import annotations

from missiontree.scheduling.cpsat.model import Affine, Model
from missiontree.scheduling.cpsat.placing import Stations, Way
from missiontree.scheduling.cpsat.times import Times
from missiontree.scheduling.cpsat.unsupported import UnsupportedError
from missiontree.scheduling.problem import Problem

MOST_MM = 1 << 32


def home_after(role: int) -> int:
    """The key of the way home after a role: beside actions, which are numbered from 0 on."""
    return -1 - role


class Distances:
    """
    How far robots go, in millimetres, by action, and by role after which it goes home: known, or a variable.

    Parameters
    ----------
    model
        What is built.
    """

    def __init__(self, model: Model) -> None:
        self._model = model
        self.known: dict[int, int] = {}
        self.varying: dict[int, int] = {}
        self.arcs: dict[int, list[tuple[int, int]]] = {}  # millimetres and literal

    def least(self, leaf: int, mm: int, when: tuple[int, ...]) -> None:
        """The way to an action is at least so far, where all of ``when`` holds."""
        if not mm:
            return
        if mm > MOST_MM:
            raise UnsupportedError(f"a way is longer than {MOST_MM // 1_000_000} km")
        variable = self.varying.get(leaf)
        if variable is None:
            variable = self.varying[leaf] = self._model.integer(0, MOST_MM)
        self._model.at_least(Affine(variable), Affine(None, mm), 0, when)

    def of(self, leaves: tuple[int, ...]) -> tuple[list[tuple[int, int]], int]:
        """The way of some actions together: terms and a number."""
        terms = [(1, self.varying[leaf]) for leaf in leaves if leaf in self.varying]
        terms += [arc for leaf in leaves for arc in self.arcs.get(leaf, ())]
        return terms, sum(self.known.get(leaf, 0) for leaf in leaves)


class Legs:
    """
    Adds the way to an action: time and distance.

    Parameters
    ----------
    model, problem, times, stations, distances
        What is built, of what, and its parts so far.
    """

    def __init__(self, model: Model, problem: Problem, times: Times, stations: Stations, distances: Distances) -> None:
        self._model, self._graph, self._times = model, problem.graph, times
        self._stations, self._distances = stations, distances

    def inside_roles(self) -> None:
        """Every way whose both ends are in one role."""
        for leaf in self._stations.previous:
            before = self._times.end[self._graph.activity_of[self._stations.before[leaf]]]
            for origin, here, goal, there in self._stations.inside(leaf):
                when = tuple(literal for literal in (here, there) if literal != self._model.true)
                way = self._stations.way(leaf, origin, goal)
                self.takes(leaf, way, before, when)
                if way is not None and not when:
                    self._distances.known[leaf] = way.mm
                elif way is not None:
                    self._distances.least(leaf, way.mm, when)

    def takes(self, leaf: int, way: Way | None, before: Affine, when: tuple[int, ...]) -> None:
        """Where all of ``when`` holds, a robot comes this way to an action, after what it did ``before``; None if there is no way."""
        activity = self._graph.activity_of[leaf]
        if way is None:
            self._model.clause(*(-1 - literal for literal in when))
        elif self._graph.tree.action(leaf).moves:
            if activity not in self._graph.until and not self._known(leaf):
                self._times.lasts(activity, way.ticks, when)
        else:
            self._model.at_least(self._times.start[activity], before, way.ticks, when)

    def _known(self, leaf: int) -> bool:
        return self._stations.length_of_move(leaf) is not None
