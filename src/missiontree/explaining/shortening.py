"""
Which robot or resource to add to shorten a schedule: answered by scheduling the same alternative anew, with that in it.

The same scheduler is asked, with the same seed, so that what differs is what was added. Whatever it finds has passed the checker's rules of
schedules before it is told.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from missiontree.checking.checker import check_schedules
from missiontree.errors import InternalError
from missiontree.explaining.added import not_tried, verdict_of, worth
from missiontree.explaining.enlarging import with_more, with_plugs, with_room
from missiontree.mission.alternative import Alternative
from missiontree.mission.as_ranking import as_ranking
from missiontree.mission.brief import MissionBrief
from missiontree.mission.chain import Addition, WhySoLong
from missiontree.mission.control import Control
from missiontree.mission.fleet import RobotType
from missiontree.mission.front import Option
from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Leg, Schedule
from missiontree.reporting.critical.chain import chain_of
from missiontree.scheduling import SCHEDULERS

MOST_TYPES = 12
MOST_MODELS = 4
"""Robots of a type that are tried as the model of one more."""
MOST_ROLES = 400
"""Roles beyond which it is not asked what a robot for each of them would bring."""


def why_so_long(plan: Plan, rank: int, control: Control | None = None) -> WhySoLong:
    """
    Why a schedule is as long as it is, and which robot would shorten it.

    Parameters
    ----------
    plan
        A plan.
    rank
        Rank of an alternative that has a schedule with actions.
    control
        How long all scheduling may take, and who may stop it. Default: no limit but the scheduler's own.

    Raises
    ------
    ValueError
        If there is no such schedule.
    """
    schedule = next((one for one in plan.schedules if one.rank == rank and one.actions), None)
    if schedule is None or plan.grounding is None or plan.ranking is None:
        raise ValueError(f"alternative {rank} has no schedule.")
    chain = chain_of(plan, schedule)
    return _Shortening(plan, schedule, control or Control(seed=plan.provenance.seed)).told(WhySoLong(chain=chain))


class _Larger(NamedTuple):
    """A brief with more in it, and what that is."""

    brief: MissionBrief
    robots: Mapping[str, int]
    resources: Mapping[str, int]
    like: str | None = None


class _Shortening:
    """One schedule, and the plan it stands in."""

    def __init__(self, plan: Plan, schedule: Schedule, control: Control) -> None:
        assert plan.ranking is not None
        self._plan, self._schedule, self._control = plan, schedule, control
        self._alternative: Alternative = plan.ranking.alternatives[schedule.rank - 1]
        self._roles = Counter(filled.robot_type for filled in self._alternative.roles)
        self._brief = plan.brief

    def told(self, why: WhySoLong) -> WhySoLong:
        """With everything that was tried while time was left."""
        if not why.chain.steps:
            return why
        kinds = [kind for kind in self._brief.fleet.types if self._roles[kind.id]]
        asked = [[self._one_more(kind, like) for like in _models(kind)] for kind in kinds[:MOST_TYPES]]
        waited = self._waited_for(why)
        asked += [[self._more_room([resource])] for resource in waited]
        asked += [[self._more_room(waited)]] if len(waited) > 1 else []  # a way may lead through several
        few = sum(self._roles.values()) <= MOST_ROLES and len(kinds) <= MOST_TYPES
        left, found, missed = sum(map(len, asked)) + few, list[Addition](), 0
        for models in asked:
            tried: list[Addition] = []
            for one in models:
                if self._control.ended():
                    missed += 1
                else:
                    tried.append(self._told(one, 1 / left))
                left -= 1
            found += [min(tried, key=worth)] if tried else []
        unlimited = self._told(self._everyone(kinds), 1.0) if few and not self._control.ended() else None
        missed += few and unlimited is None
        return replace(why, additions=tuple(sorted(found, key=worth)), unlimited=unlimited, untried=not_tried(missed))

    def _one_more(self, kind: RobotType, like: str | None) -> _Larger:
        return _Larger(
            replace(self._brief, fleet=with_more(self._brief.fleet, kind.id, like=like)), {kind.id: 1}, {}, like
        )

    def _more_room(self, resources: Sequence[str]) -> _Larger:
        scene = self._brief.scene
        assert scene is not None
        for resource in resources:
            more = with_room if resource in self._brief.world.shared else with_plugs
            scene = more(scene, resource)
        return _Larger(replace(self._brief, scene=scene), {}, dict.fromkeys(resources, 1))

    def _everyone(self, kinds: Sequence[RobotType]) -> _Larger:
        fleet = self._brief.fleet
        for kind in kinds:
            fleet = with_more(fleet, kind.id, self._roles[kind.id])
        return _Larger(replace(self._brief, fleet=fleet), {kind.id: self._roles[kind.id] for kind in kinds}, {})

    def _waited_for(self, why: WhySoLong) -> list[str]:
        """Shared resources that the chain waits for, on ways too, and chargers."""
        assert self._plan.grounding is not None
        tree, world = self._plan.grounding.tree, self._brief.world
        visits = {(one.robot, one.start_s): one.charger for one in self._schedule.recharges}
        waited, full = set[str](), set[str]()
        for step in why.chain.steps:
            if step.bond != "resource":
                continue
            if step.kind == "refill":
                full.add(visits[step.robot, step.start_s])
                continue
            ways: list[Leg] = [leg for leg in self._schedule.legs if leg.leaf == step.leaf]
            if step.kind == "home":
                ways = [leg for leg in self._schedule.returns if leg.robot == step.robot]
            waited |= {name for leg in ways for name in world.passed(leg.via)}
            waited |= {*tree.action(step.leaf).holds} if step.kind not in {"home", "travel"} else set()
        return sorted((waited & world.shared.keys()) | full)

    def _told(self, larger: _Larger, share: float) -> Addition:
        anew = self._scheduled(larger.brief, share)
        return Addition(
            robots=larger.robots,
            resources=larger.resources,
            like=larger.like,
            verdict=verdict_of(anew, self._schedule.makespan_s),
            status=anew.status,
            makespan_s=anew.makespan_s,
            certificate=anew.certificate,
        )

    def _scheduled(self, brief: MissionBrief, share: float) -> Schedule:
        """The alternative scheduled anew, by the same scheduler, and checked alone, whatever the plan ranks or chooses beside it."""
        plan = self._plan
        assert plan.grounding is not None
        scene = brief.world.extended(plan.tree.entities if plan.tree is not None else ())
        scheduler = SCHEDULERS[plan.provenance.scheduler or "greedy"]
        control = self._control.part(share)
        anew = scheduler(plan.grounding.tree, self._alternative, brief.fleet, scene, control, brief.terms)
        option = Option(
            alternative=replace(self._alternative, rank=1),
            schedule=replace(anew, rank=1),
            certificate=anew.certificate,
        )
        faults = check_schedules(as_ranking(replace(plan, brief=replace(brief, objective="utility")), [option]))
        if faults:
            raise InternalError(
                f"the checker refuses a schedule of a larger team: {faults[0].rule}: {faults[0].message}"
            )
        return anew


def _models(kind: RobotType) -> Sequence[str | None]:
    """Robots of a type that differ, by name; None if all are alike."""
    if not kind.robots:
        return [None]
    unlike = {replace(robot, id=kind.id): robot.id for robot in reversed(kind.robots)}
    return [*reversed(unlike.values())][:MOST_MODELS]
