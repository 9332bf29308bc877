"""The stops of a route in words."""

from __future__ import annotations

from missiontree.mission.position import Position
from missiontree.reporting.escape import one_line
from missiontree.reporting.maps.cards import name_of
from missiontree.reporting.maps.routes import Route
from missiontree.reporting.maps.things import MapContent


def stops_of(route: Route, content: MapContent) -> list[str]:
    """The stops of a route: number, name, and from when to when in seconds."""
    parts = []
    for stop in route.stops:
        if stop.number:
            when = f"{stop.start_s:.0f}" if stop.end_s <= stop.start_s else f"{stop.start_s:.0f}–{stop.end_s:.0f}"
            parts.append(f"{stop.number} {called(stop.at, stop.spot, content)} {when} s")
    return parts or ["stays where it is"]


def called(entity: str | None, spot: Position | None, content: MapContent) -> str:
    """The place at a spot, or else who or what is visited there."""
    place = next((thing for thing in content.things if thing.kind == "place" and thing.spot == spot), None)
    if place is not None:
        return name_of(place)
    known = content.scene.by_id.get(entity or "")
    if known is not None:
        return one_line(known.label)
    return entity or (f"({spot.x_m:g}, {spot.y_m:g})" if spot is not None else "somewhere")
