"""
The road of an explanation: a mission that was planned in vain → its causes → the changes that would make it possible.

Nothing here is guessed: causes are what the planner's stages proved, and a repair is offered only after the changed mission was planned
and the plan was checked.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

from missiontree.authoring.outcome import Authored
from missiontree.briefing import Request, request_from
from missiontree.explaining.causes import causes_of_plan
from missiontree.mission.control import Control
from missiontree.mission.costs import DEFAULT_COSTS, Costs
from missiontree.mission.explanation import Explanation
from missiontree.mission.plan import Plan
from missiontree.planner import author, plan_authored


def explain(
    mission: str | Path | Plan, *, costs: Costs = DEFAULT_COSTS, control: Control | None = None, **inputs: Any
) -> Explanation:
    """
    Say why a mission cannot be done, and what would make it possible.

    Parameters
    ----------
    mission
        The mission in words, the path of a mission file, or a plan.
    costs
        What changes cost, which puts repairs in their order.
    control
        Time limit, stop token, progress callback. Default: no limit.
    inputs
        ``fleet``, ``scene`` and all else that :func:`missiontree.planner.plan` takes; nothing beside a plan, which carries its inputs.

    Returns
    -------
    Explanation
        Also of a mission that can be done: then it has a plan and no causes.

    Raises
    ------
    InputError
        If something handed in is not what it should be.
    """
    if isinstance(mission, Plan):
        request, authored = request_of(mission), None
    else:
        request = request_from(mission, **inputs)
        authored = author(request)
    control = control or Control(seed=request.seed)
    if authored is None:
        return explain_plan(mission, request, control, costs)  # type: ignore[arg-type]  # a plan, since nothing was authored
    return explain_authored(request, authored, control, costs)


def explain_authored(
    request: Request, authored: Authored, control: Control, costs: Costs = DEFAULT_COSTS
) -> Explanation:
    """Explain a mission whose tree is built, as far as it could be."""
    return explain_plan(plan_authored(request, authored, control), request, control, costs)


def explain_plan(plan: Plan, request: Request, control: Control, costs: Costs = DEFAULT_COSTS) -> Explanation:
    """Explain a plan that was made, see :func:`explain`."""
    told = Explanation(outcome=plan.outcome, mission=plan.brief.text, plan=plan)
    if plan.outcome == "delivered":
        return told
    return replace(told, causes=causes_of_plan(plan))


def request_of(plan: Plan) -> Request:
    """The request that a plan answers, as far as the plan carries it."""
    return Request(
        brief=plan.brief,
        tree=plan.tree,
        allocator=plan.provenance.allocator or "exact",
        scheduler=plan.provenance.scheduler or "greedy",
        seed=plan.provenance.seed,
    )
