"""A fleet with more robots, copies of those that it has; and a scene with more room at a shared resource or a charger."""

from __future__ import annotations

from dataclasses import replace
from typing import TypeVar

from missiontree.mission.charger import Charger
from missiontree.mission.fleet import Fleet, Robot, RobotType
from missiontree.mission.scene import Scene
from missiontree.mission.shared_resource import SharedResource

_Shared = TypeVar("_Shared", SharedResource, Charger)


def with_more(fleet: Fleet, type_id: str, count: int = 1, like: str | None = None) -> Fleet:
    """
    The fleet with more robots of a type, all of which may take part.

    Parameters
    ----------
    fleet
        As it is.
    type_id
        Type of the robots that are added.
    count
        How many. Default 1.
    like
        Robot of which they are copies, if robots of the type are named. Default: each of them in turn.

    Raises
    ------
    ValueError
        If the fleet has no such type or robot, or would have too many robots.
    """
    if type_id not in fleet.by_id or (like is not None and fleet.type_of.get(like) is not fleet.by_id[type_id]):
        raise ValueError(f"the fleet has no robot type {type_id!r}, or no robot {like!r} of it.")
    kinds = tuple(_larger(kind, count, like, fleet) if kind.id == type_id else kind for kind in fleet.types)
    return replace(fleet, types=kinds)


def with_room(scene: Scene, resource_id: str, places: int = 1) -> Scene:
    """
    The scene with more places at a shared resource.

    Raises
    ------
    ValueError
        If the scene has no such resource.
    """
    return replace(scene, resources=_roomier(scene.resources, resource_id, places, "shared resource"))


def with_plugs(scene: Scene, charger_id: str, robots: int = 1) -> Scene:
    """
    The scene with room for more robots at a time at a charger.

    Raises
    ------
    ValueError
        If the scene has no such charger.
    """
    return replace(scene, chargers=_roomier(scene.chargers, charger_id, robots, "charger"))


def _roomier(shared: tuple[_Shared, ...], name: str, places: int, what: str) -> tuple[_Shared, ...]:
    """All of them, one with more room."""
    if all(one.id != name for one in shared):
        raise ValueError(f"the scene has no {what} {name!r}.")
    return tuple(replace(one, capacity=one.capacity + places) if one.id == name else one for one in shared)


def _larger(kind: RobotType, count: int, like: str | None, fleet: Fleet) -> RobotType:
    most = None if kind.max_in_use is None else kind.max_in_use + count
    if not kind.robots:
        return replace(kind, count=len(kind.members) + count, max_in_use=most)
    models = [robot for robot in kind.robots if like in {None, robot.id}]
    taken = set(fleet.robots)
    added: list[Robot] = []
    for number in range(count):
        model = models[number % len(models)]
        added.append(replace(model, id=_free_name(model.id, taken)))
        taken.add(added[-1].id)
    return replace(kind, robots=(*kind.robots, *added), max_in_use=most)


def _free_name(name: str, taken: set[str]) -> str:
    number = 2
    while f"{name[:56]}-{number}" in taken:
        number += 1
    return f"{name[:56]}-{number}"
