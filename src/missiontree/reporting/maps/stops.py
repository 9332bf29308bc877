"""The stops of a route in words."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.mission.position import Position
from missiontree.reporting.clock import LONG_S, clock
from missiontree.reporting.escape import one_line
from missiontree.reporting.maps.cards import name_of
from missiontree.reporting.maps.routes import Route, Stop
from missiontree.reporting.maps.things import MapContent


def stops_of(route: Route, content: MapContent, length_s: float) -> list[str]:
    """
    The stops of a route: as they are marked on the map, name, and from when to when.

    Parameters
    ----------
    route
        The route.
    content
        What is on the map.
    length_s
        How long all routes take, in seconds; from ten minutes on, times are told by the clock.
    """
    return [
        f"{route.letter}{stop.number} {called(stop.at, stop.spot, content)} ({_when(stop, length_s)})"
        for stop in route.stops
        if stop.number
    ] or ["stays where it is"]


def length_of(routes: Sequence[Route]) -> float:
    """When the last stop of all routes ends, in seconds; 0 without any."""
    return max((stop.end_s for route in routes for stop in route.stops), default=0.0)


def _when(stop: Stop, length_s: float) -> str:
    if length_s >= LONG_S:
        start, end, unit = clock(stop.start_s), clock(stop.end_s), ""
    else:
        start, end, unit = f"{stop.start_s:.0f}", f"{stop.end_s:.0f}", " s"
    return f"{start}{unit}" if end == start else f"{start}–{end}{unit}"


def called(entity: str | None, spot: Position | None, content: MapContent) -> str:
    """The place at a spot, or else who or what is visited there."""
    place = next((thing for thing in content.things if thing.kind == "place" and thing.spot == spot), None)
    if place is not None:
        return name_of(place)
    known = content.scene.by_id.get(entity or "")
    if known is not None:
        return one_line(known.label)
    return entity or (f"({spot.x_m:g}, {spot.y_m:g})" if spot is not None else "somewhere")
