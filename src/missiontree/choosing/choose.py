"""What a mission's objective chooses, and its front: the door of this package."""

from __future__ import annotations

from typing import NamedTuple

from missiontree.choosing.drawing import Draws
from missiontree.choosing.fronts import front_of
from missiontree.choosing.objectives import best_then_fastest, fastest
from missiontree.choosing.trying import MOST_SCHEDULED, Trials
from missiontree.choosing.weighing import weightiest
from missiontree.mission.alternative import Ranking
from missiontree.mission.brief import MissionBrief
from missiontree.mission.control import Control
from missiontree.mission.front import Chosen, Front
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.objective import WEIGHTED
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.scheduling.scheduler import Scheduler


class Choice(NamedTuple):
    """
    What came out.

    Parameters
    ----------
    chosen
        By the objective; None if that is utility alone, or nothing has a schedule.
    front
        None if it was not asked for, or nothing has a schedule.
    """

    chosen: Chosen | None = None
    front: Front | None = None


NOTHING = Choice()


def choose(
    tree: GroundedTree,
    brief: MissionBrief,
    scene: Scene,
    scheduler: Scheduler,
    control: Control,
    ranking: Ranking,
    schedules: tuple[Schedule, ...],
    front: bool = False,
    most: int = MOST_SCHEDULED,
) -> Choice:
    """
    Weigh alternatives with their schedules.

    Parameters
    ----------
    tree, brief, scene
        The mission over its fleet, and the scene with what was introduced.
    scheduler
        What makes schedules.
    control
        Limits; what is found by then is kept.
    ranking, schedules
        What is known already.
    front
        Whether the utility-makespan front is sought. Default false.
    most
        How many alternatives are scheduled at most, beside what is known; 25 times as many are looked at. Default 200.
    """
    draws, trials = Draws(tree, brief, control), Trials(tree, brief, scene, scheduler, control, most)
    trials.know(ranking.alternatives, schedules)
    seen = front_of(draws, trials) if front else None
    if brief.objective == "makespan":
        return Choice(fastest(draws, trials), seen)
    if brief.objective == "utility-makespan":
        return Choice(best_then_fastest(draws, trials), seen)
    if brief.objective in WEIGHTED:
        return Choice(weightiest(tree, brief, trials, control), seen)
    return Choice(front=seen)
