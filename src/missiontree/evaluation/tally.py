"""How many missions of a suite an author got right, and in which ways it missed the others."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Protocol

from missiontree.evaluation.verdict import VERDICTS, VerdictKind
from missiontree.mission.value import Index, Value


@dataclass(frozen=True, slots=True, kw_only=True)
class Tally(Value):
    """
    Numbers of verdicts.

    Parameters
    ----------
    right, declined_though_possible, wrong_decline, wrong, no_answer
        See :class:`~missiontree.evaluation.verdict.Verdict`.
    """

    right: Index = 0
    declined_though_possible: Index = 0
    wrong_decline: Index = 0
    wrong: Index = 0
    no_answer: Index = 0

    @property
    def missions(self) -> int:
        """All of them."""
        return self.right + self.declined_though_possible + self.wrong_decline + self.wrong + self.no_answer


class Judged(Protocol):
    """Anything with a verdict's kind."""

    @property
    def kind(self) -> VerdictKind:
        """The kind."""
        ...


def tally(verdicts: Iterable[Judged]) -> Tally:
    """Count verdicts."""
    counted = Counter(verdict.kind for verdict in verdicts)
    return Tally(**{kind: counted[kind] for kind in VERDICTS})
