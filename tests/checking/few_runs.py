"""The quick scheduler with as few runs as it can do with: for plans that need to be sound, and not short."""

from __future__ import annotations

from missiontree.mission.alternative import Alternative
from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.mission.terms import NO_TERMS, Terms
from missiontree.scheduling.greedy import read_problem
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.runs import Runs
from missiontree.scheduling.writing import found_schedule, impossible_schedule, unknown_schedule


def few_runs(
    tree: GroundedTree,
    alternative: Alternative,
    fleet: Fleet,
    scene: Scene,
    control: Control,
    terms: Terms = NO_TERMS,
) -> Schedule:
    """Schedule an alternative, see :class:`missiontree.scheduling.scheduler.Scheduler`."""
    problem = read_problem(tree, alternative, terms.team_of(fleet), scene, terms)
    if not isinstance(problem, Problem):
        return impossible_schedule(alternative, *problem)
    runs = Runs(problem, alternative, control)
    runs.go(1, anyway=True)
    if runs.best is None:
        return unknown_schedule(problem, alternative, runs.failures)
    return found_schedule(problem, alternative, runs.best, None)
