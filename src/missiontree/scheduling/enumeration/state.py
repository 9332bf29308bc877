"""What stands in a schedule under trial, small enough to be copied at every step."""

from __future__ import annotations

from dataclasses import dataclass, field

from missiontree.scheduling.trips import Spot


@dataclass(slots=True)
class State:
    """
    A schedule so far.

    Parameters
    ----------
    time, missing
        By event: when it is at the earliest, and how many events before it are still open.
    placed
        Activities in the order in which they were put down.
    robot_of
        Robot of each group of roles that has one.
    spot, free, role
        By robot: where it is, from when, and the role that holds it (-1 if none).
    things
        By entity: where it is, since when, until when it is needed there.
    left
        What is left of each budget, by whose and name; only of what is limited.
    starts
        When activities that are put down start.
    key
        Time up to which everything is decided, see :mod:`missiontree.scheduling.enumeration.trying`.
    """

    time: list[int]
    missing: list[int]
    robot_of: dict[int, int]
    spot: list[Spot]
    free: list[int]
    role: list[int]
    things: dict[str, tuple[Spot, int, int]]
    left: dict[tuple[str, str], float]
    placed: tuple[int, ...] = ()
    starts: dict[int, int] = field(default_factory=dict)
    key: int = 0

    def copy(self) -> State:
        """One that may go another way."""
        return State(
            self.time[:],
            self.missing[:],
            self.robot_of.copy(),
            self.spot[:],
            self.free[:],
            self.role[:],
            self.things.copy(),
            self.left.copy(),
            self.placed,
            self.starts.copy(),
            self.key,
        )
