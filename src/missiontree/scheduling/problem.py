"""What a run of a scheduler is given, and what it comes to."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from missiontree.mission.fleet import Fleet
from missiontree.mission.reason import Reason
from missiontree.scheduling.bounds import Bounds
from missiontree.scheduling.bundles import Bundles
from missiontree.scheduling.chargers import NO_CHARGERS, Chargers, Station
from missiontree.scheduling.hand_overs import NO_HAND_OVERS, HandOvers
from missiontree.scheduling.places import Places
from missiontree.scheduling.precedence import TaskGraph
from missiontree.scheduling.room import Hold
from missiontree.scheduling.sharing import NOTHING_SHARED, Sharing
from missiontree.scheduling.staffing import Staffing
from missiontree.scheduling.trips import Trip, Trips

Filling = Literal["enough", "rest", "full"]
FILLINGS: tuple[Filling, ...] = ("enough", "rest", "full")
Crew = Literal["joint", "bundle", "none"]


@dataclass(frozen=True, slots=True)
class Problem:
    """
    One alternative, read once for all runs.

    Parameters
    ----------
    graph, staffing, bounds, fleet, trips, places
        What must be done, by whom, how long at least, the ways, and where actions can possibly happen.
    bundles, crews
        Roles that must be under way together, and roles that work jointly.
    needs
        What each group of roles uses of each budget at least.
    alike
        A number per role, equal for roles that ask the same of a robot.
    shared
        What all robots together may use, by name of the budget. Default: no such limit.
    required
        Robots each of which must fill a role. Default none.
    holds
        Ticks that each role holds its robot at least, a move at its beginning left out.
    leaving
        Whether some robot leaves before the end. Default false.
    sharing
        Shared resources that are scarce, and who holds them. Default none.
    returning
        Whether robots that take part go home in the end. Default false.
    home_by
        Tick by which all of them must be home; None (default) means no such deadline.
    hand_overs
        Who hands over to whom. Default nobody.
    chargers
        Where robots refill what they use up. Default: nowhere.
    """

    graph: TaskGraph
    staffing: Staffing
    bounds: Bounds
    fleet: Fleet
    trips: Trips
    places: Places
    bundles: Bundles
    crews: Mapping[int, int]
    needs: Mapping[int, Mapping[str, float]]
    alike: Mapping[int, int]
    shared: Mapping[str, float] = field(default_factory=dict)
    required: tuple[str, ...] = ()
    holds: Mapping[int, int] = field(default_factory=dict)
    leaving: bool = False
    sharing: Sharing = NOTHING_SHARED
    returning: bool = False
    home_by: int | None = None
    hand_overs: HandOvers = NO_HAND_OVERS
    chargers: Chargers = NO_CHARGERS


@dataclass(frozen=True, slots=True)
class Rule:
    """
    How one run decides.

    Parameters
    ----------
    crew
        Robots taken at once when a role begins: for the roles it works with ``joint``-ly, for its whole ``bundle`` (which then
        waits until all that it needs from outside is settled), or ``none`` but its own.
    patience
        Ticks that a robot may idle for the sake of a role with more to follow. 0 (default): the earliest start goes first.
    jitter
        Ticks by which an activity is taken to be due earlier than it is.
    binding
        Robot of each group of roles, if it is fixed beforehand.
    refill
        How robots refill: ``enough`` (default) for what comes next, for the ``rest`` of their roles where these are known, or until they
        are ``full``, and then always with a charger in reach.
    """

    crew: Crew = "joint"
    patience: int = 0
    jitter: Mapping[int, int] = field(default_factory=dict)
    binding: Mapping[int, str] = field(default_factory=dict)
    refill: Filling = "enough"


@dataclass(frozen=True, slots=True)
class Done:
    """An action put into the schedule (ticks), and the trip that it was or needed, with the trip's times."""

    leaf: int
    robot: str
    start: int
    end: int
    trip: Trip | None = None
    leaves_at: int = 0
    arrives_at: int = 0


@dataclass(frozen=True, slots=True)
class Refill:
    """A robot's visit to a charger: its way there, from when to when it refills (ticks), and how much."""

    robot: str
    station: Station
    trip: Trip
    leaves_at: int
    arrives_at: int
    start: int
    end: int
    amount: float

    @property
    def way_hold(self) -> Hold:
        """How long the robot holds what lies on its way there."""
        return Hold(self.leaves_at, self.arrives_at, 1)


@dataclass(frozen=True, slots=True)
class Homeward:
    """A robot's way home, from when to when (ticks)."""

    robot: str
    trip: Trip
    start: int
    end: int


@dataclass(slots=True)
class Draft:
    """What a run came to: all actions and ways home, or why it got stuck."""

    done: list[Done]
    robot_of: dict[int, str]
    makespan: int
    metres: float
    reasons: tuple[Reason, ...] = ()
    returns: list[Homeward] = field(default_factory=list)
    refills: list[Refill] = field(default_factory=list)

    @property
    def value(self) -> tuple[int, float, int]:
        """What is minimised: makespan, then travel, then the sum of ends."""
        return self.makespan, round(self.metres, 6), sum(done.end for done in self.done)
