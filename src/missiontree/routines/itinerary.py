"""The travel of one robot type through a role, as far as it is known before anything is scheduled."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, replace

from missiontree.estimation.travel import Blocked, Leg, speed_of, start_of, travel_model, travel_time_s
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import RobotType
from missiontree.mission.position import Position
from missiontree.mission.reason import Reason
from missiontree.mission.scene import Scene
from missiontree.routines.compose import FlatAction, FlatRole
from missiontree.routines.nearest import Starts


@dataclass(frozen=True, slots=True)
class Travel:
    """
    Travel for one action.

    Parameters
    ----------
    distance_m
        Estimated length; an approach counts from the start of the type's nearest robot.
    duration_s
        Estimated time of it; None if it is not known, since a position or the type's speed is not.
    certain_m
        Length that is travelled whatever happens before the role; an approach counts 0.
    certain_s
        Time of that, where the type's speed is known.
    nominal
        Whether a move surely takes its nominal duration, since its goal or the type's speed is not known. Default false.
    """

    distance_m: float = 0.0
    duration_s: float | None = None
    certain_m: float = 0.0
    certain_s: float = 0.0
    nominal: bool = False


@dataclass(slots=True)
class _Robot:
    """Where the robot is while its role is walked through: at one of its type's starts until its first action with a place."""

    position: Position | None = None
    certain: bool = False
    started: bool = False


class Itineraries:
    """
    Walks roles through the scene.

    Parameters
    ----------
    scene
        The world, introduced entities included.
    """

    def __init__(self, scene: Scene) -> None:
        self._scene = scene
        self._model = travel_model(scene)
        self._starts: dict[str, tuple[Starts, bool]] = {}

    def walk(
        self, role: FlatRole, robot_type: RobotType, entities: Mapping[str, Entity], elsewhere: Collection[str]
    ) -> tuple[Travel, ...] | Reason:
        """
        Travel for each action of a role, or the Reason why the type can never get through it.

        Parameters
        ----------
        role
            What the robot does.
        robot_type
            Who does it.
        entities
            Entities by argument.
        elsewhere
            Entities that other roles move: where they will be is not certain.
        """
        robot = _Robot()
        brought: dict[str, tuple[Position | None, bool]] = {}
        travels: list[Travel] = []
        for action in role.actions:
            target = action.step.goes_to or action.step.at
            if target is None:
                travels.append(Travel())
                continue
            entity = entities[target]
            position, certain = brought.get(entity.id, (None, False))
            if entity.id not in brought:
                position, certain = self._scene.whereabouts(entity).position, entity.id not in elsewhere
            travel = self._step(robot, robot_type, (position, certain), self._followers(action, entities))
            if isinstance(travel, Reason):
                return travel
            travels.append(travel)
            robot.position, robot.certain, robot.started = position, certain, True
            brought |= {entities[name].id: (position, certain) for name in action.step.brings}
        return tuple(travels)

    def _followers(self, action: FlatAction, entities: Mapping[str, Entity]) -> tuple[Entity, ...]:
        return tuple(entities[name] for name in action.step.brings)

    def _step(
        self, robot: _Robot, robot_type: RobotType, target: tuple[Position | None, bool], followers: Iterable[Entity]
    ) -> Travel | Reason:
        position, certain = target
        if position is None:
            return Travel(nominal=certain)
        speed_mps = speed_of(robot_type, followers)
        if not robot.started:
            return self._approach(robot_type, position, certain, speed_mps)
        if robot.position is None:
            return Travel(nominal=speed_mps is None or robot.certain)
        leg = self._model.leg(robot_type, robot.position, position, speed_mps)
        sure = certain and robot.certain
        if isinstance(leg, Blocked):
            return leg.reason if sure else Travel()
        time_s = _time_s(leg, speed_mps)
        sure_m, sure_s = (leg.distance_m, time_s or 0.0) if sure else (0.0, 0.0)
        return Travel(leg.distance_m, time_s, sure_m, sure_s, nominal=time_s is None)

    def _approach(
        self, robot_type: RobotType, position: Position, certain: bool, speed_mps: float | None
    ) -> Travel | Reason:
        """The way from the nearest robot. If no robot's start has a way, none ever will: starts lead to all else it can reach."""
        starts, all_known = self._starts_of(robot_type)
        leg = starts.quickest(
            position, lambda start: self._model.leg(robot_type, start, position, speed_mps), speed_mps or 1.0
        )
        if isinstance(leg, Leg):
            return Travel(leg.distance_m, _time_s(leg, speed_mps), nominal=speed_mps is None)
        return leg.reason if leg is not None and certain and all_known else Travel()

    def _starts_of(self, robot_type: RobotType) -> tuple[Starts, bool]:
        """Where the robots of the type start, and whether that is known of all."""
        if robot_type.id not in self._starts:
            members = robot_type.members if robot_type.robots else robot_type.members[:1]
            starts = [start_of(robot, self._scene) for robot in members]
            known = Starts(start for start in starts if start is not None)
            self._starts[robot_type.id] = known, None not in starts
        return self._starts[robot_type.id]


def _time_s(leg: Leg, speed_mps: float | None) -> float | None:
    return None if speed_mps is None else travel_time_s(leg, speed_mps)


def unreachable(reason: Reason, robot_type: RobotType, task: str) -> Reason:
    """The travel model's Reason, said of a type and its task."""
    return replace(
        reason, robot=robot_type.id, message=f"{robot_type.label} cannot do {task}: {reason.message}", severity="error"
    )
