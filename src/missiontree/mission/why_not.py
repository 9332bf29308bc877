"""Why a plan is as it is and not otherwise: the mission planned again as it was asked for, and set beside the plan."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason
from missiontree.mission.value import Id, NonNegative, Value

Verdict = Literal[
    "same", "refused", "impossible", "worse", "later", "as_good", "sooner", "better", "part_only", "undecided"
]
AnswerClaim = Literal["proven", "found"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Moved(Value):
    """
    A task that is done otherwise.

    Parameters
    ----------
    node
        Id of the routine node.
    task
        What it is called.
    before, after
        Who does it in the plan, and who does it as it was asked for; empty if nobody does.
    utility_change
        How much more its actions are worth then; below 0 if less.
    """

    node: Id
    task: str
    before: str
    after: str
    utility_change: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class WhyNot(Value):
    """
    The answer to a question about a plan.

    Parameters
    ----------
    question
        What was asked, in words.
    verdict
        ``same``: the plan is as asked for. ``refused``: a rule forbids it, the reasons say which. ``impossible``: proven that there is no
        such plan. ``worse``: of less utility. ``later``, ``as_good``, ``sooner``: of the same utility, and ends so; where the objective is
        makespan, whatever the utility. ``better``: of more
        utility, since the plan's own first alternatives have no schedule. ``part_only``: only a part of the mission can then be done.
        ``undecided``: neither a plan nor a proof that there is none was found.
    claim
        ``proven``: utilities and impossibility are those of exact searches. ``found``: a search ended early.
    words
        The answer, a sentence after the other.
    reasons
        What forbids it, or limits that clash.
    utility, asked_utility
        Of the plan's best alternative with a schedule, and of the best that is as asked for; None if there is none.
    makespan_s, asked_makespan_s
        Of their schedules.
    moved
        Tasks that are done otherwise, in tree order.
    plan
        The plan that is as asked for, checked; None if there is none, or where it is not told.
    """

    question: str
    verdict: Verdict
    claim: AnswerClaim
    words: tuple[str, ...]
    reasons: tuple[Reason, ...] = ()
    utility: float | None = None
    asked_utility: float | None = None
    makespan_s: NonNegative | None = None
    asked_makespan_s: NonNegative | None = None
    moved: tuple[Moved, ...] = ()
    plan: Plan | None = None
