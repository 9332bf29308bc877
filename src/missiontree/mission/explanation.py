"""Why a mission cannot be done, and the smallest changes that would make it possible: computed, not guessed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from missiontree.mission.change import Change
from missiontree.mission.plan import Outcome, Plan
from missiontree.mission.reason import Reason
from missiontree.mission.value import Count, Id, NonNegative, Value

Stage = Literal["authoring", "tree", "allocation", "schedule"]
RepairClaim = Literal["smallest_proven", "smallest_found"]
Cheapest = Literal["proven", "found", "none"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Shortfall(Value):
    """
    How much there is of something, and how much would be needed.

    Parameters
    ----------
    quantity
        What it is, unit in the name: ``payload_kg``, ``energy_j``, ``deadline_s``.
    has, needs
        What there is, and the least that is needed.
    """

    quantity: str
    has: float
    needs: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Cause(Value):
    """
    One thing that stands in the way of a mission.

    Parameters
    ----------
    stage
        Where it shows: ``authoring``: no routine serves what is asked. ``tree``: no robot type can do a routine. ``allocation``: limits
        that cannot be kept together. ``schedule``: a time, a place or a budget, once travel is counted.
    rule
        Code of the rule, as in the reasons.
    words
        The cause as a sentence.
    node
        Id of the node of the mission tree concerned; empty if it is the whole mission.
    reasons
        What shows it: of a routine, for each robot type the rule that refused it; else the reasons of the solvers.
    shortfall
        The numbers, where it is one number that falls short; else None.
    hint
        What to do about it, as far as it is known without trying; empty if nothing is.
    chain
        Of a deadline: what follows each other without a pause and shows when it can be met at the earliest; empty if that is not known.
    """

    stage: Stage
    rule: Id
    words: str
    node: str = ""
    reasons: tuple[Reason, ...] = ()
    shortfall: Shortfall | None = None
    hint: str = ""
    chain: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Repair(Value):
    """
    Changes with which the mission can be done: they were applied to a copy, and the plan that results was checked.

    Parameters
    ----------
    number
        From 1, cheapest first.
    changes
        What to change, all of it together.
    cost
        Sum over the changes, by the user's costs.
    claim
        ``smallest_proven``: proven that nothing less of the same kind would do. ``smallest_found``: it is the least that was found.
    words
        The repair as an order: "Add one robot of type rover."
    utility, makespan_s
        Of the best alternative that can then be scheduled.
    plan
        The plan that results; None where it is not told.
    """

    number: Count
    changes: tuple[Change, ...]
    cost: NonNegative
    claim: RepairClaim
    words: str
    utility: float
    makespan_s: NonNegative
    plan: Plan | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Nearest(Value):
    """
    The largest part of a mission that can be done.

    Parameters
    ----------
    words
        What is done, and what is left out.
    dropped
        Ids of the nodes of the mission tree that are left out.
    proven
        Whether no part of greater weight can be done.
    plan
        The plan of that part; None where it is not told.
    """

    words: str
    dropped: tuple[Id, ...]
    proven: bool
    plan: Plan | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Explanation(Value):
    """
    What is known of a mission that cannot be done, or can.

    Parameters
    ----------
    outcome
        What planning came to, see :class:`missiontree.mission.plan.Plan`.
    mission
        The mission in words.
    causes
        Why it cannot be done; empty if it can.
    repairs
        What would make it possible, cheapest first.
    cheapest
        What is known of the first repair: ``proven``: every change of those looked at that costs less was proven not to be enough.
        ``found``: some of them were not decided. ``none``: there is no repair.
    tried
        How many changes were looked at.
    notices
        What else to know: what was not looked for, and why.
    nearest
        The largest part that can be done; None if it was not looked for, or nothing can be done.
    plan
        The plan that is explained; None where it is not told.
    """

    outcome: Outcome
    mission: str
    causes: tuple[Cause, ...] = ()
    repairs: tuple[Repair, ...] = ()
    cheapest: Cheapest = "none"
    tried: int = 0
    notices: tuple[Reason, ...] = ()
    nearest: Nearest | None = None
    plan: Plan | None = None
