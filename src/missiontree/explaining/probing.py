"""Can a changed mission be done? The planner's own stages are asked, each only if the one before does not tell."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from missiontree.allocation.any_alternative import any_alternative
from missiontree.allocation.flat import flatten
from missiontree.authoring.outcome import Authored
from missiontree.briefing import Request
from missiontree.errors import InputError
from missiontree.explaining.case import Case
from missiontree.mission.alternative import Ranking
from missiontree.mission.control import Control
from missiontree.mission.grounded import Grounding
from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason
from missiontree.mission.schedule import Schedule
from missiontree.planner import plan_authored, staff_and_schedule
from missiontree.routines.ground import ground

THOROUGH = "auto"
"""Scheduler that is asked where the quick one proves nothing."""


@dataclass(frozen=True, slots=True)
class Answer:
    """
    What is known of a mission.

    Parameters
    ----------
    possible
        Whether it can be done; None if that was not decided.
    grounding, ranking, schedules
        What shows it, as far as the stages were asked.
    """

    possible: bool | None
    grounding: Grounding | None = None
    ranking: Ranking | None = None
    schedules: tuple[Schedule, ...] = ()

    @property
    def best(self) -> Schedule | None:
        """The best schedule that works."""
        return next((schedule for schedule in self.schedules if schedule.status in {"optimal", "feasible"}), None)


NO = Answer(False)


class Prober:
    """
    Asks whether missions can be done.

    Parameters
    ----------
    request
        How the mission is planned: seed, methods, estimator.
    control
        How long all questions together may take.
    most
        How many questions may be asked.
    """

    def __init__(self, request: Request, control: Control, most: int) -> None:
        self._request, self._control, self._left = request, control, most
        self.asked = 0

    def ended(self) -> bool:
        """Whether nothing more may be asked."""
        return self._left <= 0 or self._control.ended()

    def ask(self, case: Case) -> Answer:
        """Whether a mission can be done. What cannot even be stated cannot be done either."""
        if self.ended():
            return Answer(None)
        self._left -= 1
        self.asked += 1
        brief = replace(case.brief, diverse=False) if case.brief.diverse else case.brief
        try:
            grounding = ground(case.tree, brief, self._request.estimator)
        except InputError:  # an estimator of the user's own may just not know the answer
            return NO if brief.estimator is None else Answer(None)
        flat = flatten(grounding.tree, brief.fleet, brief.weights, brief.terms)
        if any_alternative(flat, self._control) is False:
            return Answer(False, grounding)
        answer = Answer(None, grounding)
        for scheduler in ("greedy", THOROUGH):
            request = replace(self._request, brief=brief, tree=case.tree, k=1, allocator="exact", scheduler=scheduler)
            scene = brief.world.extended(case.tree.entities)
            ranking, schedules = staff_and_schedule(grounding, request, scene, self._control)
            answer = Answer(_possible(ranking, schedules), grounding, ranking, schedules)
            if answer.possible is not None:
                break
        return answer

    def plan(self, case: Case, notice: Reason, k: int) -> Plan | None:
        """The whole plan of a changed mission, checked; None if none is delivered."""
        authored = Authored(status="complete", tree=case.tree, author="given", notices=(notice,))
        for brief in dict.fromkeys((case.brief.diverse, False)):
            for scheduler in dict.fromkeys((self._request.scheduler, THOROUGH)):
                request = replace(
                    self._request,
                    brief=replace(case.brief, diverse=brief),
                    tree=case.tree,
                    k=k,
                    scheduler=scheduler,
                )
                plan = plan_authored(request, authored, self._control)
                if plan.outcome == "delivered":
                    return plan
        return None


def _possible(ranking: Ranking, schedules: Sequence[Schedule]) -> bool | None:
    """As a plan tells its outcome: done, proven impossible, or neither."""
    if any(schedule.status in {"optimal", "feasible"} for schedule in schedules):
        return True
    if ranking.status == "infeasible":
        return False
    complete = ranking.status == "exact" and ranking.certificate.bound is None
    proven = complete and all(schedule.status == "infeasible" for schedule in schedules)
    return False if proven else None
