"""The oracle for other aims than the plain one: all alternatives written out and put in the aim's order, and no team twice if so asked."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from fractions import Fraction

from missiontree.allocation.exhaustive import Exhaustive
from missiontree.allocation.flat import Flat, flatten
from missiontree.allocation.measure import leaves_of, places_of, team_of, told, worth_of
from missiontree.allocation.writing import require_count
from missiontree.mission.aim import Aim
from missiontree.mission.alternative import Alternative, Ranking
from missiontree.mission.control import Control
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree

EVERYTHING = 10**9


@dataclass(frozen=True, slots=True)
class Enumerated:
    """
    Sorts what enumeration finds.

    Parameters
    ----------
    aim
        What is asked for.
    enumerate_all
        Lists all alternatives.
    """

    aim: Aim
    enumerate_all: Exhaustive = field(default_factory=Exhaustive)

    def __call__(self, tree: GroundedTree | Flat, fleet: Fleet, weights: Weights, k: int, control: Control) -> Ranking:
        """See :class:`missiontree.allocation.allocator.Allocator`."""
        require_count(k)
        flat = flatten(tree, fleet, weights)
        ranking = self.enumerate_all(flat, fleet, weights, EVERYTHING, control)
        entries = [(*self._order(flat, one), one) for one in ranking.alternatives]
        entries.sort(key=lambda entry: entry[:2])
        listed: list[Alternative] = []
        teams: set[frozenset[str]] = set()
        for lack, _, one in entries:
            if len(listed) < k and not (self.aim.diverse and team_of(one) in teams):
                listed.append(_ranked(one, len(listed) + 1, -lack))
                teams.add(team_of(one))
        full = ranking.certificate.claim == "proven" and len(listed) == k
        certificate = replace(ranking.certificate, bound=listed[-1].utility if full else None)
        return replace(ranking, alternatives=tuple(listed), certificate=certificate)

    def _order(self, flat: Flat, one: Alternative) -> tuple[Fraction, tuple[int, ...]]:
        return -worth_of(flat, leaves_of(flat, one), self.aim.accumulate), places_of(flat, one)


def _ranked(alternative: Alternative, rank: int, worth: Fraction) -> Alternative:
    own = alternative.certificate
    bound = told(worth) if own.claim == "proven" else None
    return replace(alternative, rank=rank, utility=told(worth), certificate=replace(own, bound=bound))
