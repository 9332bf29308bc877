"""Where a robot or an entity is from when on, as the schedule has it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.reporting.maps.errands import Errand
from missiontree.reporting.maps.routes import Route, in_order
from missiontree.reporting.maps.ways import Waypoint
from missiontree.reporting.maps.whereabouts import Deed, Whereabouts

Track = list[tuple[float, Waypoint | None]]
"""Times with places; None from when on nothing is known."""


def robot_track(route: Route) -> Track:
    """A robot from its start along its legs; hidden while nobody knows where it is."""
    track: Track = []
    here = route.start
    if here is not None:
        track.append((0.0, _at(0.0, here)))
    lines = {passage.leaf: passage.line for passage in route.passages}
    own = iter([passage.line for passage in route.passages if passage.leaf == -1])
    for deed in in_order(route.deeds, route.errands):
        if isinstance(deed, Errand):
            if deed.leg is not None:
                track += [(waypoint.t_s, waypoint) for waypoint in next(own)]
            here = deed.spot
            continue
        one = deed.scheduled
        if deed.leg is not None:
            track += [(waypoint.t_s, waypoint) for waypoint in lines[one.leaf]]
            here = deed.at
        elif deed.action.moves or deed.action.at is not None:
            arrival_s = one.end_s if deed.action.moves else one.start_s
            if deed.at != here:
                if here is not None:
                    track.append((one.start_s, None))
                if deed.at is not None:
                    track.append((arrival_s, _at(arrival_s, deed.at)))
            here = deed.at
    return track


def entity_track(name: str, where: Whereabouts, lines: Mapping[int, Sequence[Waypoint]], scene: Scene) -> Track:
    """An entity waits where it is known to be, comes into sight when found, and moves with those who bring it."""
    found = scene.whereabouts(scene.by_id[name])
    track: Track = [(0.0, _at(0.0, found.position))] if found.source == "known" and found.position is not None else []
    moves = where.brought.get(name, [])
    for deed in sorted([*_finding(name, where), *moves], key=lambda deed: (deed.scheduled.end_s, deed.scheduled.leaf)):
        one = deed.scheduled
        if deed not in moves:
            if not track and deed.at is not None:
                track.append((one.end_s, _at(one.end_s, deed.at)))
            continue
        if deed.leg is not None:
            track += [(waypoint.t_s, waypoint) for waypoint in lines[one.leaf]]
        else:
            track.append((one.start_s, None))
            if deed.at is not None:
                track.append((one.end_s, _at(one.end_s, deed.at)))
    return track


def _finding(name: str, where: Whereabouts) -> list[Deed]:
    return [deed for deed in where.deeds if deed.action.finds == name]


def changing(where: Whereabouts, scene: Scene) -> Iterator[str]:
    """Entities that are brought along, or found after having been missed, in order of time."""
    named: list[str] = []
    for deed in where.deeds:
        named += deed.action.brings if deed.action.moves else ()
        if deed.action.finds is not None:
            named.append(deed.action.finds)
    for name in dict.fromkeys(named):
        if name in scene.by_id:
            missed = scene.whereabouts(scene.by_id[name]).source != "known"
            if name in where.brought or missed:
                yield name


def _at(t_s: float, spot: Position) -> Waypoint:
    return Waypoint(t_s, spot.x_m, spot.y_m, spot.floor)
