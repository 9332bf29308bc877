"""The least way into each role that is left, from wherever the robots of its type are now or can come to be."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.estimation.travel import Blocked
from missiontree.scheduling.places import Spots
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.role_spots import last_spots
from missiontree.scheduling.trips import Spot

_MANY = 12  # roles of a type beyond which ways are not looked at anew at every step


class Approaches:
    """
    Least ways into the roles of a type.

    A robot of the type gets to the first place of a role from where it is, from where the role that holds it ends, from where another
    role that is left ends, or from a charger. Where any of these may be unknown, the way counts nothing.

    Parameters
    ----------
    problem
        The alternative.
    type_id, roles
        The type, and its roles.
    """

    def __init__(self, problem: Problem, type_id: str, roles: Sequence[int]) -> None:
        self._problem, self._type_id = problem, type_id
        self._goals: dict[int, Spots] = {}
        self._known: dict[int, int] = {}  # what is counted of the way already
        self._before: set[int] = set()  # roles that the way leads to before they begin
        for role in roles if len(roles) <= _MANY else ():
            self._look_at(role)
        self._lasts = {role: last_spots(problem.graph, role, problem.places) for role in roles if self._goals}
        self._stations = frozenset(station.spot for station in problem.chargers.stations.get(type_id, ()))
        self._ways: dict[tuple[Spot, int], int] = {}
        self._between: dict[tuple[int, int], int | None] = {}

    def _look_at(self, role: int) -> None:
        graph, bounds = self._problem.graph, self._problem.bounds
        for place, leaf in enumerate(graph.roles[role]):
            action, activity = graph.tree.action(leaf), graph.activity_of[leaf]
            if action.at is None and not action.moves:
                continue
            goals = self._problem.places.of[leaf]
            if activity not in graph.until and None not in goals:
                self._goals[role] = goals
                self._known[role] = bounds.duration[activity] if action.moves else bounds.lag.get(leaf, 0)
                if not action.moves and not place:
                    self._before.add(role)
            return

    def least(
        self, roles: Sequence[int], robots: Sequence[tuple[int, Spot]]
    ) -> tuple[Sequence[int], Sequence[int] | None]:
        """
        Ticks by which the way into each role is longer than its least duration says.

        Parameters
        ----------
        roles
            Those that nobody has begun.
        robots
            Of the type: the role that holds each (-1 if none), and where it is.

        Returns
        -------
        What is on the way while the role holds its robot; and the same with what is on the way before, if that is anything.
        """
        if not self._goals:
            return [0] * len(roles), None
        ways = [self._way(role, roles, robots) for role in roles]
        if not self._before:
            return ways, None
        inside = [0 if role in self._before else way for role, way in zip(roles, ways, strict=True)]
        return inside, (ways if inside != ways else None)

    def _way(self, role: int, roles: Sequence[int], robots: Sequence[tuple[int, Spot]]) -> int:
        if role not in self._goals:
            return 0
        least, known = None, self._known[role]
        for holding, spot in robots:
            way = self._after(holding, role) if holding >= 0 else None
            if way is None:
                way = self._from(spot, role)  # also if the role that holds it takes it nowhere
            if way <= known:
                return 0
            least = way if least is None else min(least, way)
        for other in roles:
            if other != role and (after := self._after(other, role)) is not None:
                if after <= known:
                    return 0
                least = after if least is None else min(least, after)
        for spot in self._stations:
            least = min(self._from(spot, role), NOWHERE if least is None else least)
        return 0 if least is None or least == NOWHERE else max(0, least - known)

    def _after(self, first: int, role: int) -> int | None:
        """From where a role ends into another; None if it takes its robot nowhere."""
        key = first, role
        if key not in self._between:
            lasts = self._lasts[first]
            self._between[key] = min((self._from(spot, role) for spot in lasts), default=None)
        return self._between[key]

    def _from(self, spot: Spot, role: int) -> int:
        key = spot, role
        found = self._ways.get(key)
        if found is None:
            trips = [] if spot is None else [self._trip(spot, goal) for goal in self._goals[role]]
            found = self._ways[key] = min(trips, default=0)
        return found

    def _trip(self, spot: Spot, goal: Spot) -> int:
        trip = self._problem.trips.approach(self._type_id, spot, goal)
        return NOWHERE if isinstance(trip, Blocked) else trip.ticks


NOWHERE = 1 << 61
"""Ticks of a way that there is none of."""
