"""
How short a way can be at the very least.

Roads are followed as they are open to a robot type. What else stands in the way, keep-outs, zones, blocked cells, is left out of account:
whoever minds that has no shorter way, only a longer one.
"""

from __future__ import annotations

import math
from functools import cached_property
from itertools import pairwise

from missiontree.mission.fleet import RobotType
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Leg

EQUALLY_M = 1e-3
Step = tuple[str, float, float]
"""To a point: metres driven, and seconds ridden beside."""


class Ways:
    """
    The least lengths of ways in a scene, each worked out once.

    Parameters
    ----------
    world
        The scene.
    """

    def __init__(self, world: Scene) -> None:
        self.world = world
        self._steps: dict[str, dict[str, list[Step]]] = {}
        self._far: dict[tuple[str, Position, float | None], dict[str, float]] = {}

    def least(self, kind: RobotType, origin: Position, destination: Position, speed_mps: float | None = None) -> float:
        """The least length in metres that a way could have; with a speed, the least time in seconds. Infinite if there is no way."""
        pace = 1.0 if speed_mps is None else 1 / speed_mps
        if origin == destination:
            return 0.0
        if self.world.roads is not None:
            far = self._far_from(kind, origin, speed_mps)
            there = [far[name] + metres * pace for name, metres in self._joins(kind, destination).items()]
            return min(there, default=math.inf)
        if origin.floor != destination.floor:
            return math.inf
        straight = _apart(origin, destination)
        if self.world.grid is not None:  # ways lead from the middle of a cell to the middle of a cell
            straight = max(0.0, straight - math.sqrt(2) * self.world.grid.cell_m)
        return straight * pace

    def named(self, kind: RobotType, leg: Leg, speed_mps: float | None = None) -> float:
        """The same of the way that a leg names by its road nodes; infinite if it names none, or passes where no road or lift leads."""
        if self.world.roads is None or leg.origin == leg.destination:
            return self.least(kind, leg.origin, leg.destination, speed_mps)
        if not leg.via or any(name not in self._junctions for name in leg.via):
            return math.inf
        pace = 1.0 if speed_mps is None else 1 / speed_mps
        first, last = self._junctions[leg.via[0]], self._junctions[leg.via[-1]]
        if first.floor != leg.origin.floor or last.floor != leg.destination.floor:
            return math.inf
        total = (_apart(leg.origin, first) + _apart(last, leg.destination)) * pace
        for start, end in pairwise(leg.via):
            steps = [step for step in self._steps_of(kind).get(start, ()) if step[0] == end]
            costs = [metres * pace + (seconds if speed_mps is not None else 0.0) for _, metres, seconds in steps]
            total += min(costs, default=math.inf)
        return total

    def _far_from(self, kind: RobotType, origin: Position, speed_mps: float | None) -> dict[str, float]:
        """How far every junction is: straight to where the roads are joined, then step by step, as long as anything comes nearer."""
        asked = (kind.id, origin, speed_mps)
        if asked in self._far:
            return self._far[asked]
        pace = 1.0 if speed_mps is None else 1 / speed_mps
        steps = self._steps_of(kind)
        far = dict.fromkeys(self._junctions, math.inf)
        far |= {name: metres * pace for name, metres in self._joins(kind, origin).items()}
        nearer = [name for name in far if far[name] < math.inf]
        while nearer:
            changed: dict[str, None] = {}
            for start in nearer:
                for end, metres, seconds in steps.get(start, ()):
                    reached = far[start] + metres * pace + (seconds if speed_mps is not None else 0.0)
                    if reached < far[end]:
                        far[end] = reached
                        changed[end] = None
            nearer = list(changed)
        self._far[asked] = far
        return far

    @cached_property
    def _junctions(self) -> dict[str, Position]:
        """Where the roads can be joined: their nodes, and the places at which roads end or lifts stop."""
        roads = self.world.roads
        assert roads is not None
        names = {node.id for node in roads.nodes} | {end for road in roads.roads for end in road.ends}
        names |= {stop for lift in roads.lifts for stop in lift.stops}
        return {name: at for name, at in self.world.road_points.items() if name in names}

    def _joins(self, kind: RobotType, where: Position) -> dict[str, float]:
        """Where a point joins the roads of its floor: at the nearest junction, or one as near."""
        # Where something may stand between a point and the junction nearest to it, it may join at any other.
        slack_m = math.inf if self.world.keep_outs or kind.zones is not None else EQUALLY_M
        near = {name: _apart(where, at) for name, at in self._junctions.items() if at.floor == where.floor}
        closest = min(near.values(), default=0.0)
        return {name: metres for name, metres in near.items() if metres <= closest + slack_m}

    def _steps_of(self, kind: RobotType) -> dict[str, list[Step]]:
        """Every road that is open to a type, in both directions or one, and every ride of a lift that works for it, by start."""
        if kind.id in self._steps:
            return self._steps[kind.id]
        steps: dict[str, list[Step]] = {}
        assert self.world.roads is not None
        for road in self.world.roads.roads:
            one, other = road.ends
            length_m = road.length_m
            if length_m is None:
                length_m = _apart(self._junctions[one], self._junctions[other])
            barred = road.zone is not None and kind.zones is not None and road.zone not in kind.zones
            if road.blocked or barred or (road.types is not None and kind.id not in road.types):
                continue
            steps.setdefault(one, []).append((other, length_m, 0.0))
            if not road.one_way:
                steps.setdefault(other, []).append((one, length_m, 0.0))
        for lift in self.world.roads.lifts:
            if lift.blocked or (lift.types is not None and kind.id not in lift.types):
                continue
            for one in lift.stops:
                steps.setdefault(one, []).extend((other, 0.0, lift.ride_s) for other in lift.stops if other != one)
        self._steps[kind.id] = steps
        return steps


def _apart(one: Position, other: Position) -> float:
    return math.hypot(one.x_m - other.x_m, one.y_m - other.y_m)
