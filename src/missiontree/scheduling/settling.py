"""Whether trying everything out settles what greedy runs came to."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from missiontree.mission.certificate import Certificate
from missiontree.scheduling.enumeration.proving import tried_out
from missiontree.scheduling.horizon import horizon_of
from missiontree.scheduling.runs import Runs


def settled(runs: Runs, most_steps: int, ended: Callable[[], bool]) -> Certificate | None:
    """
    Try everything out that could be better than the best of some runs, which takes its place if it is.

    Parameters
    ----------
    runs
        With a best draft, or none yet.
    most_steps, ended
        See :func:`missiontree.scheduling.enumeration.proving.tried_out`.

    Returns
    -------
    Certificate or None
        The proof that nothing is better, or that there is no schedule; None if that was too much to try.
    """
    before = runs.best
    runs.best, proof = tried_out(runs.problem, before, partial(horizon_of, runs.problem), most_steps, ended)
    if runs.best is not before:
        runs.tell()
    return proof
