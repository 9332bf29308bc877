"""How long a mission takes at most if nothing is done at the same time."""

from __future__ import annotations

from missiontree.estimation.travel import Blocked
from missiontree.mission.ticks import ticks
from missiontree.scheduling.cpsat.crew import presence
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.trips import Spot


def horizon_of(problem: Problem) -> int:
    """
    Ticks by which everything can be over, if it can be at all.

    Where everything starts as early as it may, the last end is reached by a chain of actions and ways in which each stands once; an
    action that must be under way when another ends costs a tick more.
    """
    graph, spots = problem.graph, dict[str, set[Spot]]()
    for role, leaves in graph.roles.items():
        own = spots.setdefault(
            problem.staffing.type_of[role], set(problem.trips.starts(problem.staffing.type_of[role]))
        )
        for leaf in leaves:
            if graph.tree.action(leaf).is_somewhere:
                own |= problem.places.of[leaf]
    total = len(graph.until) + max(graph.release.values(), default=0)
    total += max((presence(kind, robot)[0] for kind in problem.fleet.types for robot in kind.members), default=0)
    for leaves in graph.activities:
        # Of joint actions one may be a move, which takes its way after the way to another has been gone.
        for moves in (True, False):
            ways = (_way(problem, leaf, spots) for leaf in leaves if graph.tree.action(leaf).moves == moves)
            total += max(ways, default=0)
        total += max(ticks(graph.tree.action(leaf).duration_s) for leaf in leaves)
    if problem.returning:
        total += max((_way_home(problem, type_id, reached) for type_id, reached in spots.items()), default=0)
    horizon = max(total, problem.bounds.makespan)
    return horizon if problem.home_by is None else min(horizon, problem.home_by)


def _way_home(problem: Problem, type_id: str, spots: set[Spot]) -> int:
    """The longest way home of a type."""
    ways = (problem.trips.approach(type_id, spot, home) for spot in spots for home in problem.trips.starts(type_id))
    return max((way.ticks for way in ways if not isinstance(way, Blocked)), default=0)


def _way(problem: Problem, leaf: int, spots: dict[str, set[Spot]]) -> int:
    """The longest way to an action."""
    action = problem.graph.tree.action(leaf)
    way = 0
    for origin in spots[action.robot_type] if action.is_somewhere else ():
        for goal in problem.places.of[leaf]:
            trip = problem.trips.trip(action, origin, goal)
            way = max(way, 0 if isinstance(trip, Blocked) else trip.ticks)
    return way
