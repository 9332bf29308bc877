"""Things that stand at one point, or too close to be drawn apart: one mark, and one label that names them all."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field

from missiontree.mission.position import Position
from missiontree.reporting.maps.layout import MapLayout
from missiontree.reporting.maps.routes import Route, Stop
from missiontree.reporting.maps.things import Thing

NEAR = 13.0
"""In units of the picture."""
MOST_MARKS = 400
MOST_STOPS = 150
"""Things that routes touch: if there are more, their names would find no room, and their marks would hide the places."""


@dataclass(slots=True)
class Cluster:
    """
    What one mark stands for.

    Parameters
    ----------
    floor
        Whose panel it is on.
    x, y
        The mark.
    things
        Those that stand there, the mark's own first.
    starts
        Routes that begin there.
    stops
        Stops there, with their routes.
    aside
        Points of things that stand near by, not quite there.
    """

    floor: str
    x: float
    y: float
    things: list[Thing] = field(default_factory=list)
    starts: list[Route] = field(default_factory=list)
    stops: list[tuple[Route, Stop]] = field(default_factory=list)
    aside: list[tuple[float, float]] = field(default_factory=list)

    plain: bool = False
    """Whether it is drawn as a dot, since there are too many."""

    @property
    def passed(self) -> bool:
        """Whether robots only come by: there is no place that helps people to find their way, no start, and nobody who is missed."""
        landmark = any(thing.kind in {"place", "lift"} or not thing.sure for thing in self.things)
        return bool(self.stops) and not self.starts and not landmark

    @property
    def weight(self) -> int:
        """How much its label matters: 0 most, 3 least."""
        if self.starts or self.stops:
            return 0
        if all(thing.kind == "node" for thing in self.things):
            return 3
        return 2 if all(thing.kind == "place" for thing in self.things) else 1


def clusters_of(things: Iterable[Thing], routes: Sequence[Route], layout: MapLayout) -> list[Cluster]:
    """
    Put things, starts and stops into clusters, each into the first that is near. Linear but where very many stand near one point.

    Parameters
    ----------
    things
        What stands on the map; of equals, the first gets the mark.
    routes
        Robots on the move. Those among the things that they are stand at their start with their letter.
    layout
        Where what is; what is on floors that are not shown is left out.
    """
    found = _Clusters(layout)
    for thing in resting(things, routes):
        if (cluster := found.near(thing.spot)) is None:
            continue
        if thing.kind == "node" and cluster.things:
            continue
        cluster.things.append(thing)
        point = layout.point(thing.spot)
        if point is not None and math.dist(point, (cluster.x, cluster.y)) > 3.0:
            cluster.aside.append(point)
    for route in routes:
        if route.start is not None and (cluster := found.near(route.start)) is not None:
            cluster.starts.append(route)
        for stop in route.stops:
            if stop.number and stop.spot is not None and (cluster := found.near(stop.spot)) is not None:
                cluster.stops.append((route, stop))
    return _thinned(found.all)


def _thinned(clusters: list[Cluster]) -> list[Cluster]:
    """Where there are more than can be told apart, they become dots: those that no route touches, plain places first; then things."""
    for least in (2, 1):
        if sum(not cluster.plain for cluster in clusters) > MOST_MARKS:
            for cluster in clusters:
                cluster.plain |= cluster.weight >= least
    if sum(cluster.passed for cluster in clusters) > MOST_STOPS:
        for cluster in clusters:
            cluster.plain |= cluster.passed
    return clusters


def resting(things: Iterable[Thing], routes: Sequence[Route]) -> Iterator[Thing]:
    """Things without the robots that have a route."""
    on_the_way: dict[tuple[str, Position | None], int] = {}
    for route in routes:
        on_the_way[route.thing, route.start] = on_the_way.get((route.thing, route.start), 0) + 1
    for thing in things:
        gone = on_the_way.get((thing.id, thing.spot), 0) if thing.kind == "robot" else 0
        if gone < thing.count:
            yield (
                thing
                if not gone
                else Thing(thing.id, thing.label, thing.kind, thing.spot, thing.note, thing.sure, thing.count - gone)
            )


class _Clusters:
    """Clusters by where they are."""

    def __init__(self, layout: MapLayout) -> None:
        self._layout = layout
        self._cells: dict[tuple[str, int, int], list[Cluster]] = {}
        self.all: list[Cluster] = []

    def near(self, spot: Position) -> Cluster | None:
        """The cluster nearest to a spot, or a new one; None if the floor is not shown."""
        point = self._layout.point(spot)
        if point is None:
            return None
        column, row = math.floor(point[0] / NEAR), math.floor(point[1] / NEAR)
        close = [
            (math.dist(point, (cluster.x, cluster.y)), number, cluster)
            for across in (-1, 0, 1)
            for down in (-1, 0, 1)
            for number, cluster in enumerate(self._cells.get((spot.floor, column + across, row + down), ()))
        ]
        best = min(close, key=lambda one: one[:2], default=None)
        if best is not None and best[0] <= NEAR:
            return best[2]
        cluster = Cluster(spot.floor, *point)
        self._cells.setdefault((spot.floor, column, row), []).append(cluster)
        self.all.append(cluster)
        return cluster
