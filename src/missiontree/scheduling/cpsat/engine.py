"""
The scheduler ``cpsat``: bounds first, then a greedy schedule, then constraint programming, and a proof that does not rest on it.

If the greedy schedule is as short as a lower bound, nothing is solved. Else the model is solved from there on, for the least makespan,
then the least travel, then the least sum of ends; every answer is replayed by our own means before it counts. That a schedule is optimal
is said only if our own bound, an enumeration, or a second formulation of another kind confirms it; else it is the solver's word.
"""

from __future__ import annotations

from missiontree.mission.alternative import Alternative
from missiontree.mission.control import Control
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.mission.terms import NO_TERMS, Terms
from missiontree.scheduling.cpsat.improving import MANY_ROLES, Improving
from missiontree.scheduling.cpsat.settings import Settings
from missiontree.scheduling.greedy import read_problem
from missiontree.scheduling.neighbourhood.shortly import ROUNDS_IN_ALL
from missiontree.scheduling.problem import Problem
from missiontree.scheduling.runs import MAX_RUNS, Runs
from missiontree.scheduling.settling import settled
from missiontree.scheduling.writing import found_schedule, impossible_schedule, no_schedule

GREEDY_SHARE = 0.2  # of the time, for greedy runs beyond the first that succeeds
GREEDY_RUNS = 6  # in missions of few roles, for which the solver does more; in others, before anything else is tried
CPSAT = Settings(longest_s=30.0)
"""Half a minute for each alternative, at most."""
AUTO = Settings(
    longest_s=1.0, largest=20_000, deterministic=True, tidy=False, last_steps=4_000, regrouping=ROUNDS_IN_ALL, spanned=0
)
"""A second at most, and the same answer every time."""


def cpsat(
    tree: GroundedTree,
    alternative: Alternative,
    fleet: Fleet,
    scene: Scene,
    control: Control,
    terms: Terms = NO_TERMS,
) -> Schedule:
    """Schedule an alternative, see :class:`missiontree.scheduling.scheduler.Scheduler`."""
    return schedule_within(tree, alternative, fleet, scene, control, terms, CPSAT)


def auto(
    tree: GroundedTree,
    alternative: Alternative,
    fleet: Fleet,
    scene: Scene,
    control: Control,
    terms: Terms = NO_TERMS,
) -> Schedule:
    """Greedy, and constraint programming where that leaves a gap and the model is small; see :func:`cpsat`."""
    return schedule_within(tree, alternative, fleet, scene, control, terms, AUTO)


def schedule_within(
    tree: GroundedTree,
    alternative: Alternative,
    fleet: Fleet,
    scene: Scene,
    control: Control,
    terms: Terms,
    settings: Settings,
) -> Schedule:
    """Schedule an alternative within limits of one's own."""
    problem = read_problem(tree, alternative, terms.team_of(fleet), scene, terms)
    if not isinstance(problem, Problem):
        return impossible_schedule(alternative, *problem)
    small = len(problem.graph.roles) < MANY_ROLES and not problem.chargers  # the model knows nothing of refilling
    runs = Runs(problem, alternative, control, control.part(GREEDY_SHARE))
    runs.go(GREEDY_RUNS, anyway=True)
    if runs.best is None:
        # Where there is no schedule, runs without end find none, and trying everything out may soon say so.
        proof = settled(runs, settings.first_steps, control.ended)
        if runs.best is None and proof is not None:
            return no_schedule(alternative, proof, runs.failures)
    runs.go(GREEDY_RUNS if small else MAX_RUNS)
    runs.refill_for_tours()
    if runs.shortest:
        assert runs.best is not None
        return found_schedule(problem, alternative, runs.best)
    return Improving(problem, alternative, control, settings, runs.best, runs.failures)()
