"""Is there any schedule of an alternative? The first that greedy runs find; where they find none, constraint programming is asked."""

from __future__ import annotations

from dataclasses import replace

from missiontree.mission.alternative import Alternative
from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.mission.terms import Terms
from missiontree.scheduling import SCHEDULERS
from missiontree.scheduling.greedy import read_problem
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.runs import best_of_runs
from missiontree.scheduling.writing import found_schedule, impossible_schedule

WORKING = frozenset({"optimal", "feasible"})
THOROUGH = "auto"
"""Scheduler that is asked where the quick one proves nothing."""


def any_schedule(
    tree: GroundedTree, alternative: Alternative, fleet: Fleet, scene: Scene, control: Control, terms: Terms
) -> Schedule:
    """A schedule that works, whatever its makespan; else the proof that there is none, or that nothing is known."""
    problem = read_problem(tree, alternative, terms.team_of(fleet), scene, terms)
    if not isinstance(problem, Problem):
        return impossible_schedule(alternative, *problem)
    best, _ = best_of_runs(problem, alternative, control, replace(control, time_limit_s=0.0))
    if best is not None:
        return found_schedule(problem, alternative, best)
    return SCHEDULERS[THOROUGH](tree, alternative, fleet, scene, control, terms)
