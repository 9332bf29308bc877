"""The utility-makespan front: what is found, what of it is listed, and what is proven."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from missiontree.choosing.drawing import Draws
from missiontree.choosing.trying import NEVER, Trials, Tried
from missiontree.choosing.walking import Walk, walk
from missiontree.mission.as_ranking import OPTION
from missiontree.mission.certificate import Certificate
from missiontree.mission.front import Front, Option

METHOD = "epsilon_constraint"
MOST_OPTIONS = 7
_PROBES = 4


def front_of(draws: Draws, trials: Trials) -> Front | None:
    """
    Seek the front.

    Parameters
    ----------
    draws, trials
        Where alternatives come from, and where they are scheduled.

    Returns
    -------
    Front or None
        None if nothing has a schedule.
    """
    probe(draws, trials)
    walked = walk(draws, trials)
    found = undominated(trials.found())
    if not found:
        return None
    proven = [_proven(tried, walked, trials) for tried in found]
    whole = walked.whole and all(proven) and all(_covered(one, found) for one in trials if not one.settled)
    kept = handful([tried.makespan or 0 for tried in found], MOST_OPTIONS)
    options = tuple(
        option_of(found[place], rank, _of_option(proven[place])) for rank, place in enumerate(kept, start=1)
    )
    return Front(options=options, found=len(found), certificate=_of_front(whole, walked))


def probe(draws: Draws, trials: Trials) -> None:
    """Try the best alternative under each of some deadlines, so that even a search that is cut short sees both ends."""
    longest = max((tried.makespan or 0 for tried in trials.found()), default=0)
    soonest = draws.soonest() if longest else 0
    for number in range(_PROBES):
        if trials.limit() is not None or soonest >= longest:
            return
        deadline = soonest + (longest - soonest) * number // _PROBES
        for alternative in draws.under(deadline):
            trials.scheduled(alternative)
            break


def undominated(found: Iterable[Tried]) -> list[Tried]:
    """Those that no other beats in utility and makespan, by falling utility; of equals in both the tidiest."""
    kept: list[Tried] = []
    for tried in sorted(found, key=order):
        assert tried.makespan is not None
        if not kept or tried.makespan < (kept[-1].makespan or 0):
            kept.append(tried)
    return kept


def order(tried: Tried) -> tuple[object, ...]:
    """By falling utility, then makespan, then travel, then sum of ends, then choices."""
    choices = tuple(choice.child for choice in tried.alternative.choices)
    return -tried.utility, tried.makespan, *tidiness(tried), choices


def tidiness(tried: Tried) -> tuple[int, int]:
    """Millimetres of travel, and the sum of all ends in ticks."""
    schedule = tried.schedule
    assert schedule is not None
    metres = sum(leg.distance_m for leg in schedule.ways)
    return round(metres * 1000), sum(round(done.end_s * 1000) for done in schedule.actions)


def handful(makespans: Sequence[int], most: int) -> list[int]:
    """Places of at most so many: both ends, and those nearest to equal steps of makespan between them."""
    count = len(makespans)
    if count <= most:
        return list(range(count))
    first, last = makespans[0], makespans[-1]
    kept = {0, count - 1}
    for step in range(1, most - 1):
        wanted = first + (last - first) * step / (most - 1)
        left = [place for place in range(count) if place not in kept]
        kept.add(min(left, key=lambda place: (abs(makespans[place] - wanted), place)))
    return sorted(kept)


def option_of(tried: Tried, rank: int, certificate: Certificate) -> Option:
    """What was tried, as an option of that rank."""
    assert tried.schedule is not None
    own = Certificate(
        claim="unproven", method=OPTION, detail="Its rank is its place among these options, not among all alternatives."
    )
    return Option(
        alternative=replace(tried.alternative, rank=rank, certificate=own),
        schedule=replace(tried.schedule, rank=rank),
        certificate=certificate,
    )


def may_beat(one: Tried, tried: Tried) -> bool:
    """Whether an alternative may have a schedule that beats another's in utility or makespan and is no worse in the other."""
    assert tried.makespan is not None
    better = one.utility > tried.utility and one.least <= tried.makespan
    return better or (one.utility >= tried.utility and one.least < tried.makespan)


def _proven(tried: Tried, walked: Walk, trials: Trials) -> bool:
    """Whether nobody beats it: nobody who was tried, and nobody who was not."""
    steps = [(step.utility, step.makespan) for step in walked.steps]
    if not walked.orderly or (tried.utility, tried.makespan) not in steps:
        return False
    last = (tried.utility, tried.makespan) == steps[-1]
    passed = not last or walked.passed(tried.utility)
    return passed and tried.settled and not any(may_beat(one, tried) for one in trials if one is not tried)


def _covered(one: Tried, found: Sequence[Tried]) -> bool:
    """Whether what may still be found of an alternative is no better than something that was found."""
    if one.least == NEVER:
        return True
    return any(tried.utility >= one.utility and (tried.makespan or 0) <= one.least for tried in found)


def _of_option(proven: bool) -> Certificate:
    if proven:
        detail = "Nothing of at least this utility is shorter, and nothing of a higher utility is as short."
        return Certificate(claim="proven", method=METHOD, detail=detail)
    return Certificate(claim="unproven", method=METHOD, detail="It was found; something may be better in both.")


def _of_front(whole: bool, walked: Walk) -> Certificate:
    if whole:
        return Certificate(claim="proven", method=METHOD, detail="There is no option beyond those found.")
    detail = (
        "There may be options beyond those found: the search was ended early."
        if walked.limit is not None
        else "There may be options beyond those found: of some alternatives it is not known how short they can be."
    )
    return Certificate(claim="unproven", method=METHOD, detail=detail, limit=walked.limit)
