"""The explanation of a plan from a file, for whoever shows it: also of one for a part of a mission, whose whole is planned again."""

from __future__ import annotations

from dataclasses import replace

from missiontree.explaining.explain import explained, request_of
from missiontree.explaining.whole import as_given
from missiontree.mission.control import Control
from missiontree.mission.explanation import Explanation
from missiontree.mission.plan import Plan
from missiontree.planner import plan_authored

MOST_NODES = 4_000
"""Nodes over the fleet of a plan that is explained unasked; more takes more time than somebody who did not ask would wait."""


def worth_explaining(plan: Plan) -> bool:
    """Whether a plan is explained unasked: it cannot be done, or only in part, and is not large."""
    small = plan.grounding is None or len(plan.grounding.tree.nodes) <= MOST_NODES
    return plan.outcome in {"cannot_be_done", "partial"} and small


def explanation_of(plan: Plan, control: Control, most: int = 3) -> Explanation | None:
    """
    Why a plan's mission cannot be done, and what would make it possible; None if it is not worth explaining.

    Parameters
    ----------
    plan
        Any plan.
    control
        Time limit.
    most
        How many repairs are wanted. Default 3.
    """
    if not worth_explaining(plan):
        return None
    request = request_of(plan)
    if plan.partial is not None:
        request = replace(request, tree=plan.partial.whole)
        plan = plan_authored(request, as_given(plan.partial.whole, plan.brief), control)
    return explained(plan, request, control, most).told
