"""Roads that closed areas shut, as travel has it: a road is closed if its straight line passes through such an area."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from missiontree.estimation.access import ClosedArea, access_of
from missiontree.estimation.obstacles import Obstacles, xy
from missiontree.mission.fleet import Fleet
from missiontree.mission.scene import Scene


class Shut(NamedTuple):
    """
    What areas do to a road.

    Parameters
    ----------
    to_all
        Whether no robot type of the fleet may use it.
    why
        Which areas shut it, and to whom, if not to all.
    """

    to_all: bool
    why: str


def shut_roads(scene: Scene, fleet: Fleet) -> Mapping[int, Shut]:
    """The roads that keep-outs and zones shut to some robot type or all, by position in the scene's list."""
    alike: dict[tuple[ClosedArea, ...], list[str]] = {}
    for kind in fleet.types:
        alike.setdefault(access_of(kind, scene).areas, []).append(kind.label)
    shut: dict[int, dict[str, list[str]]] = {}
    for areas, labels in alike.items():
        for index, name in _crossed(scene, areas):
            shut.setdefault(index, {}).setdefault(name, []).extend(labels)
    return {index: _told(by_area, len(fleet.types)) for index, by_area in shut.items()}


def _crossed(scene: Scene, areas: tuple[ClosedArea, ...]) -> list[tuple[int, str]]:
    floors = dict.fromkeys(closed.area.floor for closed in areas)
    obstacles = {floor: Obstacles(tuple(one for one in areas if one.area.floor == floor)) for floor in floors}
    found = []
    for index, road in enumerate(scene.roads.roads if scene.roads is not None else ()):
        start, end = (scene.road_points[name] for name in road.ends)
        if start.floor == end.floor and start.floor in obstacles:
            name = obstacles[start.floor].crossed(xy(start), xy(end))
            found += [(index, name)] if name is not None else []
    return found


def _told(by_area: Mapping[str, list[str]], types: int) -> Shut:
    to_all = sum(map(len, by_area.values())) == types
    if to_all and len(by_area) == 1:
        return Shut(True, f"closed by {next(iter(by_area))}")
    return Shut(to_all, ", ".join(f"closed to {', '.join(labels)} by {name}" for name, labels in by_area.items()))
