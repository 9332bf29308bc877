"""Can a changed mission be done? The planner's own stages are asked, each only if the one before does not tell."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from missiontree.allocation.aimed import allocator_for
from missiontree.allocation.any_alternative import any_alternative
from missiontree.allocation.flat import Flat, flatten
from missiontree.authoring.outcome import Authored
from missiontree.briefing import Request
from missiontree.errors import InputError
from missiontree.explaining.any_schedule import WORKING, any_schedule
from missiontree.explaining.case import Case
from missiontree.mission.alternative import Ranking
from missiontree.mission.brief import MissionBrief
from missiontree.mission.control import Control
from missiontree.mission.grounded import Grounding
from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason
from missiontree.mission.schedule import Schedule
from missiontree.planner import MAX_DRAWN, plan_authored
from missiontree.routines.ground import ground

FEW_DRAWN, LARGE = 4, 20
"""Alternatives drawn where some stay undecided, for nothing can be proven then and each takes long; in trees of more nodes, one."""
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
        return next((schedule for schedule in self.schedules if schedule.status in WORKING), None)


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
        return self._scheduled(case, brief, grounding, flat)

    def _scheduled(self, case: Case, brief: MissionBrief, grounding: Grounding, flat: Flat) -> Answer:
        """Draw alternatives until one has a schedule, or none is left."""
        scene = brief.world.extended(case.tree.entities)
        allocate = allocator_for("exact", brief.aim)
        wanted, done = 1, dict[object, Schedule]()
        while True:
            ranking = allocate(flat, brief.fleet, brief.weights, wanted, self._control)
            for alternative in ranking.alternatives:
                if alternative.choices not in done:
                    schedule = any_schedule(grounding.tree, alternative, brief.fleet, scene, self._control, brief.terms)
                    done[alternative.choices] = schedule
                    if schedule.status in WORKING:
                        return Answer(True, grounding, ranking, (schedule,))
            most = MAX_DRAWN
            if any(schedule.status == "unknown" for schedule in done.values()):
                most = FEW_DRAWN if len(case.tree.nodes) <= LARGE else 1
            if len(ranking.alternatives) < wanted or wanted >= most or self.ended():
                break
            wanted *= 4
        return self._settled(grounding, ranking, done)

    def _settled(self, grounding: Grounding, ranking: Ranking, done: Mapping[object, Schedule]) -> Answer:
        """What all alternatives together come to, none of which has a schedule."""
        schedules = tuple(done[alternative.choices] for alternative in ranking.alternatives)
        complete = ranking.status == "infeasible" or (ranking.status == "exact" and ranking.certificate.bound is None)
        proven = complete and all(schedule.status == "infeasible" for schedule in schedules)
        return Answer(False if proven else None, grounding, ranking, schedules)

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
