"""
Which robot to add to shorten a schedule: answered by scheduling the same alternative anew, with that robot in the team.

The same scheduler is asked, with the same seed, so that what differs is the team. Whatever it finds has passed the checker's rules of
schedules before it is told.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import replace

from missiontree.checking.checker import check_schedules
from missiontree.errors import InternalError
from missiontree.explaining.enlarging import with_more
from missiontree.mission.alternative import Alternative
from missiontree.mission.chain import Addition, Verdict, WhySoLong
from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.plan import Plan
from missiontree.mission.schedule import Schedule
from missiontree.reporting.critical.chain import chain_of
from missiontree.reporting.critical.spans import ms
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
    chain = chain_of(plan.grounding.tree, schedule, plan.brief.fleet)
    return _Shortening(plan, schedule, control or Control(seed=plan.provenance.seed)).told(WhySoLong(chain=chain))


class _Shortening:
    """One schedule, and the plan it stands in."""

    def __init__(self, plan: Plan, schedule: Schedule, control: Control) -> None:
        assert plan.ranking is not None
        self._plan, self._schedule, self._control = plan, schedule, control
        self._alternative: Alternative = plan.ranking.alternatives[schedule.rank - 1]
        self._roles = Counter(filled.robot_type for filled in self._alternative.roles)
        self._fleet = plan.brief.fleet

    def told(self, why: WhySoLong) -> WhySoLong:
        """With everything that was tried while time was left."""
        kinds = [kind for kind in self._fleet.types if self._roles[kind.id]]
        most = sum(self._roles.values()) <= MOST_ROLES and len(kinds) <= MOST_TYPES
        questions = sum(len(_models(kind)) for kind in kinds[:MOST_TYPES]) + most
        found: list[Addition] = []
        for kind in kinds[:MOST_TYPES] if why.chain.steps else ():
            tried: list[Addition] = []
            for like in _models(kind):
                if not self._control.ended():
                    fleet = with_more(self._fleet, kind.id, like=like)
                    tried.append(self._addition(fleet, {kind.id: 1}, like, 1 / max(1, questions)))
                questions -= 1
            if tried:
                found.append(min(tried, key=_worth))
        unlimited = self._unlimited(kinds) if most and why.chain.steps and not self._control.ended() else None
        return replace(why, additions=tuple(sorted(found, key=_worth)), unlimited=unlimited)

    def _unlimited(self, kinds: list[RobotType]) -> Addition:
        fleet = self._fleet
        for kind in kinds:
            fleet = with_more(fleet, kind.id, self._roles[kind.id])
        return self._addition(fleet, {kind.id: self._roles[kind.id] for kind in kinds}, None, 1.0)

    def _addition(self, fleet: Fleet, robots: Mapping[str, int], like: str | None, share: float) -> Addition:
        anew = self._scheduled(fleet, share)
        return Addition(
            robots=robots,
            like=like,
            verdict=self._verdict(anew),
            status=anew.status,
            makespan_s=anew.makespan_s,
            certificate=anew.certificate,
        )

    def _scheduled(self, fleet: Fleet, share: float) -> Schedule:
        """The alternative scheduled anew, by the same scheduler."""
        plan, brief = self._plan, self._plan.brief
        assert plan.grounding is not None
        assert plan.ranking is not None
        scene = brief.world.extended(plan.tree.entities if plan.tree is not None else ())
        scheduler = SCHEDULERS[plan.provenance.scheduler or "greedy"]
        anew = scheduler(plan.grounding.tree, self._alternative, fleet, scene, self._control.part(share), brief.terms)
        only = replace(plan.ranking, alternatives=(self._alternative,))
        faults = check_schedules(replace(plan, brief=replace(brief, fleet=fleet), ranking=only, schedules=(anew,)))
        if faults:
            raise InternalError(
                f"the checker refuses a schedule of a larger team: {faults[0].rule}: {faults[0].message}"
            )
        return anew

    def _verdict(self, anew: Schedule) -> Verdict:
        now = ms(self._schedule.makespan_s)
        if anew.actions and ms(anew.makespan_s) < now:
            return "shorter"
        bound = anew.certificate.bound if anew.certificate.claim in {"proven", "bounded"} else None
        return "not_shorter" if bound is not None and ms(bound) >= now else "none_found"


def _models(kind: RobotType) -> Iterator[str | None] | list[str | None]:
    """Robots of a type that differ, by name; None if all are alike."""
    if not kind.robots:
        return [None]
    unlike = {replace(robot, id=kind.id): robot.id for robot in reversed(kind.robots)}
    return [*reversed(unlike.values())][:MOST_MODELS]


def _worth(one: Addition) -> tuple[int, int]:
    """The shortest first, then what is proven not to help, then the rest."""
    order = ("shorter", "not_shorter", "none_found")
    return order.index(one.verdict), ms(one.makespan_s) if one.verdict == "shorter" else 0
