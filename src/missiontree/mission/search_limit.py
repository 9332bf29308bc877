"""What ended a search before it was done."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from missiontree.mission.value import NonNegative, Value

LimitKind = Literal["time_s", "stopped", "candidates", "nodes", "steps", "combinations"]

_IN_WORDS: dict[LimitKind, str] = {
    "time_s": "the time limit of {} s",
    "stopped": "a stop that was asked for",
    "candidates": "the limit of {} candidates",
    "nodes": "the limit of {} nodes of the search",
    "steps": "the limit of {} steps for one candidate",
    "combinations": "the limit of {} combinations",
}


@dataclass(frozen=True, slots=True)
class SearchLimit(Value):
    """
    The limit that ended a search, as it was set, whatever the clock said then.

    Parameters
    ----------
    kind
        ``time_s``: the time limit of the whole work, in seconds. ``stopped``: somebody said stop. ``candidates``: alternatives looked
        at. ``nodes``: nodes of branch and bound. ``steps``: what may be tried to tell whether robots can fill one alternative.
        ``combinations``: of one AND, in the printed form of the paper's algorithm.
    most
        How much was allowed, at least 0; None if nobody set a number.
    """

    kind: LimitKind
    most: NonNegative | None = None

    def _check(self) -> None:
        if (self.most is None) != (self.kind == "stopped"):
            raise ValueError(
                f"a search limit of kind {self.kind!r} {'has no' if self.most is not None else 'needs a'} number."
            )

    @property
    def in_words(self) -> str:
        """The limit as a phrase: "the time limit of 10 s"."""
        return _IN_WORDS[self.kind].format("" if self.most is None else f"{self.most:,.12g}")
