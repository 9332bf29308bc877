"""
From one end of the utility-makespan front to the other: the best alternative that could be faster than the last, again and again.

This is the epsilon-constraint method (Haimes, Lasdon and Wismer, "On a bicriterion formulation of the problems of integrated system
identification and system optimization", 1971): utility is made as large as it can be under a deadline, and the deadline is a tick less
than the fastest schedule so far. Allocation keeps the deadline by lower bounds, so that what it draws may turn out slower; that is seen
when it is scheduled, and the next is drawn.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from missiontree.choosing.drawing import Draws
from missiontree.choosing.trying import Trials, Tried
from missiontree.mission.estimate import MICRO
from missiontree.mission.search_limit import SearchLimit


@dataclass(slots=True)
class Walk:
    """
    How far a walk came.

    Parameters
    ----------
    steps
        What was found, each faster than the one before.
    whole
        Nobody who was not tried is faster than the last step, proven.
    reached
        Utility, in millionths, of what was drawn last after the last step; whoever is better was tried, or is not faster than it. None if
        nothing was drawn since.
    limit
        What ended the walk; None if it came to its end, or was told to stop.
    orderly
        Whether everything was drawn in its proven order.
    """

    steps: list[Tried] = field(default_factory=list)
    whole: bool = False
    reached: int | None = None
    limit: SearchLimit | None = None
    orderly: bool = True

    def passed(self, utility: int) -> bool:
        """Whether everybody of that utility who is faster than the last step was tried."""
        return self.whole or (self.reached is not None and self.reached < utility)


def never(utility: int) -> bool:
    """Go on to the end."""
    return False


def walk(draws: Draws, trials: Trials, below: int | None = None, stop: Callable[[int], bool] = never) -> Walk:
    """
    Go from better to faster.

    Parameters
    ----------
    draws, trials
        Where alternatives come from, and where they are scheduled.
    below
        Only what is shorter than so many ticks counts as a step. Default: everything that has a schedule.
    stop
        Told the utility of what is drawn, in millionths; whether to stop there.
    """
    walked = Walk()
    deadline = None if below is None else below - 1
    while True:
        found = step(walked, draws, trials, deadline, stop)
        if found is None:
            return walked
        assert found.makespan is not None
        deadline = found.makespan - 1


def step(
    walked: Walk, draws: Draws, trials: Trials, deadline: int | None, stop: Callable[[int], bool] = never
) -> Tried | None:
    """The best alternative that is found to be done by the deadline, a step more; None if there is none, or the walk ends."""
    line, walked.reached = draws.under(deadline), None
    for alternative in line:
        if (limit := trials.limit()) is not None:
            walked.limit = limit
            return None
        walked.orderly &= alternative.certificate.claim == "proven"  # what a search that was ended adds is in no order
        if walked.orderly:
            walked.reached = round(alternative.utility * MICRO)
            if stop(walked.reached):
                return None
        tried = trials.least(alternative)
        if deadline is not None and tried.least > deadline:
            continue
        tried = trials.scheduled(alternative)
        if tried.makespan is not None and (deadline is None or tried.makespan <= deadline):
            walked.steps.append(tried)
            return tried
    walked.whole, walked.limit = line.whole, line.limit
    return None
