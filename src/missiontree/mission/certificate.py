"""What is known of a result, by which method, with which bound. Stands in every result from the start."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from missiontree.mission.search_limit import SearchLimit
from missiontree.mission.value import Id, Value

Claim = Literal["proven", "bounded", "solver_word", "unproven"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Certificate(Value):
    """
    The proof, or the lack of one, behind a result.

    Parameters
    ----------
    claim
        ``proven``: the result is what it is said to be (the k-th best, the optimum, infeasible). ``bounded``: nothing better than
        ``bound`` exists. ``solver_word``: the same, but a solver says so and nothing confirms it, neither a bound nor a second
        method; for schedules only. ``unproven``: it was found, nothing more is known.
    method
        How it is known, such as ``lazy_k_best``, ``critical_path`` or ``enumeration``.
    bound
        No utility above it (alternatives), no makespan in seconds below it (schedules); None if no bound is known.
    detail
        A sentence for the reader.
    limit
        What ended the search before it was done; None if nothing did. A proof needs none.
    seed
        Seed of that search; None where nothing hangs on it, since a search that is done finds the same with every seed.
    """

    claim: Claim
    method: Id
    bound: float | None = None
    detail: str = ""
    limit: SearchLimit | None = None
    seed: int | None = None
