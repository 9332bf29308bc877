"""
Where actions are done, as far as it is known beforehand, and how long it takes to get from one to the next inside a role.

An action at something that others move may be done at several spots; then each spot has a literal, and
:mod:`missiontree.scheduling.cpsat.things` says which one holds.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from missiontree.estimation.travel import Blocked
from missiontree.mission.ticks import ticks
from missiontree.scheduling.cpsat.model import Model
from missiontree.scheduling.cpsat.unsupported import UnsupportedError
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.trips import Spot

MOST_SPOTS = 12
_MM = 1000


@dataclass(frozen=True, slots=True)
class Way:
    """Ticks and millimetres from one spot to another, and the metres as they are."""

    ticks: int
    mm: int
    metres: float


Where = dict[Spot, int]
"""Literals of the spots where something may be; exactly one of them holds."""


class Stations:
    """
    Spots of the actions of a problem, with their literals.

    Parameters
    ----------
    model, problem
        What is built, and of what.
    """

    def __init__(self, model: Model, problem: Problem) -> None:
        self._problem, self._model = problem, model
        graph = problem.graph
        self.where: dict[int, Where] = {}  # of actions with a place, and of moves
        self.previous: dict[int, int] = {}  # the action with a place before one in its role
        self.before: dict[int, int] = {}  # the action right before one in its role
        self.first: dict[int, int | None] = {}  # by role
        self.last: dict[int, int | None] = {}
        for role, leaves in graph.roles.items():
            last: int | None = None
            self.first[role] = None
            for number, leaf in enumerate(leaves):
                if number:
                    self.before[leaf] = leaves[number - 1]
                if not graph.tree.action(leaf).is_somewhere:
                    continue
                self.where[leaf] = self._literals(leaf)
                if last is None:
                    self.first[role] = leaf
                else:
                    self.previous[leaf] = last
                last = leaf
            self.last[role] = last

    def _literals(self, leaf: int) -> Where:
        spots = sorted(self._problem.places.of[leaf], key=repr)
        if len(spots) > MOST_SPOTS:
            raise UnsupportedError(f"{self._problem.graph.name(leaf)!r} may be done at more than {MOST_SPOTS} spots")
        if len(spots) == 1:
            return {spots[0]: self._model.true}
        return {spot: self._model.boolean() for spot in spots}

    def way(self, leaf: int, origin: Spot, goal: Spot) -> Way | None:
        """From a spot to an action, or the move that it is; None if there is no way."""
        action = self._problem.graph.tree.action(leaf)
        if goal is None and not action.moves:
            return Way(0, 0, 0.0)
        trip = self._problem.trips.trip(action, origin, goal)
        return None if isinstance(trip, Blocked) else Way(trip.ticks, round(trip.metres * _MM), trip.metres)

    def inside(self, leaf: int) -> Iterator[tuple[Spot, int, Spot, int]]:
        """From where to where the way to an action inside its role may lead: spots with their literals."""
        for origin, here in self.where[self.previous[leaf]].items():
            for goal, there in self.where[leaf].items():
                yield origin, here, goal, there

    def length_of_move(self, leaf: int) -> int | None:
        """Ticks of a move if they are the same whatever happens before; None if not."""
        action = self._problem.graph.tree.action(leaf)
        if set(self.where[leaf]) == {None} or not self._problem.trips.speed_known(action.robot_type):
            return ticks(action.duration_s)
        if leaf not in self.previous:
            return None
        lengths = set()
        for origin, _, goal, _ in self.inside(leaf):
            way = self.way(leaf, origin, goal)
            if way is None:
                return None
            lengths.add(way.ticks)
        return lengths.pop() if len(lengths) == 1 else None
