"""Missions small enough for every plan to be worked out by hand, and how they are put to the search."""

from __future__ import annotations

from dataclasses import replace

from missiontree.choosing.choose import Choice, choose
from missiontree.mission.alternative import Alternative, Ranking
from missiontree.mission.brief import MissionBrief
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.front import Front
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.objective import Objective
from missiontree.mission.routine import RoutineLibrary
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.mission.terms import NO_TERMS, Terms
from missiontree.scheduling.cpsat.engine import schedule_within
from missiontree.scheduling.cpsat.settings import Settings
from missiontree.scheduling.scheduler import Scheduler
from tests.builders import Spec, and_, grounded, leaf, trivial_fleet, xor_

NOTHING = Ranking(alternatives=(), status="unknown", certificate=Certificate(claim="unproven", method="lazy_k_best"))
PATIENT = Settings(longest_s=60.0, deterministic=True, tidy=False)
"""As the scheduler ``auto`` is set, but for its patience: however busy the machine is, what can be proven is."""
TYPES = {"expert": 1, "novice": 1, "hand": 1, "twin": 1}


def task(number: int, *ways: tuple[str, float, float]) -> Spec:
    """A task with a way per robot type: how well it does it, and in how many seconds."""
    return xor_(
        *(leaf(f"{who}{number}", who, quality=quality, duration_s=takes_s) for who, quality, takes_s in ways),
        label=f"task{number}",
    )


def tasks(*specs: Spec) -> GroundedTree:
    """All of them, in any order."""
    return grounded(and_(*specs))


def brief(objective: Objective = "utility", weights: Weights = Weights(), **fields: object) -> MissionBrief:
    """A mission of four robots."""
    return MissionBrief(
        text="Mission",
        fleet=trivial_fleet(TYPES),
        routines=RoutineLibrary(routines=()),
        objective=objective,
        weights=weights,
        **fields,  # type: ignore[arg-type]
    )


def patient(
    tree: GroundedTree,
    alternative: Alternative,
    fleet: Fleet,
    scene: Scene,
    control: Control,
    terms: Terms = NO_TERMS,
) -> Schedule:
    """A scheduler that takes its time."""
    return schedule_within(tree, alternative, fleet, scene, control, terms, PATIENT)


def asked(
    tree: GroundedTree,
    mission: MissionBrief,
    control: Control | None = None,
    front: bool = False,
    scheduler: Scheduler = patient,
) -> Choice:
    """What comes out if nothing is known beforehand."""
    return choose(tree, mission, mission.world, scheduler, control or Control(), NOTHING, (), front)


def front_of(tree: GroundedTree, mission: MissionBrief | None = None, **asking: object) -> Front:
    """The front of a mission that has one."""
    front = asked(tree, mission or brief(), front=True, **asking).front  # type: ignore[arg-type]
    assert front is not None
    return front


def points(front: Front) -> list[tuple[float, float]]:
    """Utility and makespan of each option."""
    return [(option.alternative.utility, option.schedule.makespan_s) for option in front.options]


def with_deadline(tree: GroundedTree, deadline_s: float) -> GroundedTree:
    """The same, due as a whole."""
    return replace(tree, nodes=(replace(tree.nodes[0], deadline_s=deadline_s), *tree.nodes[1:]))
