"""Ways along the road graph: roads, lifts between floors, and a straight stretch at either end."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from itertools import pairwise

from missiontree.estimation.access import Access
from missiontree.estimation.leg import Blocked, Leg, unreachable
from missiontree.estimation.obstacles import Obstacles, describe, xy
from missiontree.estimation.polygon import distance
from missiontree.estimation.shortest import ShortestTree
from missiontree.mission.position import Position
from missiontree.mission.ways import Lift, Road, RoadGraph


@dataclass(frozen=True, slots=True)
class Step:
    """
    One way from a node to the next.

    Parameters
    ----------
    target
        Number of the next node.
    length_m
        Metres to travel.
    ride_s
        Seconds in a lift.
    closed
        Why it may not be used, in words; empty if it may.
    """

    target: int
    length_m: float
    ride_s: float = 0.0
    closed: str = ""

    def takes_s(self, speed_mps: float) -> float:
        """Seconds at a speed."""
        return self.length_m / speed_mps + self.ride_s


@dataclass(frozen=True, slots=True)
class Join:
    """Where a point meets the graph: the node, and the straight stretch to it in metres."""

    node: int
    stretch_m: float


class RoadWays:
    """
    Quickest ways along a road graph.

    A point joins the nearest node of its floor that it sees, that is, without a closed area on the straight line between; of
    nodes equally near, the one listed first. Nodes are the graph's own, then the places that roads or lifts name. There is no
    way past the graph: two points off the road meet it even if they are close to each other. A road both ends of which are on
    one floor is closed if its straight line passes through a closed area.

    Building costs O(V + E * C) for V nodes, E roads and C corners of closed areas; all legs from points that join one node
    share one run of Dijkstra's algorithm, O(E log V).

    Parameters
    ----------
    graph
        Roads and lifts.
    points
        Positions, in frame ``map``, of nodes and places.
    access
        What is closed to the robot type.
    """

    def __init__(self, graph: RoadGraph, points: Mapping[str, Position], access: Access) -> None:
        self._graph = graph
        self._access = access
        self._names = list(dict.fromkeys(_node_names(graph)))
        self._places = [points[name] for name in self._names]
        self._number = {name: number for number, name in enumerate(self._names)}
        self._floors: dict[str, Obstacles] = {}
        self._joins: dict[Position, Join | Blocked] = {}
        self._trees: dict[tuple[int, float], ShortestTree] = {}
        self._steps: list[list[Step]] = [[] for _ in self._names]
        self._add_roads()
        self._add_lifts()

    def leg(self, origin: Position, destination: Position, speed_mps: float = 1.0) -> Leg | Blocked:
        """Find the quickest way; see :class:`missiontree.estimation.travel.Ways`."""
        first, last = self._join(origin), self._join(destination)
        if isinstance(first, Blocked):
            return first
        if isinstance(last, Blocked):
            return last
        tree = self._trees.get((first.node, speed_mps))
        if tree is None:
            tree = self._trees[first.node, speed_mps] = ShortestTree(
                first.node, lambda node: self._open(node, speed_mps)
            )
        if tree.cost(last.node) is None:
            return self._cut_off(origin, first.node, destination, last.node)
        way = tree.way(last.node)
        steps = [self._taken(start, end, speed_mps) for start, end in pairwise(way)]
        return Leg(
            math.fsum([first.stretch_m, *(step.length_m for step in steps), last.stretch_m]),
            math.fsum(step.ride_s for step in steps),
            tuple(self._names[node] for node in way),
        )

    def _add_roads(self) -> None:
        closures = {closure.index: closure.why for closure in self._access.roads}
        for index, road in enumerate(self._graph.roads):
            start, end = (self._number[name] for name in road.ends)
            closed = closures.get(index) or self._crossing(self._places[start], self._places[end])
            why = f"the road {road.ends[0]} - {road.ends[1]} {closed}" if closed else ""
            back = why or (f"the road {road.ends[0]} - {road.ends[1]} is one-way" if road.one_way else "")
            length_m = self._length(road, start, end)
            self._steps[start].append(Step(end, length_m, closed=why))
            self._steps[end].append(Step(start, length_m, closed=back))

    def _length(self, road: Road, start: int, end: int) -> float:
        if road.length_m is not None:
            return road.length_m
        return distance(xy(self._places[start]), xy(self._places[end]))

    def _crossing(self, start: Position, end: Position) -> str:
        if start.floor != end.floor:
            return ""
        name = self._obstacles(start.floor).crossed(xy(start), xy(end))
        return f"passes through {name}" if name else ""

    def _add_lifts(self) -> None:
        closures = {closure.index: closure.why for closure in self._access.lifts}
        for index, lift in enumerate(self._graph.lifts):
            why = f"the lift {lift.id} {closures[index]}" if index in closures else ""
            self._add_lift(lift, why)

    def _add_lift(self, lift: Lift, why: str) -> None:
        stops = list(dict.fromkeys(self._number[name] for name in lift.stops))
        for start in stops:
            self._steps[start].extend(Step(end, 0.0, lift.ride_s, why) for end in stops if end != start)

    def _obstacles(self, floor: str) -> Obstacles:
        if floor not in self._floors:
            self._floors[floor] = Obstacles(self._access.on_floor(floor))
        return self._floors[floor]

    def _join(self, position: Position) -> Join | Blocked:
        join = self._joins.get(position)
        if join is None:
            join = self._joins[position] = self._find_join(position)
        return join

    def _find_join(self, position: Position) -> Join | Blocked:
        obstacles, here = self._obstacles(position.floor), xy(position)
        refusal = obstacles.forbid(position)
        if refusal is not None:
            return refusal
        on_floor = [
            (distance(here, xy(place)), node)
            for node, place in enumerate(self._places)
            if place.floor == position.floor
        ]
        for stretch_m, node in sorted(on_floor):
            if obstacles.crossed(here, xy(self._places[node])) is None:
                return Join(node, stretch_m)
        if not on_floor:
            return unreachable(
                f"{describe(position)} cannot be reached: floor {position.floor} has no road node.",
                hint=f"add a road node on floor {position.floor}",
            )
        name = obstacles.crossed(here, xy(self._places[min(on_floor)[1]]))
        return unreachable(f"{describe(position)} is cut off from every road node by {name}.", found=f"{name}")

    def _open(self, node: int, speed_mps: float) -> Iterable[tuple[int, float]]:
        return [(step.target, step.takes_s(speed_mps)) for step in self._steps[node] if not step.closed]

    def _taken(self, start: int, end: int, speed_mps: float) -> Step:
        between = [step for step in self._steps[start] if step.target == end and not step.closed]
        return min(between, key=lambda step: step.takes_s(speed_mps))

    def _cut_off(self, origin: Position, first: int, destination: Position, last: int) -> Blocked:
        """Why there is no way: what would have to be opened on the way that needs the least opened."""
        tree = ShortestTree(first, lambda node: [(step.target, float(bool(step.closed))) for step in self._steps[node]])
        apart = f"No way from {describe(origin)} to {describe(destination)}"
        if tree.cost(last) is None:
            if origin.floor != destination.floor:
                return unreachable(
                    f"{apart}: nothing joins floor {origin.floor} and floor {destination.floor}.",
                    hint="add a lift that stops on both floors",
                )
            ends = f"{self._names[first]} and {self._names[last]}"
            return unreachable(f"{apart}: no roads join the nodes {ends}.", hint=f"add roads that join {ends}")
        closed = [self._obstacle(start, end) for start, end in pairwise(tree.way(last))]
        found = "; ".join(why for why in closed if why)
        return unreachable(f"{apart}: {found}.", found=found)

    def _obstacle(self, start: int, end: int) -> str:
        """What closes the way between neighbours; empty if one way between them is open."""
        return min(step.closed for step in self._steps[start] if step.target == end)


def _node_names(graph: RoadGraph) -> Iterable[str]:
    yield from (node.id for node in graph.nodes)
    yield from (name for road in graph.roads for name in road.ends)
    yield from (name for lift in graph.lifts for name in lift.stops)
