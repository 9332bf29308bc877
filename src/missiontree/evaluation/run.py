"""One run of one mission by one model: what it came to, and what it took."""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.authoring.outcome import AuthoringStatus
from missiontree.evaluation.verdict import VerdictKind
from missiontree.mission.spent import Spent
from missiontree.mission.value import Count, Id, NonNegative, Value

Key = tuple[str, str, int, str]


@dataclass(frozen=True, kw_only=True)
class Run(Value):
    """
    A run and its verdict.

    Parameters
    ----------
    model
        Name of the model, as it was asked for.
    mission
        Id of the mission.
    number
        Which run of the mission by the model, from 1.
    digest
        Of all that the verdict depends on, see :meth:`missiontree.evaluation.suite.Suite.digest`.
    kind, status, score, differences
        See :class:`~missiontree.evaluation.verdict.Verdict`.
    reasons
        Why there is no plan, in the words that a person would be told.
    got
        The tree in the notation of suites; empty if there is none.
    fault
        Rule of the fault if the model could not be used, such as ``provider_timed_out``; else empty.
    seconds
        How long it took by the clock, waits included.
    spent
        What the dialogue took; None if no language model was asked.
    """

    model: str
    mission: Id
    number: Count
    digest: str
    kind: VerdictKind
    status: AuthoringStatus
    score: NonNegative
    differences: tuple[str, ...] = ()
    reasons: tuple[str, ...] = ()
    got: str = ""
    fault: str = ""
    seconds: NonNegative = 0.0
    spent: Spent | None = None

    def _check(self) -> None:
        if not self.model.strip():
            raise ValueError("the model has no name.")
        if self.score > 1:
            raise ValueError(f"score must be at most 1, got {self.score}.")

    @property
    def key(self) -> Key:
        """What tells runs apart: model, mission, number, and what was to be judged."""
        return self.model, self.mission, self.number, self.digest
