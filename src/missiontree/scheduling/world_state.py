"""Where robots and entities are, and from when, as a schedule grows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import Action
from missiontree.mission.ticks import ticks, ticks_within
from missiontree.scheduling.trips import Spot, Trips


@dataclass(slots=True)
class RobotState:
    """
    One robot at the end of what it is scheduled for so far.

    Parameters
    ----------
    id, type_id, index
        Robot, its type, and its number in the fleet.
    spot, stand
        Where it is, None if unknown; and the number of that spot, see :meth:`WorldState.number`.
    free_at
        When its last action ends, or when it comes, in ticks.
    role
        Role that holds it; None if none does.
    promised
        Bundle of roles that it is kept for; None if none.
    used
        Whether it has done anything.
    wears
        Marks of the roles it has filled, see :mod:`missiontree.scheduling.staffing`.
    left
        What is left of each budget.
    until
        When it leaves, in ticks; None if it stays.
    home, home_stand
        Where it starts, None if unknown; and the number of that spot.
    """

    id: str
    type_id: str
    index: int
    spot: Spot
    stand: int = 0
    free_at: int = 0
    role: int | None = None
    promised: int | None = None
    used: bool = False
    wears: set[object] = field(default_factory=set)
    left: dict[str, float] = field(default_factory=dict)
    until: int | None = None
    home: Spot = None
    home_stand: int = 0


@dataclass(slots=True)
class EntityState:
    """Where an entity is, since when, and until when somebody needs it there (ticks)."""

    spot: Spot
    since: int = 0
    used_until: int = 0


class WorldState:
    """
    The state of all robots and of the entities that the schedule has touched.

    Parameters
    ----------
    fleet
        Robots and where they start.
    trips
        The scene and its ways.
    """

    def __init__(self, fleet: Fleet, trips: Trips) -> None:
        self._trips = trips
        self._entities: dict[str, EntityState] = {}
        self._numbers: dict[Spot, int] = {}
        self.moves = 0  # how often something was brought elsewhere
        self.robots: dict[str, RobotState] = {}
        for kind in fleet.types:
            limits = dict(kind.limits)
            for robot, start in zip(kind.members, trips.starts(kind.id), strict=True):
                since_s, until_s = kind.availability(robot)
                self.robots[robot.id] = RobotState(
                    robot.id,
                    kind.id,
                    len(self.robots),
                    start,
                    self.number(start),
                    free_at=ticks(since_s),
                    left=limits | dict(robot.remaining) if robot.remaining else dict(limits),
                    until=None if until_s is None else ticks_within(until_s),
                    home=start,
                    home_stand=self.number(start),
                )

    def number(self, spot: Spot) -> int:
        """A number for a spot: quicker to look up than a position."""
        return self._numbers.setdefault(spot, len(self._numbers))

    def entity(self, name: str) -> EntityState:
        """State of an entity or place."""
        state = self._entities.get(name)
        if state is None:
            state = self._entities[name] = EntityState(self._trips.spot(name))
        return state

    def spot(self, action: Action) -> Spot:
        """Where an action happens, or where a move goes; None if unknown or anywhere."""
        return None if action.at is None else self.entity(action.at).spot

    def not_before(self, action: Action) -> int:
        """Ticks before which an action cannot start because of who moves, or still needs, the entities it touches."""
        earliest = 0 if action.at is None else self.entity(action.at).since
        for name in action.brings:
            state = self.entity(name)
            earliest = max(earliest, state.since, state.used_until)
        return earliest

    def needed(self, name: str, until: int) -> None:
        """Somebody needs an entity where it is, until then."""
        state = self.entity(name)
        state.used_until = max(state.used_until, until)

    def brought(self, name: str, since: int) -> None:
        """An entity is where it is from then on only."""
        state = self.entity(name)
        state.since = max(state.since, since)

    def do(self, robot: RobotState, action: Action, start: int, end: int) -> None:
        """Let a robot do an action: it, and what it brings, are elsewhere afterwards."""
        self.do_jointly([(robot, action)], start, end)

    def do_jointly(self, deeds: Sequence[tuple[RobotState, Action]], start: int, end: int) -> None:
        """Let robots do actions at one time; who is where something is that another takes away stays where it was."""
        destinations = [self.spot(action) for _, action in deeds]
        for (robot, action), destination in zip(deeds, destinations, strict=True):
            if action.at is not None:
                state = self.entity(action.at)
                state.used_until = max(state.used_until, start if action.open_ended else end)
            if action.is_somewhere:  # at a place that nobody knows it is somewhere unknown, too
                robot.spot, robot.stand = destination, self.number(destination)
            for name in action.brings:
                self.moves += 1
                brought = self.entity(name)
                brought.spot, brought.since = destination, end
