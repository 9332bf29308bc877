"""
The road of an explanation: a mission that was planned in vain → its causes → the changes that would make it possible.

Nothing here is guessed: causes are what the planner's stages proved, and a repair is offered only after the changed mission was planned
and the plan was checked.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from missiontree.authoring.outcome import Authored
from missiontree.briefing import DEFAULT_K, Request, request_from
from missiontree.errors import InputError
from missiontree.estimation.answers import ReadingOut
from missiontree.estimation.own import OwnEstimator
from missiontree.explaining.any_schedule import THOROUGH
from missiontree.explaining.case import Case
from missiontree.explaining.causes.binding import with_links
from missiontree.explaining.causes.causes import causes_of
from missiontree.explaining.causes.closer import closer
from missiontree.explaining.causes.routines import routine_causes
from missiontree.explaining.nearest import nearest_of
from missiontree.explaining.repairing import Repairs, planned
from missiontree.explaining.understood import understood
from missiontree.explaining.whole import as_given
from missiontree.mission.control import Control
from missiontree.mission.costs import Costs
from missiontree.mission.explanation import Cause, Explanation, Repair
from missiontree.mission.plan import Plan
from missiontree.planner import author, plan_authored
from missiontree.routines.ground import ground

MOST_REPAIRS = 6
SETTLING_SHARE = 0.3
"""Share of the time for finding out whether the mission can be done after all."""


@dataclass(frozen=True, slots=True)
class Explained:
    """
    An explanation, and what it takes to go on from there.

    Parameters
    ----------
    told
        The explanation.
    request
        What was asked for.
    case
        The mission with its tree; None if there is none.
    """

    told: Explanation
    request: Request
    case: Case | None = None

    def repaired(self, number: int, control: Control | None = None) -> Plan:
        """
        The whole plan of a repaired mission, with as many alternatives as the mission asks for.

        Parameters
        ----------
        number
            Number of the repair, from 1.
        control
            Limits of planning. Default: none.

        Raises
        ------
        InputError
            If there is no such repair.
        """
        repair = self._repair(number)
        assert self.case is not None, "repairs change a case"
        whole = planned(self.request, self.case, repair, control or Control(seed=self.request.seed), self.request.k)
        plan = whole or repair.plan
        assert plan is not None, "every repair was planned"
        return plan

    def _repair(self, number: int) -> Repair:
        for repair in self.told.repairs:
            if repair.number == number:
                return repair
        count = len(self.told.repairs)
        if self.told.outcome == "delivered":
            raise InputError(
                f"repair {number} is asked for, and the mission can be done as it stands",
                accepted="a mission that cannot be done",
            )
        raise InputError(
            f"there is no repair {number}",
            accepted=f"a number from 1 to {count}" if count else "none: no repair was found",
            hint="`missiontree explain MISSION` lists them." if count else "",
        )


def explain(
    mission: str | Path | Plan,
    *,
    costs: Costs | None = None,
    most: int = MOST_REPAIRS,
    control: Control | None = None,
    **inputs: Any,
) -> Explanation:
    """
    Say why a mission cannot be done, and what would make it possible.

    Parameters
    ----------
    mission
        The mission in words, the path of a mission file, or a plan.
    costs
        What changes cost, which puts repairs in their order. Default: the mission file's, else those of the documentation.
    most
        How many repairs are wanted, at least 1. Default 6.
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
    plan = mission if isinstance(mission, Plan) else None
    request = request_from(mission, **inputs) if not isinstance(mission, Plan) else request_of(mission)
    request = request if costs is None else replace(request, costs=costs)
    control = control or Control(seed=request.seed)
    if plan is None:
        plan = plan_authored(request, author(request, control), control)
    return explained(plan, request, control, most).told


def explained(plan: Plan, request: Request, control: Control, most: int = MOST_REPAIRS) -> Explained:
    """Explain a plan that was made of a request, see :func:`explain`."""
    if plan.partial is not None:  # the whole mission is what is to be explained
        whole = plan.partial.whole
        plan = plan_authored(replace(request, tree=whole), as_given(whole, plan.brief), control)
    if plan.outcome == "exhausted" and plan.tree is not None and plan.grounding is not None:
        plan = _settled(plan, request, control)
    told = Explanation(outcome=plan.outcome, mission=plan.brief.text, plan=plan)
    if plan.outcome == "delivered":
        return Explained(told, request)
    causes, case = _causes(plan, request)
    if case is None:
        return Explained(replace(told, causes=causes, nearest=nearest_of(plan, request, None, control)), request)
    known = [cause.shortfall for cause in causes if cause.shortfall is not None]
    repairs = Repairs(request, case, known, control)
    found = repairs.find(max(1, most))
    causes = with_links([closer(cause, found) for cause in causes], found, case.tree)
    nearest = nearest_of(plan, request, case.tree, control)
    told = replace(
        told,
        causes=causes,
        repairs=found,
        cheapest=repairs.cheapest,
        tried=repairs.looked_at,
        notices=repairs.notices(),
        nearest=nearest,
    )
    return Explained(told, request, case)


def _settled(plan: Plan, request: Request, control: Control) -> Plan:
    """A plan that leaves open whether the mission can be done, made again by more thorough methods; what they cannot settle stays."""
    thorough = replace(request, allocator="exact", scheduler=THOROUGH)
    authored = Authored(status="complete", tree=plan.tree, author="given", notices=plan.notices)
    again = plan_authored(thorough, authored, control.part(SETTLING_SHARE))
    return again if again.outcome != "exhausted" else plan


def _causes(plan: Plan, request: Request) -> tuple[tuple[Cause, ...], Case | None]:
    """The causes, and the mission that can be changed; None if there is no tree to change anything for."""
    if plan.grounding is not None and plan.tree is not None:
        return causes_of(plan), Case(plan.brief, plan.tree)
    if plan.outcome == "cannot_be_done":
        made = understood(request)
        if made is not None and made.tree is not None:
            of_routines = routine_causes(made.tree, ground(made.tree, plan.brief, request.estimator))
            return of_routines or causes_of(plan), Case(plan.brief, made.tree)
    return causes_of(plan), None


def explain_authored(request: Request, authored: Authored, control: Control, most: int = MOST_REPAIRS) -> Explained:
    """Explain a mission whose tree is built, as far as it could be."""
    return explained(plan_authored(request, authored, control), request, control, most)


def request_of(plan: Plan) -> Request:
    """The request that a plan answers, as far as the plan carries it."""
    brief, own = plan.brief, None
    if brief.estimator is not None:
        said = plan.grounding.estimates if plan.grounding is not None else ()
        own = OwnEstimator(ReadingOut(said).estimate, brief.estimator)
    return Request(
        brief=brief,
        tree=plan.tree if plan.partial is None else plan.partial.whole,
        k=max(DEFAULT_K, len(plan.ranking.alternatives) if plan.ranking else 0),
        allocator=plan.provenance.allocator or "exact",
        scheduler=plan.provenance.scheduler or "greedy",
        seed=plan.provenance.seed,
        estimator=own,
    )
