"""What is known at any moment of the search, and what is claimed of it in the end."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.mission.certificate import Certificate
from missiontree.mission.tree_schedule import TreeSchedule, TreeScheduleStatus
from missiontree.scheduling.joint.listing import Listed

DETAILS = {
    "critical_path": "Some path through the tree takes as long, whichever ways are taken.",
    "load": "Some robots have as much to do, whichever ways are taken.",
    "second_formulation": "Two models of different form agree that nothing is shorter.",
}


@dataclass
class Known:
    """
    What is known so far.

    Parameters
    ----------
    best
        The best schedule.
    bound, method
        Of missiontree's own, and how it came about: one of :data:`DETAILS`.
    word
        A bound by the word of the solver alone.
    """

    best: Listed
    bound: int
    method: str = "critical_path"
    word: int = 0

    @property
    def closed(self) -> bool:
        """Whether the best meets the bound."""
        return self.best.makespan <= self.bound

    def offer(self, one: Listed) -> None:
        """A further schedule."""
        if one.makespan < self.best.makespan:
            self.best = one

    def raise_bound(self, bound: int, method: str) -> None:
        """A further bound."""
        if bound > self.bound:
            self.bound, self.method = bound, method

    def told(self) -> TreeSchedule:
        """The answer, with no more claimed than is known."""
        best, makespan = self.best, self.best.makespan
        status: TreeScheduleStatus = "optimal" if self.closed else "feasible"
        return TreeSchedule(status, self._certificate(), best.chosen, best.start, best.robot, makespan)

    def _certificate(self) -> Certificate:
        if self.closed or self.word <= self.bound:
            bound = min(self.bound, self.best.makespan)
            return Certificate(
                claim="proven" if self.closed else "bounded",
                method=self.method,
                bound=float(bound),
                detail=DETAILS[self.method],
            )
        bound = min(self.word, self.best.makespan)
        said = "By the solver's word; no bound of missiontree's own and no second method confirms it."
        return Certificate(claim="solver_word", method="cp_sat", bound=float(bound), detail=said)
