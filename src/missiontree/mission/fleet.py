"""The team: robot types, what they can do and how well, their limits, and the robots there are."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from missiontree.mission.frozen_map import FrozenMap
from missiontree.mission.position import Position
from missiontree.mission.value import Count, Id, NonNegative, Positive, Value, require_unique

MAX_ROBOTS = 100_000


@dataclass(frozen=True, slots=True)
class DurationModel(Value):
    """
    How long a type takes for an action, from the action's nominal duration d0: plus_s + scale * d0.

    Parameters
    ----------
    scale
        Factor on the nominal duration, above 0, default 1.
    plus_s
        Seconds added to every action, at least 0, default 0.
    """

    scale: Positive = 1.0
    plus_s: NonNegative = 0.0


@dataclass(frozen=True, slots=True)
class CostModel(Value):
    """
    What an action costs a type: fixed + per_s * duration + per_m * distance travelled for it.

    Parameters
    ----------
    fixed
        Cost of every action, at least 0, default 0.
    per_s
        Cost of a second, at least 0, default 0.
    per_m
        Cost of a metre, at least 0, default 0.
    """

    fixed: NonNegative = 0.0
    per_s: NonNegative = 0.0
    per_m: NonNegative = 0.0


@dataclass(frozen=True, slots=True)
class Capability(Value):
    """
    What a robot type can do, and how well.

    Parameters
    ----------
    quality
        Quality of every action rated by this capability; no unit, at least 0.
    duration
        Duration model; default: the nominal duration.
    cost
        Cost model; default: the action's nominal cost only.
    """

    quality: NonNegative
    duration: DurationModel = DurationModel()
    cost: CostModel = CostModel()


@dataclass(frozen=True, slots=True, kw_only=True)
class Robot(Value):
    """
    One robot with a name of its own.

    Parameters
    ----------
    id
        Name of the robot, unique in the fleet.
    position
        Where it starts; None if unknown, then its first approach takes no time that could be known.
    place
        Place of the scene it starts at, instead of a position.
    remaining
        What is left of a budget at the start, such as ``energy_j``; overrides the type's limit of that name.
    zone
        Zone it starts in.
    available_from_s
        From when on it takes part: it neither travels nor acts before; seconds from the mission's start, at least 0. Default: the type's.
    available_until_s
        By when all that it does has ended; seconds from the mission's start, at least 0. Default: the type's.
    """

    id: Id
    position: Position | None = None
    place: Id | None = None
    remaining: Mapping[Id, NonNegative] = field(default_factory=dict)
    zone: Id | None = None
    available_from_s: NonNegative | None = None
    available_until_s: NonNegative | None = None

    def _check(self) -> None:
        check_availability(f"robot {self.id!r}", self.available_from_s, self.available_until_s)
        if self.position is not None and self.place is not None:
            raise ValueError(f"robot {self.id!r} has both a position and a place; give one.")


@dataclass(frozen=True, kw_only=True)
class RobotType(Value):
    """
    Robots that are alike.

    Parameters
    ----------
    id
        Name of the type, unique in the fleet.
    label
        Name shown to people; default: the id.
    capabilities
        Capability name to quality, or to a whole :class:`Capability`.
    limits
        Any name to a number, unit in the name. A limit is compared where a role needs it (``payload_kg``) and is a budget
        of each robot where actions use it (``energy_j``). ``max_speed_mps`` is the speed of travel.
    total_limits
        Budgets of all robots of the type together.
    uses_per_m
        What a metre of travel uses of each budget.
    zones
        Zones the type may enter; None (default) means all.
    count
        How many interchangeable robots there are. Either this or ``robots``.
    position, place
        Where the interchangeable robots start; None if unknown.
    robots
        Named robots.
    max_in_use
        How many different robots of the type may take part in one alternative, at least 1; None (default) means all.
    available_from_s
        From when on its robots take part: they neither travel nor act before; seconds from the mission's start, at least 0; a named
        robot's own goes before it. Default: from the start.
    available_until_s
        By when all that they do has ended, in the same way. Default: no end.
    """

    id: Id
    label: str = ""
    capabilities: Mapping[Id, Capability | NonNegative] = field(default_factory=dict)
    limits: Mapping[Id, NonNegative] = field(default_factory=dict)
    total_limits: Mapping[Id, NonNegative] = field(default_factory=dict)
    uses_per_m: Mapping[Id, NonNegative] = field(default_factory=dict)
    zones: tuple[Id, ...] | None = None
    count: Count | None = None
    position: Position | None = None
    place: Id | None = None
    robots: tuple[Robot, ...] = ()
    max_in_use: Count | None = None
    available_from_s: NonNegative | None = None
    available_until_s: NonNegative | None = None

    def _check(self) -> None:
        if not self.label:
            object.__setattr__(self, "label", self.id)
        whole = {
            name: given if isinstance(given, Capability) else Capability(given)
            for name, given in self.capabilities.items()
        }
        object.__setattr__(self, "capabilities", FrozenMap(whole))
        if (self.count is None) == (not self.robots):
            raise ValueError(f"robot type {self.id!r} needs either a count or a list of robots, and not both.")
        if self.position is not None and self.place is not None:
            raise ValueError(f"robot type {self.id!r} has both a position and a place; give one.")
        if self.robots and (self.position is not None or self.place is not None):
            raise ValueError(f"robot type {self.id!r} names its robots; give each of them its own position.")
        if self.limits.get("max_speed_mps") == 0:
            raise ValueError(f"robot type {self.id!r}: max_speed_mps must be above 0, got 0.")
        check_availability(f"robot type {self.id!r}", self.available_from_s, self.available_until_s)
        for robot in self.robots:
            check_availability(f"robot {robot.id!r}", *self.availability(robot))

    def capability(self, name: str) -> Capability | None:
        """The capability of that name, or None if the type lacks it."""
        given = self.capabilities.get(name)
        assert not isinstance(given, float | int)  # _check made every short form a whole one
        return given

    def availability(self, robot: Robot) -> tuple[float, float | None]:
        """From when and until when a robot of the type takes part, in seconds; None is for ever."""
        since = self.available_from_s if robot.available_from_s is None else robot.available_from_s
        until = self.available_until_s if robot.available_until_s is None else robot.available_until_s
        return since or 0.0, until

    @cached_property
    def members(self) -> tuple[Robot, ...]:
        """The robots of the type; interchangeable ones are named ``<type>-1``, ``<type>-2`` and so on."""
        if self.robots:
            return self.robots
        return tuple(
            Robot(id=f"{self.id[:56]}-{number}", position=self.position, place=self.place)
            for number in range(1, (self.count or 0) + 1)
        )

    @property
    def usable(self) -> int:
        """How many robots of the type may take part in one alternative."""
        return len(self.members) if self.max_in_use is None else min(self.max_in_use, len(self.members))

    def budget(self, robot: Robot, name: str) -> float | None:
        """What the robot may use of a budget; None if it has no such limit."""
        return robot.remaining.get(name, self.limits.get(name))


@dataclass(frozen=True)
class Fleet(Value):
    """
    The whole team.

    Parameters
    ----------
    types
        Robot types, at least one, in the order in which they are offered. At most 100,000 robots in all.
    label
        Name shown to people.
    total_limits
        What all robots of a mission together may use of a budget, whatever their type: ``{energy_j: 9000}``; at least 0. Default:
        no such limit.
    """

    types: tuple[RobotType, ...]
    label: str = ""
    total_limits: Mapping[Id, NonNegative] = field(default_factory=dict)

    def _check(self) -> None:
        if not self.types:
            raise ValueError("a fleet needs at least one robot type.")
        robots = sum(kind.count or len(kind.robots) for kind in self.types)
        if robots > MAX_ROBOTS:
            raise ValueError(f"a fleet has at most {MAX_ROBOTS:,} robots, this one {robots:,}.")
        require_unique("robot type", tuple(kind.id for kind in self.types))
        require_unique("robot", tuple(robot.id for kind in self.types for robot in kind.members))

    @cached_property
    def by_id(self) -> dict[str, RobotType]:
        """Robot types by id."""
        return {kind.id: kind for kind in self.types}

    @cached_property
    def type_of(self) -> dict[str, RobotType]:
        """Robot type by robot id."""
        return {robot.id: kind for kind in self.types for robot in kind.members}

    @cached_property
    def robots(self) -> dict[str, Robot]:
        """Robots by id."""
        return {robot.id: robot for kind in self.types for robot in kind.members}


def check_availability(whose: str, since_s: float | None, until_s: float | None) -> None:
    """
    Refuse a robot that leaves before it comes.

    Raises
    ------
    ValueError
        Naming both times.
    """
    if until_s is not None and until_s < (since_s or 0.0):
        raise ValueError(f"{whose} is available from {since_s:g} s until {until_s:g} s, which is earlier.")
