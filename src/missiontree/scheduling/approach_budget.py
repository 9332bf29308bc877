"""Proof that no robot of a type can pay for getting to a role and doing it."""

from __future__ import annotations

from collections.abc import Iterator

from missiontree.estimation.travel import Blocked, start_of
from missiontree.mission.fleet import Robot, RobotType
from missiontree.mission.reason import Reason
from missiontree.scheduling.impossible import TOLERANCE, least_use
from missiontree.scheduling.places import Places
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.trips import Trips


def approaches_too_dear(graph: TaskGraph, places: Places, trips: Trips) -> list[Reason]:
    """
    Roles whose first place is so far from every robot of the type that what it has does not last for the way and the role.

    Whatever a robot does before, it gets from its start to that place over no fewer metres than the shortest way. Where there
    are lifts, the quickest way need not be the shortest, and nothing is claimed.
    """
    if trips.scene.roads is not None and trips.scene.roads.lifts:
        return []
    return [reason for leaves in graph.roles.values() for reason in _too_dear(leaves, graph, places, trips)]


def _too_dear(leaves: tuple[int, ...], graph: TaskGraph, places: Places, trips: Trips) -> Iterator[Reason]:
    first = next((leaf for leaf in leaves if graph.tree.action(leaf).at is not None), None)
    if first is None:
        return
    action = graph.tree.action(first)
    kind = trips.fleet.by_id[action.robot_type]
    need: dict[str, float] = dict.fromkeys(kind.uses_per_m, 0.0)
    for leaf in leaves:
        for name, amount in least_use(graph.tree.action(leaf)).items():
            need[name] = need.get(name, 0.0) + amount
    short = [_short(kind, robot, need, _metres(kind, robot, first, places, trips)) for robot in kind.members]
    lacking = [one for one in short if one is not None]
    if len(lacking) == len(short):
        name, there, needed = min(lacking, key=lambda one: one[2] - one[1])
        yield Reason(
            rule="budget_exceeded",
            message=f"No robot of type {kind.label!r} can get to {action.at} and do its part there: that takes at least "
            f"{needed:g} of {name}, and the nearest to it has {there:g}.",
            node=action.text,
            robot=kind.id,
            found=f"{name} {there:g}",
            needed=f"{name} {needed:g}",
        )


def _metres(kind: RobotType, robot: Robot, leaf: int, places: Places, trips: Trips) -> float:
    """The fewest metres from the robot's start to where the action may be; 0 where that is unknown."""
    start = start_of(robot, trips.scene)
    metres = []
    for spot in places.of[leaf]:
        if start is None or spot is None:
            return 0.0
        trip = trips.approach(kind.id, start, spot)
        if not isinstance(trip, Blocked):
            metres.append(trip.metres)
    return min(metres, default=0.0)


def _short(kind: RobotType, robot: Robot, need: dict[str, float], metres: float) -> tuple[str, float, float] | None:
    """A budget that does not last, with what there is and what is needed; None if all last."""
    for name, amount in need.items():
        there = kind.budget(robot, name)
        needed = amount + metres * kind.uses_per_m.get(name, 0.0)
        if there is not None and needed > there + TOLERANCE:
            return name, there, needed
    return None
