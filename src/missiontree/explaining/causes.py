"""Causes: what stands in the way of a mission, stage by stage."""

from __future__ import annotations

from missiontree.explaining.reasons import causes_of
from missiontree.mission.explanation import Cause
from missiontree.mission.plan import Plan


def causes_of_plan(plan: Plan) -> tuple[Cause, ...]:
    """Why a plan is not delivered."""
    if plan.grounding is None:
        return causes_of(plan.reasons, "authoring")
    return causes_of(plan.reasons, "allocation")
