"""What long work is given beside its data: how long it may take, who may stop it, whom to tell, and the clock."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace

from missiontree.mission.search_limit import SearchLimit

Clock = Callable[[], float]
StopToken = Callable[[], bool]


@dataclass(frozen=True, slots=True)
class Progress:
    """
    News of work under way.

    Parameters
    ----------
    stage
        ``allocation`` or ``scheduling``.
    done
        Candidates or actions done so far.
    found
        Results found so far.
    bound
        Best bound so far; None if there is none yet.
    best
        Value of the best result so far, to be held against the bound; None if there is none or it has no value. The gap is the
        difference of the two.
    """

    stage: str
    done: int
    found: int
    bound: float | None = None
    best: float | None = None


def never() -> bool:
    """The stop token that nobody pulls."""
    return False


def silent(progress: Progress) -> None:
    """The listener that does not listen."""


@dataclass(frozen=True, slots=True)
class Control:
    """
    Limits and listeners of one piece of long work.

    Parameters
    ----------
    time_limit_s
        Seconds the work may take from the birth of this object; None (default) means no limit.
    stop
        Asked now and then; once it answers true the work returns what it has.
    report
        Told of progress now and then.
    seed
        Seed of everything random. Default 0.
    clock
        Monotonic seconds.
    whole_limit_s
        The limit of the whole work, if this is the control of a part of it (:meth:`part`); None (default) if it is not.
    """

    time_limit_s: float | None = None
    stop: StopToken = never
    report: Callable[[Progress], None] = silent
    seed: int = 0
    clock: Clock = time.monotonic
    whole_limit_s: float | None = None
    started: float = field(init=False)

    def __post_init__(self) -> None:
        if self.time_limit_s is not None and not self.time_limit_s >= 0:
            raise ValueError(f"time_limit_s must be at least 0, got {self.time_limit_s}.")
        object.__setattr__(self, "started", self.clock())

    def ended(self) -> bool:
        """Whether to stop now, because of the limit or the token."""
        if self.stop():
            return True
        return self.time_limit_s is not None and self.clock() - self.started >= self.time_limit_s

    def ended_by(self) -> SearchLimit | None:
        """What ends the work now, as it was set for the whole of it; None if nothing does."""
        if not self.ended():
            return None
        if self.stop() or self.time_limit_s is None:
            return SearchLimit("stopped")
        return SearchLimit("time_s", self.time_limit_s if self.whole_limit_s is None else self.whole_limit_s)

    def part(self, share: float) -> Control:
        """The same control for one piece of the work, with that share of the time that is left."""
        return self._with(lambda left: left * share)

    def without(self, kept_s: float, most: float = 1.0) -> Control:
        """The same control with so many seconds less, which something else needs afterwards; at most that share of the time left."""
        return self._with(lambda left: left - min(kept_s, left * most))

    def _with(self, changed: Callable[[float], float]) -> Control:
        if self.time_limit_s is None:
            return self
        left = max(0.0, self.time_limit_s - (self.clock() - self.started))
        whole_s = self.time_limit_s if self.whole_limit_s is None else self.whole_limit_s
        return replace(self, time_limit_s=changed(left), whole_limit_s=whole_s)
