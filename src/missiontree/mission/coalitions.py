"""Tasks for coalitions: robots with skills, tasks in places that need several of them at once, and a place where all end up."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from math import ceil, hypot

from missiontree.mission.certificate import Certificate
from missiontree.mission.schedule import ScheduleStatus
from missiontree.mission.value import Index, NonNegative, Value

MOST_TASKS = 200
MOST_COALITION_ROBOTS = 12
TICKS_PER_S = 1000


@dataclass(frozen=True, slots=True, kw_only=True)
class CoalitionTask(Value):
    """
    A task.

    Parameters
    ----------
    needs
        Skills, by index, that whoever does it must have together.
    duration_s
        How long it takes, at least 0; all of its robots are there throughout.
    x_m, y_m
        Where it is done.
    """

    needs: tuple[Index, ...]
    duration_s: NonNegative
    x_m: float
    y_m: float


@dataclass(frozen=True, kw_only=True)
class CoalitionMission(Value):
    """
    A mission of such tasks. Every robot begins at the start and gets to the end in the end, in straight lines, at one metre a second.

    Parameters
    ----------
    skills
        Skills of each robot, by index; at most 12 robots.
    tasks
        At most 200.
    start, end
        Where all robots begin, and where all get to.
    precedence
        (before, after): pairs of tasks by index, in an order that can be kept.
    reference_s
        Makespan that somebody else published; None if nobody did. It is shown beside ours and decides nothing.
    """

    skills: tuple[tuple[Index, ...], ...]
    tasks: tuple[CoalitionTask, ...]
    start: tuple[float, float]
    end: tuple[float, float]
    precedence: tuple[tuple[int, int], ...] = ()
    reference_s: float | None = None

    def _check(self) -> None:
        if not 1 <= len(self.skills) <= MOST_COALITION_ROBOTS:
            raise ValueError(f"{len(self.skills)} robots; there may be 1 to {MOST_COALITION_ROBOTS}.")
        if len(self.tasks) > MOST_TASKS:
            raise ValueError(f"{len(self.tasks)} tasks; there may be at most {MOST_TASKS}.")
        for pair in self.precedence:
            if not all(0 <= task < len(self.tasks) for task in pair):
                raise ValueError(f"a precedence names the tasks {pair}; there are {len(self.tasks)}.")

    @cached_property
    def coalitions(self) -> tuple[tuple[tuple[int, ...], ...], ...]:
        """
        For each task, the coalitions that cover it and could spare nobody, smaller ones first.

        No other is ever needed: whoever could be spared may stay away, and, ways being straight, is nowhere later for that.
        """
        return tuple(tuple(self._minimal(frozenset(task.needs))) for task in self.tasks)

    def _minimal(self, needed: frozenset[int]) -> Iterator[tuple[int, ...]]:
        robots = range(len(self.skills))
        if not needed:  # somebody must do it, whoever it is
            yield from ((robot,) for robot in robots)
            return
        found: list[frozenset[int]] = []
        for size in range(1, len(self.skills) + 1):
            for members in combinations(robots, size):
                together = frozenset(members)
                covers = needed <= {skill for robot in members for skill in self.skills[robot]}
                if covers and not any(smaller <= together for smaller in found):
                    found.append(together)
                    yield members

    @cached_property
    def travel(self) -> tuple[tuple[int, ...], ...]:
        """Ticks of 1 ms, rounded up, from each place to each: the tasks by index, then the start, then the end."""
        spots = [(task.x_m, task.y_m) for task in self.tasks] + [self.start, self.end]
        return tuple(tuple(ticks_of(hypot(x - u, y - v)) for u, v in spots) for x, y in spots)

    @cached_property
    def lengths(self) -> tuple[int, ...]:
        """Ticks that each task takes."""
        return tuple(ticks_of(task.duration_s) for task in self.tasks)


def ticks_of(seconds: float) -> int:
    """Seconds, or metres at one a second, in ticks of 1 ms, rounded up; float noise above a whole tick is none."""
    return ceil(seconds * TICKS_PER_S - 1e-6)


@dataclass(frozen=True, slots=True, kw_only=True)
class Visit(Value):
    """
    A task done.

    Parameters
    ----------
    task
        By index.
    robots
        Who does it.
    start_s, end_s
        From when to when.
    """

    task: Index
    robots: tuple[Index, ...]
    start_s: NonNegative
    end_s: NonNegative


@dataclass(frozen=True, slots=True, kw_only=True)
class CoalitionSchedule(Value):
    """
    Who does what when.

    Parameters
    ----------
    status
        ``optimal``: proven that nothing is shorter. ``feasible``: this works. ``infeasible``: proven that nothing does.
        ``unknown``: none was found, none is excluded.
    certificate
        The bound on the makespan, and the method.
    visits
        By start, then by task.
    arrivals_s
        When each robot is at the end.
    makespan_s
        When the last one is.
    """

    status: ScheduleStatus
    certificate: Certificate
    visits: tuple[Visit, ...] = ()
    arrivals_s: tuple[NonNegative, ...] = ()
    makespan_s: NonNegative = 0.0
