"""Is there any schedule of an alternative? The first that is found; where little effort finds none and no proof, all methods are asked."""

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
from missiontree.scheduling.runs import MAX_RUNS, Runs
from missiontree.scheduling.settling import settled
from missiontree.scheduling.writing import found_schedule, impossible_schedule, no_schedule, unknown_schedule

WORKING = frozenset({"optimal", "feasible"})
FIRST_RUNS = 4
FEW_STEPS, STEPS_AND_LEAVES = 2_000, 15_000
"""Steps of trying everything out, and those times the actions: a step takes longer, the more there are."""
MOST_THOROUGH = 40
"""Actions beyond which it takes seconds to ask all methods, for little more."""
THOROUGH = "auto"
"""Scheduler that is asked where the quick one proves nothing."""


def any_schedule(
    tree: GroundedTree, alternative: Alternative, fleet: Fleet, scene: Scene, control: Control, terms: Terms
) -> Schedule:
    """A schedule that works, whatever its makespan; else the proof that there is none, or that nothing is known."""
    problem = read_problem(tree, alternative, terms.team_of(fleet), scene, terms)
    if not isinstance(problem, Problem):
        return impossible_schedule(alternative, *problem)
    runs = Runs(problem, alternative, control, replace(control, time_limit_s=0.0))
    runs.go(FIRST_RUNS, anyway=True)
    proof = None
    if runs.best is None:
        steps = min(FEW_STEPS, STEPS_AND_LEAVES // len(problem.graph.activities))
        proof = settled(runs, steps, control.ended)
    if runs.best is None and proof is None:
        runs.go(MAX_RUNS)
    if runs.best is not None:
        return found_schedule(problem, alternative, runs.best)
    if proof is not None:
        return no_schedule(alternative, proof, runs.failures)
    if len(problem.graph.activities) > MOST_THOROUGH:
        return unknown_schedule(problem, alternative, runs.failures)
    return SCHEDULERS[THOROUGH](tree, alternative, fleet, scene, control, terms)
