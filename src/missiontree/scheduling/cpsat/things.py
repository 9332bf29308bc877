"""
Who moves what, and where it is when somebody needs it.

Whoever moves a thing has it alone: two moves of it, and a move and a use, come one after the other (after an action that ends only
when another does, the thing may be moved once that has begun). Where a thing is used, the last move before says where it is.
"""

from __future__ import annotations

from missiontree.scheduling.course import begun_is_enough
from missiontree.scheduling.cpsat.model import ExactlyOne, Model, negated
from missiontree.scheduling.cpsat.ordering import Ordering
from missiontree.scheduling.cpsat.placing import Stations
from missiontree.scheduling.cpsat.times import Times
from missiontree.scheduling.cpsat.unsupported import UnsupportedError
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.trips import Spot

MOST_PAIRS = 20_000
NOBODY = -1


class Things:
    """
    Adds all of it to a model.

    Parameters
    ----------
    model, problem, times, stations, ordering
        What is built, of what, and its parts so far.
    """

    def __init__(self, model: Model, problem: Problem, times: Times, stations: Stations, ordering: Ordering) -> None:
        self._model, self._times, self._stations, self._ordering = model, times, stations, ordering
        self._graph, self._trips = problem.graph, problem.trips
        self.movers: dict[str, dict[int, int]] = {}  # by thing: the activity that moves it, and a leaf of it that does
        self.users: dict[
            str, dict[int, list[int]]
        ] = {}  # by thing: the activity that is at it, and its leaves that are
        for activity, joint in enumerate(self._graph.activities):
            for leaf in joint:
                for name in self._graph.tree.action(leaf).brings:
                    self._add_mover(name, activity, leaf)
        for activity, joint in enumerate(self._graph.activities):
            for leaf in joint:
                at = self._graph.tree.action(leaf).at
                if at in self.movers:
                    self.users.setdefault(at, {}).setdefault(activity, []).append(leaf)
        for name, movers in self.movers.items():
            if clash := movers.keys() & self.users.get(name, {}).keys():
                leaf = movers[min(clash)]
                raise UnsupportedError(f"{self._graph.name(leaf)!r} moves {name} and is done at it")
        self.pairs = self._pairs()
        self._one_after_the_other()
        self.source: dict[
            tuple[int, int], int
        ] = {}  # by leaf and activity: the last move before; NOBODY if there is none
        for name in self.movers:
            for leaves in self.users.get(name, {}).values():
                for leaf in leaves:
                    self._locate(name, leaf)

    def _add_mover(self, name: str, activity: int, leaf: int) -> None:
        known = self.movers.setdefault(name, {}).setdefault(activity, leaf)
        if self._graph.tree.action(known).at != self._graph.tree.action(leaf).at:
            raise UnsupportedError(f"{self._graph.name(leaf)!r} takes {name} elsewhere than who works jointly with it")
        if not self._graph.tree.action(leaf).moves:
            raise UnsupportedError(f"{self._graph.name(leaf)!r} brings {name} and is no move")
        if activity in self._graph.until:
            raise UnsupportedError(f"{self._graph.name(leaf)!r} brings {name} until something else ends")

    def _pairs(self) -> list[tuple[int, int]]:
        """Activities of which one moves what the other moves or uses, and whose order is not certain."""
        pairs: set[tuple[int, int]] = set()
        for name, movers in self.movers.items():
            if len(movers) * (len(movers) + len(self.users.get(name, {}))) > MOST_PAIRS:
                raise UnsupportedError(f"{name} is moved and used too often")
            for mover in movers:
                for other in {*movers, *self.users.get(name, {})} - {mover}:
                    low, high = sorted((mover, other))
                    if self._ordering.open_pair(low, high):
                        pairs.add((low, high))
        return sorted(pairs)

    def _one_after_the_other(self) -> None:
        for pair in self.pairs:
            for first, second in (pair, pair[::-1]):
                literal = self._ordering.before(first, second)
                waits = begun_is_enough(self._graph, first, second)
                earlier = self._times.start[first] if waits else self._times.end[first]
                self._model.at_least(self._times.start[second], earlier, 0, (literal,))

    def _locate(self, name: str, leaf: int) -> None:
        """Which move was the last before an action at a thing, and so where it is done."""
        where = self._stations.where[leaf]
        if len(where) == 1:
            return
        model, before, activity = self._model, self._ordering.before, self._graph.activity_of[leaf]
        movers = {one: mover for one, mover in self.movers[name].items() if before(one, activity) != model.false}
        sources = {one: model.boolean() for one in (NOBODY, *movers)}
        model.add(ExactlyOne(tuple(sources.values())))
        self.source |= {(leaf, one): literal for one, literal in sources.items()}
        for one, literal in sources.items():
            for other in movers:
                if one == NOBODY:
                    model.implies((literal,), negated(before(other, activity)))
                elif other == one:
                    model.implies((literal,), before(one, activity))
                else:
                    model.implies((literal, before(other, activity)), before(other, one))
            for spot, there in self._brought_to(name, movers.get(one)).items():
                model.implies((literal, there), where.get(spot, model.false))
        model.add(ExactlyOne(tuple(where.values())))

    def _brought_to(self, name: str, mover: int | None) -> dict[Spot, int]:
        if mover is None:
            return {self._trips.spot(name): self._model.true}
        return self._stations.where[mover]
