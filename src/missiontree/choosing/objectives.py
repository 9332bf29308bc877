"""What an objective of utility and makespan chooses, and what is proven of the choice."""

from __future__ import annotations

from missiontree.choosing.drawing import Draws
from missiontree.choosing.fronts import METHOD, may_beat, option_of, order, probe
from missiontree.choosing.trying import NEVER, Trials, Tried
from missiontree.choosing.walking import Walk, step, walk
from missiontree.mission.certificate import Certificate
from missiontree.mission.estimate import MICRO
from missiontree.mission.front import Chosen
from missiontree.mission.ticks import seconds

MOST_EQUALS = 16
"""Alternatives of the same utility that are held against each other by travel and ends."""


def fastest(draws: Draws, trials: Trials) -> Chosen | None:
    """
    The fastest alternative, and of equally fast ones the best; None if nothing has a schedule.

    What is fast by allocation's bounds is tried first. Then the walk goes on from the fastest found, and at last the best alternative is
    sought that is as fast.
    """
    probe(draws, trials)
    so_far = min((tried.makespan for tried in trials.found() if tried.makespan is not None), default=None)
    faster = walk(draws, trials, so_far)
    least = min((tried.makespan for tried in trials.found() if tried.makespan is not None), default=None)
    if least is None:
        return None

    def best() -> Tried:
        return min((tried for tried in trials.found() if tried.makespan == least), key=order)

    as_fast = Walk()
    step(as_fast, draws, trials, least, lambda utility: utility <= best().utility)
    chosen = best()
    bound = min([least, *(one.least for one in trials if not one.settled)])
    if not (faster.whole and faster.orderly):
        bound = min(bound, draws.soonest())
    beaten = any(may_beat(one, chosen) for one in trials if one is not chosen)
    in_order = as_fast.limit is None and as_fast.orderly
    if bound == least and in_order and chosen.settled and not beaten:
        detail = "No alternative has a shorter schedule, and none of a higher utility one as short."
        return _chosen(chosen, Certificate(claim="proven", method=METHOD, bound=seconds(least), detail=detail))
    detail = (
        "No alternative is faster; one of a higher utility may be as fast."
        if bound == least
        else "Some alternative may be faster."
    )
    limit = faster.limit or as_fast.limit
    return _chosen(
        chosen, Certificate(claim="bounded", method=METHOD, bound=seconds(bound), detail=detail, limit=limit)
    )


def best_then_fastest(draws: Draws, trials: Trials) -> Chosen | None:
    """The best utility that has a schedule, of these the fastest, then the tidiest; None if nothing has a schedule."""

    def best() -> int | None:
        return max((tried.utility for tried in trials.found()), default=None)

    def over(utility: int) -> bool:
        found = best()
        return found is not None and utility < found

    walked = walk(draws, trials, stop=over)
    utility = best()
    if utility is None:
        return None
    _try_equals(draws, trials, utility)
    chosen = min((tried for tried in trials.found() if tried.utility == utility), key=order)
    equals = [one.least for one in trials if one.utility == utility and one.least != NEVER]
    higher = [one for one in trials if one.utility > utility and one.least != NEVER]
    done = walked.whole or (walked.limit is None and walked.orderly)
    if done and not higher and chosen.settled and min(equals) == chosen.makespan:
        detail = (
            "No alternative of a higher utility has a schedule, and none of this one a shorter schedule. "
            "Of equally short ones it has the least travel, then the least sum of ends, of those found."
        )
        bound = seconds(chosen.makespan)
        return _chosen(chosen, Certificate(claim="proven", method=METHOD, bound=bound, detail=detail))
    detail = "It was found; something of this utility may be shorter, or something better may have a schedule."
    return _chosen(chosen, Certificate(claim="unproven", method=METHOD, detail=detail, limit=walked.limit))


def _try_equals(draws: Draws, trials: Trials, utility: int) -> None:
    """Schedule what has that utility and may be as short as the shortest of it: among equals travel and ends decide."""
    shortest = min(
        tried.makespan for tried in trials.found() if tried.utility == utility and tried.makespan is not None
    )
    for number, alternative in enumerate(draws.under(shortest)):
        below = round(alternative.utility * MICRO) < utility
        if below or number >= MOST_EQUALS or trials.limit() is not None:
            return
        if trials.least(alternative).least <= shortest:
            trials.scheduled(alternative)


def _chosen(tried: Tried, certificate: Certificate) -> Chosen:
    assert tried.schedule is not None
    return Chosen(option=option_of(tried, 1, certificate), worth=tried.schedule.makespan_s)
