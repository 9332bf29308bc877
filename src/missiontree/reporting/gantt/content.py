"""What a Gantt chart shows, before anything is placed: rows of robots, their roles, actions, ways and waits, and what joins them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from missiontree.mission.chain import Step
from missiontree.reporting.palette import Livery


class Bar(NamedTuple):
    """An action, or several too short to tell apart (``many`` above 1)."""

    leaf: int
    start_s: float
    end_s: float
    label: str
    way: str
    moves: bool
    lit: bool
    title: str
    many: int = 1


class Stretch(NamedTuple):
    """A way to an action or home, labelled with its metres; a wait, with its reason; or a role, from its first action to its last."""

    start_s: float
    end_s: float
    label: str
    title: str
    lit: bool = False


class Due(NamedTuple):
    """A deadline that something in a row has, with what it is of."""

    time_s: float
    title: str


@dataclass(frozen=True, slots=True)
class Row:
    """One robot: name, type, looks, what it does, its deadlines, when it takes no part, and visits to chargers; lists in order of time."""

    robot: str
    kind: str
    livery: Livery
    bars: Sequence[Bar]
    ways: Sequence[Stretch]
    waits: Sequence[Stretch]
    roles: Sequence[Stretch]
    dues: Sequence[Due] = ()
    away: Sequence[Stretch] = ()
    refills: Sequence[Stretch] = ()


class Order(NamedTuple):
    """
    An action that waits for the end of another, drawn as an arrow.

    Parameters
    ----------
    first, second
        Leaves.
    lit
        The critical chain runs along it.
    to_end
        It is the end of the second, not its start, that waits.
    """

    first: int
    second: int
    lit: bool = False
    to_end: bool = False


class Hold(NamedTuple):
    """A robot that holds a shared resource, how it looks, and in which line of the resource's row that is told."""

    start_s: float
    end_s: float
    robot: str
    livery: Livery
    lane: int
    title: str


@dataclass(frozen=True, slots=True)
class SharedRow:
    """A shared resource: its name, how many robots it has room for, how many hold it at once at most, and who does when."""

    name: str
    capacity: int
    lanes: int
    holds: Sequence[Hold]


@dataclass(frozen=True, slots=True)
class Content:
    """
    Everything in a chart.

    Parameters
    ----------
    rows
        Robots that do something, in the order of the fleet.
    idle
        Robots that do nothing.
    makespan_s
        When everything is over, ways home included.
    chain
        The critical chain.
    orders
        Precedence between robots, and where the chain goes from robot to robot.
    joint
        Actions that start and end together.
    deadline_s
        By when the mission must have ended; None (default) means no deadline.
    shared
        Shared resources that are held, in the order of the scene. Default: none.
    times
        By leaf: the release time of what begins with it and the deadline of what ends with it, in words. Default: none.
    handing
        By leaf that hands over or takes over: to whom, or from whom, in words. Default: none.
    """

    rows: Sequence[Row]
    idle: Sequence[str]
    makespan_s: float
    chain: Sequence[Step]
    orders: Sequence[Order]
    joint: Sequence[Sequence[int]]
    deadline_s: float | None = None
    shared: Sequence[SharedRow] = ()
    handing: Mapping[int, str] = field(default_factory=dict)
    times: Mapping[int, str] = field(default_factory=dict)
