"""
The robots of each type: those that have done something, and those that have not.

Robots that have done nothing and are alike are interchangeable, so that of ten thousand only as many are looked at as could be
taken at once.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain, islice

from missiontree.mission.fleet import Fleet
from missiontree.scheduling.world_state import RobotState, WorldState


class Pool:
    """
    Robots by type.

    Parameters
    ----------
    fleet
        The types.
    world
        The robots at the start of a run.
    """

    def __init__(self, fleet: Fleet, world: WorldState) -> None:
        self._active: dict[str, list[RobotState]] = {kind.id: [] for kind in fleet.types}
        self._fresh: dict[str, dict[object, list[RobotState]]] = {kind.id: {} for kind in fleet.types}
        self._look: dict[str, object] = {}
        for kind in fleet.types:
            states = [world.robots[robot.id] for robot in kind.members]
            if not kind.robots:
                self._fresh[kind.id][None] = states
                continue
            for state in states:
                look = self._look[state.id] = (
                    state.spot,
                    tuple(sorted(state.left.items())),
                    state.free_at,
                    state.until,
                )
                self._fresh[kind.id].setdefault(look, []).append(state)

    def robots(self, type_id: str, many: int) -> Iterator[RobotState]:
        """Robots of a type; of those that are alike and unused no more than ``many``."""
        return chain(self._active[type_id], *(islice(alike, many) for alike in self._fresh[type_id].values()))

    def use(self, robot: RobotState) -> None:
        """A robot does something for the first time, or again."""
        if not robot.used:
            robot.used = True
            self._fresh[robot.type_id][self._look.get(robot.id)].remove(robot)
            self._active[robot.type_id].append(robot)

    def free_from(self, type_id: str) -> int | None:
        """When the first robot of a type is free, in ticks; None if all are held."""
        fresh = (alike[0].free_at for alike in self._fresh[type_id].values() if alike)
        active = (r.free_at for r in self._active[type_id] if r.role is None and r.promised is None)
        return min(chain(fresh, active), default=None)
