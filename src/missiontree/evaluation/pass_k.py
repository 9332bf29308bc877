"""How likely k runs out of k are right: pass^k."""

from __future__ import annotations

from collections.abc import Iterable
from math import comb


def pass_hat(runs: int, right: int, k: int) -> float:
    """
    Estimate the chance that k runs of one mission are all right, from ``right`` of ``runs``.

    The unbiased estimator C(right, k) / C(runs, k) of Yao et al., "τ-bench" (arXiv 2406.12045): the share of all choices of k runs
    that hold right ones alone. With k = 1 it is the share of right runs.

    Raises
    ------
    ValueError
        Unless 1 <= k <= runs and 0 <= right <= runs.
    """
    if not (1 <= k <= runs and 0 <= right <= runs):
        raise ValueError(f"pass^{k} needs at least {max(k, 1)} runs, of which {right} are right; there are {runs}.")
    return comb(right, k) / comb(runs, k)


def mean_pass(counts: Iterable[tuple[int, int]]) -> tuple[float, ...]:
    """
    pass^1, pass^2 and so on, averaged over missions, as far as every mission has the runs for it.

    Parameters
    ----------
    counts
        Runs and right runs of each mission.
    """
    missions = tuple(counts)
    most = min((runs for runs, _ in missions), default=0)
    return tuple(sum(pass_hat(runs, right, k) for runs, right in missions) / len(missions) for k in range(1, most + 1))
