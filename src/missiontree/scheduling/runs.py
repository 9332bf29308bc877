"""Runs of serial schedule generation by one rule after the other, and the best draft of them."""

from __future__ import annotations

from missiontree.mission.alternative import Alternative
from missiontree.mission.control import Control, Progress
from missiontree.mission.reason import Reason
from missiontree.mission.ticks import seconds
from missiontree.scheduling.availability import away
from missiontree.scheduling.course import along, tours_of
from missiontree.scheduling.deadlines import Late, deadlines_missed
from missiontree.scheduling.meeting import apart
from missiontree.scheduling.mission_terms import terms_broken
from missiontree.scheduling.neighbourhood.stops import stops_of
from missiontree.scheduling.problem import Draft, Problem, Rule
from missiontree.scheduling.replay import replay
from missiontree.scheduling.rules import rules
from missiontree.scheduling.serial import Run
from missiontree.scheduling.writing import TIME_IS_UP

MIN_RUNS, MAX_RUNS = 3, 40
LEAVES_PER_CALL = 20_000  # work that retries may cost, in scheduled leaves
ROBOTS_PER_CALL = 1_500_000  # the same, in robots looked at for a role


class Runs:
    """
    Runs over one problem.

    Parameters
    ----------
    problem, alternative
        What is scheduled.
    control
        Limits of the first run, and of all until some draft is found.
    more
        Limits of further runs. Default: the same.
    most
        How many runs there may be, those that only find a first draft left out. Default 40.

    Attributes
    ----------
    best
        The best draft so far; whoever has a better one may put it there.
    """

    def __init__(
        self,
        problem: Problem,
        alternative: Alternative,
        control: Control,
        more: Control | None = None,
        most: int = MAX_RUNS,
    ) -> None:
        self.problem = problem
        self.best: Draft | None = None
        self._control, self._more = control, control if more is None else more
        self._most = max(MIN_RUNS, min(most, LEAVES_PER_CALL // max(1, len(problem.graph.activity_of))))
        self._rules = rules(problem, alternative, self._most, control.seed)
        self._failures: dict[Reason, None] = {}
        self._late: Late | None = None
        self._number = self._looked = 0
        self._stopped = False

    @property
    def failures(self) -> list[Reason]:
        """Why runs got stuck, and how far the best of those that were late was from being in time."""
        first = [TIME_IS_UP] if self._stopped else []
        return [*first, *(self._late.reasons if self._late else ()), *self._failures]

    @property
    def shortest(self) -> bool:
        """Whether the best is as short as a lower bound."""
        return self.best is not None and self.best.makespan == self.problem.bounds.makespan

    def go(self, most: int, in_vain: int | None = None, anyway: bool = False) -> None:
        """
        Go on until so many runs were made, or more if none came to a draft.

        Parameters
        ----------
        most
            Runs in all.
        in_vain
            So many further runs in a row that find nothing better are enough. Default: no number is.
        anyway
            Whether so many runs are enough even if none came to a draft. Default false.
        """
        vain = 0
        while not self._stopped:
            if (self.best is not None or anyway) and (self._unbeatable() or self._enough(most) or vain == in_vain):
                return
            rule = next(self._rules, None)
            if rule is None:
                return
            before = self.best
            self._run(rule)
            vain = vain + 1 if self.best is before else 0

    def refill_for_tours(self) -> None:
        """Where robots refill, and tours say all: play the best through again, now that it is known what each of them will do."""
        if self.best is None or not self.problem.chargers or self._control.ended() or stops_of(self.problem) is None:
            return
        played = replay(self.problem, along(tours_of(self.best, self.problem.graph)))
        if played is not None and played.value < self.best.value:
            self.best = played
            self.tell()

    def _run(self, rule: Rule) -> None:
        run, problem = Run(self.problem, rule), self.problem
        limits = self._control if self.best is None else self._more
        draft = None if self._number and limits.ended() else run(limits.ended)
        if draft is None:
            self._stopped = True
            return
        self._number += 1
        self._looked += run.looked
        if reasons := (
            draft.reasons or terms_broken(problem, draft.robot_of) or away(problem, draft) or apart(problem, draft)
        ):
            self._failures.update(dict.fromkeys(reasons))
        elif (missed := deadlines_missed(problem, draft)) is not None:
            self._late = missed if self._late is None else min(self._late, missed)
        elif self.best is None or draft.value < self.best.value:
            self.best = draft
        self.tell()

    def tell(self) -> None:
        """Report how far the runs are."""
        problem = self.problem
        shown = None if self.best is None else seconds(self.best.makespan)
        bound = seconds(problem.bounds.makespan)
        self._control.report(Progress("scheduling", self._number, int(self.best is not None), bound, shown))

    def _enough(self, most: int) -> bool:
        """Whether the runs so far are enough; time plays no part, so the answer is always the same."""
        most = max(MIN_RUNS, min(most, self._most))
        return self._number >= most or (self._number >= MIN_RUNS and self._looked >= ROBOTS_PER_CALL)

    def _unbeatable(self) -> bool:
        return self.best is not None and self.shortest and self.best.metres == 0
