"""The robots of a fleet by number, so that a schedule under trial is lists and no dictionaries of names."""

from __future__ import annotations

from missiontree.mission.ticks import ticks, ticks_within
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.trips import Spot


class Robots:
    """
    What is known of robots beforehand.

    Parameters
    ----------
    problem
        The alternative.

    Attributes
    ----------
    names, kind, homes, since, until
        By number: its name, the name of its type, where it starts, and from when and until when it is there, in ticks; None if it stays.
    alike
        By number: what is equal for robots that are equal in every respect.
    of_kind
        Numbers of the robots of each type.
    """

    def __init__(self, problem: Problem) -> None:
        self.names: list[str] = []
        self.kind: list[str] = []
        self.alike: list[object] = []
        self.homes: list[Spot] = []
        self.since: list[int] = []
        self.until: list[int | None] = []
        self.of_kind: dict[str, list[int]] = {}
        for kind in problem.fleet.types:
            for robot, start in zip(kind.members, problem.trips.starts(kind.id), strict=True):
                self.of_kind.setdefault(kind.id, []).append(len(self.names))
                named = robot.id if robot.id in problem.required else ""
                since_s, until_s = kind.availability(robot)
                self.names.append(robot.id)
                self.kind.append(kind.id)
                self.homes.append(start)
                self.alike.append((kind.id, start, tuple(sorted(robot.remaining.items())), named, (since_s, until_s)))
                self.since.append(ticks(since_s))
                self.until.append(None if until_s is None else ticks_within(until_s))
