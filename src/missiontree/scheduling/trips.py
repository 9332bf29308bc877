"""Travel as schedulers see it: ticks and metres of one robot type's way, what is unknown included."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from missiontree.estimation.travel import Blocked, speed_of, start_of, travel_model, travel_time_s
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import Action
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.ticks import ticks

Spot = Position | None


@dataclass(frozen=True, slots=True)
class Trip:
    """
    A way to an action.

    Parameters
    ----------
    ticks
        How long it takes.
    metres
        How far it is, as far as known.
    via
        Road nodes passed.
    origin, destination
        From where to where; None if unknown.
    holds
        Shared resources that are held all the way.
    """

    ticks: int
    metres: float = 0.0
    via: tuple[str, ...] = ()
    origin: Spot = None
    destination: Spot = None
    holds: tuple[str, ...] = ()

    @property
    def known(self) -> bool:
        """Whether both ends are known."""
        return self.origin is not None and self.destination is not None


class Trips:
    """
    The ways of a fleet through a scene, remembered.

    Without a known origin, destination or speed a move takes its nominal duration and an approach no time; the metres are counted
    where both ends are known.

    Parameters
    ----------
    fleet
        Robot types and their speeds.
    scene
        The world.
    """

    def __init__(self, fleet: Fleet, scene: Scene) -> None:
        self.fleet = fleet
        self.scene = scene
        self._model = travel_model(scene)
        self._starts: dict[str, tuple[Spot, ...]] = {}
        self._spots: dict[str, Spot] = {}
        self._trips: dict[tuple[str, Spot, Spot, tuple[str, ...], float | None], Trip | Blocked] = {}

    def trip(self, action: Action, origin: Spot, destination: Spot) -> Trip | Blocked:
        """The way to an action, or the move that it is; blocked if there is none."""
        nominal = action.duration_s if action.moves else None
        key = (action.robot_type, origin, destination, action.brings, nominal)
        found = self._trips.get(key)
        if found is None:
            found = self._trips[key] = self._find(*key)
        return found

    def approach(self, robot_type: str, origin: Spot, destination: Spot) -> Trip | Blocked:
        """A way with nothing brought; no time and no metres where an end of it is not known."""
        key = (robot_type, origin, destination, (), None)
        found = self._trips.get(key)
        if found is None:
            found = self._trips[key] = self._find(*key)
        return found

    def starts(self, robot_type: str) -> tuple[Spot, ...]:
        """Where the robots of a type start, one by one; None where that is not known."""
        found = self._starts.get(robot_type)
        if found is None:
            kind = self.fleet.by_id[robot_type]
            named = tuple(start_of(robot, self.scene) for robot in kind.robots)
            found = self._starts[robot_type] = named or (start_of(kind.members[0], self.scene),) * len(kind.members)
        return found

    def speed_known(self, robot_type: str) -> bool:
        """Whether the type's speed of travel is known."""
        return speed_of(self.fleet.by_id[robot_type]) is not None

    def spot(self, entity: str) -> Spot:
        """Where an entity is at the start of the mission, as planning takes it."""
        if entity not in self._spots:
            found = self.scene.by_id.get(entity)
            self._spots[entity] = None if found is None else self.scene.whereabouts(found).position
        return self._spots[entity]

    def _find(
        self, type_id: str, origin: Spot, destination: Spot, brings: Iterable[str], nominal_s: float | None
    ) -> Trip | Blocked:
        unknown = ticks(nominal_s) if nominal_s is not None else 0
        if origin is None or destination is None:
            return Trip(unknown, origin=origin, destination=destination)
        kind = self.fleet.by_id[type_id]
        speed = speed_of(kind, (self.scene.by_id[name] for name in brings if name in self.scene.by_id))
        leg = self._model.leg(kind, origin, destination, speed)
        if isinstance(leg, Blocked):
            return leg
        time = unknown if speed is None else ticks(travel_time_s(leg, speed))
        return Trip(time, leg.distance_m, leg.via, origin, destination, self.scene.passed(leg.via))
