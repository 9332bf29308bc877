"""Alternatives tried out: their schedules, and how short these could be at best. Each is scheduled once."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

from missiontree.mission.alternative import Alternative, Choice
from missiontree.mission.brief import MissionBrief
from missiontree.mission.control import Control
from missiontree.mission.estimate import MICRO
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.mission.search_limit import SearchLimit
from missiontree.mission.ticks import TICKS_PER_S, ticks_within
from missiontree.scheduling.greedy import read_problem
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.scheduler import Scheduler
from missiontree.scheduling.serial import few_leaves

NEVER = 1 << 62
"""A tick that never comes."""
MOST_SCHEDULED = 200
LOOKED_AT = 25
"""Alternatives that are looked at, by their bounds alone, for each that may be scheduled."""
_SHARE = 0.25  # of the time that is left, for one schedule

Key = tuple[Choice, ...]


@dataclass(frozen=True, slots=True)
class Tried:
    """
    An alternative and what is known of its schedules.

    Parameters
    ----------
    alternative
        The alternative, its utility that of the mission's weights.
    utility
        The same in millionths.
    least
        Ticks below which none of its schedules is; ``NEVER`` if it is proven to have none.
    schedule
        The one that was found, if it was scheduled.
    makespan
        Its length in ticks; None if there is none.
    """

    alternative: Alternative
    utility: int
    least: int
    schedule: Schedule | None = None
    makespan: int | None = None

    @property
    def settled(self) -> bool:
        """Whether no shorter schedule of it can exist, or none at all."""
        return self.least == (NEVER if self.makespan is None else self.makespan)


class Trials:
    """
    All that was tried.

    Parameters
    ----------
    tree, brief, scene
        The mission.
    scheduler
        What makes schedules.
    control
        Limits of the whole work.
    most
        How many alternatives are scheduled at most.
    """

    def __init__(
        self,
        tree: GroundedTree,
        brief: MissionBrief,
        scene: Scene,
        scheduler: Scheduler,
        control: Control,
        most: int = MOST_SCHEDULED,
    ) -> None:
        self._tree, self._brief, self._scene = tree, brief, scene
        self._schedule_with, self._control, self._most = scheduler, control, most
        self._tried: dict[Key, Tried] = {}
        self._scheduled = 0

    def know(self, alternatives: Iterable[Alternative], schedules: Sequence[Schedule]) -> None:
        """Take in what was scheduled already."""
        by_rank = {schedule.rank: schedule for schedule in schedules}
        for alternative in alternatives:
            if alternative.rank in by_rank:
                known = self.least(alternative)
                self._keep(known, by_rank[alternative.rank])

    def least(self, alternative: Alternative) -> Tried:
        """The alternative with what its bounds say; and with its schedule, if it was scheduled before."""
        known = self._tried.get(alternative.choices)
        if known is None:
            known = Tried(alternative, round(alternative.utility * MICRO), self._bound(alternative))
            self._tried[alternative.choices] = known
        return known

    def scheduled(self, alternative: Alternative) -> Tried:
        """The alternative with its schedule."""
        known = self.least(alternative)
        if known.schedule is not None or known.least == NEVER:
            return known
        self._scheduled += 1
        schedule = self._schedule_with(
            self._tree, known.alternative, self._brief.fleet, self._scene, self._control.part(_SHARE), self._brief.terms
        )
        return self._keep(known, schedule)

    def limit(self) -> SearchLimit | None:
        """What forbids to go on; None if nothing does."""
        if (ended := self._control.ended_by()) is not None:
            return ended
        if self._scheduled >= self._most:
            return SearchLimit("candidates", self._most)
        most = self._most * LOOKED_AT
        return SearchLimit("candidates", most) if len(self._tried) >= most else None

    def __iter__(self) -> Iterator[Tried]:
        return iter(self._tried.values())

    def found(self) -> Iterator[Tried]:
        """Those with a schedule."""
        return (tried for tried in self._tried.values() if tried.makespan is not None)

    def _keep(self, known: Tried, schedule: Schedule) -> Tried:
        works = schedule.status in {"optimal", "feasible"}
        makespan = round(schedule.makespan_s * TICKS_PER_S) if works else None
        kept = replace(known, schedule=schedule, makespan=makespan, least=max(known.least, _least(schedule, makespan)))
        self._tried[known.alternative.choices] = kept
        return kept

    def _bound(self, alternative: Alternative) -> int:
        brief = self._brief
        if self._control.ended() and not few_leaves(self._tree, alternative):
            return 0  # nobody waits for more
        problem = read_problem(self._tree, alternative, brief.terms.team_of(brief.fleet), self._scene, brief.terms)
        return problem.bounds.makespan if isinstance(problem, Problem) else NEVER


def _least(schedule: Schedule, makespan: int | None) -> int:
    """What a schedule's certificate shows; a solver's word shows nothing."""
    if schedule.status == "infeasible":
        return NEVER
    certificate = schedule.certificate
    if schedule.status == "optimal" and makespan is not None:
        return makespan
    if certificate.claim not in {"proven", "bounded"} or certificate.bound is None:
        return 0
    return ticks_within(certificate.bound)
