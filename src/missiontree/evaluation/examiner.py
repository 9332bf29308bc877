"""One run: put a model to a mission, and judge what it makes of it."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

from missiontree.authoring.budgets import Budgets
from missiontree.authoring.outcome import Authored
from missiontree.briefing import Request
from missiontree.evaluation.contestant import Contestant
from missiontree.evaluation.run import Key, Run
from missiontree.evaluation.suite_file import SuiteMission
from missiontree.evaluation.told import told
from missiontree.evaluation.verdict import judge
from missiontree.llm.chat import ProviderError
from missiontree.mission.brief import MissionBrief
from missiontree.mission.control import Control
from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason
from missiontree.planner import author, plan_authored

PLANNING_LIMIT_S = 60.0


@dataclass(frozen=True, slots=True)
class Task:
    """
    A run that is to be made.

    Parameters
    ----------
    contestant
        Who is put to it.
    mission, brief
        What it is put to.
    digest
        Of what the verdict depends on.
    number
        Which run of the mission by the model, from 1.
    """

    contestant: Contestant
    mission: SuiteMission
    brief: MissionBrief
    digest: str
    number: int

    @property
    def key(self) -> Key:
        """As that of the run it becomes."""
        return self.contestant.name, self.mission.id, self.number, self.digest


@dataclass(frozen=True, slots=True, kw_only=True)
class Examiner:
    """
    Makes runs.

    Parameters
    ----------
    whole
        Plan each tree to its end, too, and judge what that comes to; 60 s for one tree. Default: the tree alone is judged.
    budgets
        How long a dialogue may go on.
    stop
        Asked now and then; once it answers true, dialogues end.
    clock
        Monotonic seconds, for what a run takes; asked in several threads.
    """

    whole: bool = False
    budgets: Budgets = Budgets()
    stop: Callable[[], bool] = lambda: False
    clock: Callable[[], float] = time.monotonic

    def __call__(self, task: Task) -> Run:
        """
        Make a run. That a model cannot be used is a result.

        Raises
        ------
        InputError
            If there is no such model.
        """
        began = self.clock()
        try:
            authored, request = self._authored(task)
            seconds = max(0.0, self.clock() - began)
            plan = self._planned(request, authored) if self.whole else None
            verdict = judge(task.mission, authored, task.brief, plan)
        except Exception as error:
            error.add_note(f"while {task.contestant.name} was put to mission {task.mission.id}: {task.mission.say}")
            raise
        reasons = plan.reasons if plan is not None else authored.reasons
        failed = verdict.status == "provider_failed"
        return Run(
            model=task.contestant.name,
            mission=task.mission.id,
            number=task.number,
            digest=task.digest,
            kind=verdict.kind,
            status=verdict.status,
            score=round(verdict.score, 4),
            differences=verdict.differences,
            reasons=tuple(reason.message for reason in reasons),
            got=told(authored.tree, task.brief) if authored.tree is not None and not authored.tree.open_leaves else "",
            fault=reasons[0].rule if failed and reasons else "",
            seconds=round(seconds, 3),
            spent=authored.spent,
        )

    def _authored(self, task: Task) -> tuple[Authored, Request]:
        request = Request(brief=task.brief, base_url=task.contestant.base_url, budgets=self.budgets)
        try:
            request = Request(
                brief=task.brief,
                model=task.contestant.ready(),
                base_url=task.contestant.base_url,
                budgets=self.budgets,
            )
            return author(request, Control(stop=self.stop)), request
        except ProviderError as fault:
            why = Reason(rule=f"provider_{fault.kind}", message=str(fault), hint=fault.hint)
            return Authored(status="provider_failed", reasons=(why,)), request

    def _planned(self, request: Request, authored: Authored) -> Plan:
        return plan_authored(request, authored, Control(time_limit_s=PLANNING_LIMIT_S, stop=self.stop))
