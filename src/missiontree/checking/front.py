"""Is the front a front, and is no more claimed of it than is shown?"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from missiontree.checking.case import Case
from missiontree.checking.clock import shown
from missiontree.checking.fault import Fault
from missiontree.checking.merits import Merit, listed, may_beat, merit_of
from missiontree.checking.methods import CHOICE_PROOFS
from missiontree.mission.front import Front

HANDFUL = 7
"""Options that a front lists at most."""


def _merits(front: Front) -> list[Merit]:
    return [merit_of(option.alternative, option.schedule) for option in front.options]


def front_uncalled(case: Case) -> Iterator[Fault]:
    """There is a front of a mission that is not delivered, or an empty one."""
    front = case.plan.front
    if front is not None and (case.plan.outcome != "delivered" or not front.options):
        yield Fault("there is a front, and nothing to be on it.", found="a front", needed="none")


def front_dominated(case: Case) -> Iterator[Fault]:
    """An option has no schedule; or an option is beaten by another, or by a listed alternative, or stands in the wrong place."""
    front = case.plan.front
    if front is None:
        return
    options = _merits(front)
    for one in options:
        if one.makespan is None:
            yield Fault(
                f"option {one.alternative.rank} of the front has no schedule.",
                found=one.schedule.status,
                needed="a schedule",
            )
    for above, below in pairwise(options):
        if not (above.utility > below.utility and (above.makespan or 0) > (below.makespan or 0)):
            yield Fault(
                f"options {above.alternative.rank} and {below.alternative.rank} of the front are not the better and the faster: "
                f"{_shown(above)}, then {_shown(below)}.",
                found=_shown(below),
                needed="less utility, less time",
            )
    for other in listed(case.plan):
        for one in options:
            if other.makespan is not None and one.makespan is not None and _beats(other, one):
                yield Fault(
                    f"option {one.alternative.rank} of the front ({_shown(one)}) is beaten by alternative "
                    f"{other.alternative.rank} ({_shown(other)}).",
                    found=_shown(one),
                    needed="an option that nothing beats",
                )


def front_incomplete(case: Case) -> Iterator[Fault]:
    """Options are left out of the front that the plan itself knows of, or of so few that all could be listed; or their number is wrong."""
    front = case.plan.front
    if front is None:
        return
    count = len(front.options)
    if front.found < count or (front.found > count and count != HANDFUL):
        yield Fault(
            f"the front lists {count} of {front.found} options.", found=str(count), needed=f"all, or {HANDFUL} of more"
        )
    options = [one for one in _merits(front) if one.makespan is not None]
    for other in listed(case.plan) if front.found == count else ():
        if other.makespan is not None and not any(_covers(one, other) for one in options):
            yield Fault(
                f"alternative {other.alternative.rank} ({_shown(other)}) is as good as the front, and not on it.",
                found="not on the front",
                needed=_shown(other),
            )


def front_claim_unfounded(case: Case) -> Iterator[Fault]:
    """A front or an option of it is called proven, and the plan itself shows that it is not; or by a method that nobody documents."""
    front = case.plan.front
    if front is None:
        return
    for about, certificate in (
        ("the front", front.certificate),
        *((_named(o.alternative.rank), o.certificate) for o in front.options),
    ):
        if certificate.claim not in {"proven", "unproven"} or certificate.method not in CHOICE_PROOFS:
            found = f"{certificate.claim}, {certificate.method}"
            yield Fault(
                f"what is claimed of {about} is {certificate.claim} by {certificate.method}.",
                found=found,
                needed=f"proven or unproven, by {' or '.join(sorted(CHOICE_PROOFS))}",
            )
    whole = front.certificate.claim == "proven"
    if whole and front.certificate.limit is not None:
        yield Fault("the front is proven, and its search was ended early.", found=front.certificate.limit.in_words)
    for option, merit in zip(front.options, _merits(front), strict=True):
        proven = option.certificate.claim == "proven"
        if whole and not proven:
            yield Fault(f"the front is proven, and {_named(option.alternative.rank)} is not.", needed="proven")
        if proven and option.schedule.status != "optimal":
            yield Fault(
                f"{_named(option.alternative.rank)} is proven, and its schedule is {option.schedule.status}.",
                found=option.schedule.status,
                needed="optimal",
            )
        rivals = [other for other in listed(case.plan) if proven and may_beat(other, merit)]
        for other in rivals[:1]:
            yield Fault(
                f"{_named(option.alternative.rank)} is proven, and alternative {other.alternative.rank} may be better in both.",
                found="proven",
                needed="unproven",
            )


def _named(rank: int) -> str:
    return f"option {rank} of the front"


def _shown(one: Merit) -> str:
    return f"utility {one.alternative.utility:g}, {shown(one.makespan or 0)}"


def _beats(one: Merit, other: Merit) -> bool:
    return _covers(one, other) and (one.utility, one.makespan) != (other.utility, other.makespan)


def _covers(one: Merit, other: Merit) -> bool:
    return one.utility >= other.utility and (one.makespan or 0) <= (other.makespan or 0)
