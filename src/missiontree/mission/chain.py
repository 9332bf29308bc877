"""Why a schedule is as long as it is: its critical chain, stretch by stretch."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from missiontree.mission.certificate import Certificate
from missiontree.mission.schedule import ScheduleStatus
from missiontree.mission.value import Count, Id, Index, NonNegative, Value

Bond = Literal[
    "start",
    "role",
    "travel",
    "robot",
    "order",
    "entity",
    "resource",
    "partner",
    "hand_over",
    "refill",
    "until",
    "under_way",
    "release",
    "available",
    "unexplained",
]
StepKind = Literal["action", "travel", "until", "under_way", "wait", "home", "refill"]


@dataclass(frozen=True, slots=True)
class Step(Value):
    """
    A stretch of the critical chain.

    Parameters
    ----------
    kind
        ``action``: a whole action. ``travel``: the way to one. ``until``: an open-ended action ends because the step before does;
        takes no time. ``under_way``: the millisecond that an open-ended action must be under way before the step before may
        end. ``home``: the way home after an action. ``refill``: the way to a charger after an action, the wait for it, and the visit.
        ``wait``: it is waited for a release time or for a robot that comes late, or nothing in the schedule says why.
    leaf
        The action, or the one travelled to or waited for, or after which the robot goes home.
    robot
        Who does it.
    start_s, end_s
        From when to when; each step starts when the one before ends.
    bond
        Why it does not start earlier: ``start`` of the mission; the step before it is what its ``role`` or its ``robot`` does
        before, the ``travel`` there, an action that comes first by ``order``, one that brings or needs the same ``entity``, one
        that held a shared ``resource``, one that its joint ``partner`` waits for, one that takes part in a ``hand_over``, or
        what it lasts ``until``; or its ``release`` time; or that its robot is not ``available`` before, or has to ``refill``
        first; or ``unexplained``.
    """

    kind: StepKind
    leaf: Index
    robot: Id
    start_s: NonNegative
    end_s: NonNegative
    bond: Bond


@dataclass(frozen=True, slots=True, kw_only=True)
class CriticalChain(Value):
    """
    What, end to end, makes a schedule take as long as it does. Its parts add up to the makespan.

    Parameters
    ----------
    rank
        Rank of the alternative.
    makespan_s
        End of the last action, or of the last way home.
    work_s
        Seconds of the chain in which something is done on the spot.
    travel_s
        Seconds of the chain in which somebody is on the way: to an action, as an action, to a charger, or home.
    waiting_s
        Seconds of the chain in which nothing can be done yet: releases, robots that come late, and robots at chargers.
    steps
        In order of time; empty if nothing takes time.
    """

    rank: Count
    makespan_s: NonNegative
    work_s: NonNegative
    travel_s: NonNegative
    waiting_s: NonNegative
    steps: tuple[Step, ...] = ()


Verdict = Literal["shorter", "not_shorter", "none_found"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Addition(Value):
    """
    More of a team or of a shared resource, and what scheduling the same alternative anew, in the same way, comes to.

    Parameters
    ----------
    robots
        How many robots are added, by type; empty if none is.
    resources
        By how much the capacity of shared resources and chargers is raised; empty if none is.
    like
        Robot of which the one that is added is a copy: it starts where that one does, with as much; None where robots of its type
        are all alike, or where several are added.
    verdict
        ``shorter``: the schedule found is. ``not_shorter``: none is, which is proven. ``none_found``: none was found, none is excluded.
    status
        What is known of the schedule with the addition.
    makespan_s
        How long that schedule takes; 0 if there is none.
    certificate
        The bound on it, and the method behind the status.
    """

    robots: Mapping[Id, Count] = field(default_factory=dict)
    resources: Mapping[Id, Count] = field(default_factory=dict)
    like: Id | None = None
    verdict: Verdict
    status: ScheduleStatus
    makespan_s: NonNegative = 0.0
    certificate: Certificate


@dataclass(frozen=True, slots=True, kw_only=True)
class WhySoLong(Value):
    """
    Why a schedule is as long as it is, and what would shorten it.

    Parameters
    ----------
    chain
        Its critical chain.
    additions
        One more robot of each type that takes part, and one more place at each shared resource or charger that is waited for, and at
        all of them; those that shorten it most first.
    unlimited
        As many more robots of every type as there are roles, so that nobody is ever waited for; None if that was not tried.
    untried
        What was not tried, and why, as a sentence; empty (default) if everything was.
    """

    chain: CriticalChain
    additions: tuple[Addition, ...] = ()
    unlimited: Addition | None = None
    untried: str = ""
