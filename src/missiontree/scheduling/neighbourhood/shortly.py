"""Large neighbourhood search for a moment: the same steps every time, and never many."""

from __future__ import annotations

from missiontree.mission.control import Control
from missiontree.scheduling.neighbourhood.search import Regrouping, regrouped
from missiontree.scheduling.problem import Draft
from missiontree.scheduling.runs import Runs

ROUNDS, ROUNDS_IN_ALL = 200, 10_000
"""Of taking roles out of tours and putting them in again; and the same times the roles of the mission."""


def regroup_shortly(runs: Runs, control: Control) -> None:
    """
    Search for a shorter draft than the best of some runs, whose place it takes.

    Parameters
    ----------
    runs
        With a best draft, or none yet.
    control
        Seed, and when to stop.
    """
    rounds = min(ROUNDS, ROUNDS_IN_ALL // max(1, len(runs.problem.graph.roles)))
    if runs.best is None or runs.shortest or not rounds:
        return

    def told(draft: Draft) -> None:
        runs.best = draft
        runs.tell()

    runs.best = regrouped(runs.problem, runs.best, Regrouping(control.seed, rounds), control.ended, told)
