"""What an allocator lost of the best alternatives that are known, in number and in utility."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from missiontree.mission.alternative import Alternative, Ranking

MANY = 6
"""Utilities that a cell of a table shows."""


class Loss(NamedTuple):
    """
    What one ranking lacks of the k best.

    Parameters
    ----------
    lost
        Alternatives among the k best that it does not list, best first.
    best_loss
        How much less utility its best alternative has than the best that is known, at least 0. None if it lists none, and there is one.
    """

    lost: tuple[Alternative, ...]
    best_loss: float | None

    @property
    def shown(self) -> str:
        """``best_loss`` as a table says it: empty if nothing was lost, all if everything was."""
        if self.best_loss is None:
            return "all"
        return f"{self.best_loss:g}" if self.lost else ""


def loss_of(ranking: Ranking, rankings: Iterable[Ranking], k: int) -> Loss:
    """
    What a ranking lacks of the k best alternatives that any of several lists; an exact one's list is the last word.

    Parameters
    ----------
    ranking
        That is judged.
    rankings
        Of one tree by several allocators, this one's among them.
    k
        How many alternatives were asked for.
    """
    every = tuple(rankings)
    exact = [other for other in every if other.status == "exact"]
    known = {one.choices: one for other in exact or every for one in other.alternatives}
    best = sorted(known.values(), key=lambda one: (-one.utility, one.rank))[:k]
    found = {alternative.choices for alternative in ranking.alternatives}
    lost = tuple(alternative for alternative in best if alternative.choices not in found)
    if not best:
        return Loss((), 0.0)
    own = max((alternative.utility for alternative in ranking.alternatives), default=None)
    return Loss(lost, None if own is None else max(0.0, round(best[0].utility - own, 6)))


def utilities_shown(alternatives: Iterable[Alternative]) -> str:
    """Utilities in a cell of a table, the first few of them."""
    utilities = [f"{alternative.utility:g}" for alternative in alternatives]
    return ", ".join(utilities[:MANY]) + (", …" if len(utilities) > MANY else "")
