"""The explanation of a plan that nobody asked to be explained, for whoever shows it."""

from __future__ import annotations

from missiontree.explaining.explain import explained, request_of
from missiontree.mission.control import Control
from missiontree.mission.explanation import Explanation
from missiontree.mission.plan import Plan

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
    return explained(plan, request_of(plan), control, most).told
