"""
The k best by the least utility of an action, exactly, by searches for ways that use no action below a threshold.

An alternative's least utility is at or above a threshold if it does without every action below it. So the greatest threshold with k such
alternatives is that of the k-th best; it is found by halving (the bottleneck method of Edmonds and Fulkerson, "Bottleneck extrema", 1970).
Those above it are fewer than k and are all listed; those equal to it stand in the order of their choices, in which the searches list.
"""

from __future__ import annotations

from bisect import bisect_left
from dataclasses import dataclass, replace
from fractions import Fraction

from missiontree.allocation.allocator import Allocator
from missiontree.allocation.flat import Flat, flatten
from missiontree.allocation.idleness import idle_part, idle_ways
from missiontree.allocation.narrowing import highest_least, kept, valued
from missiontree.allocation.possible import structurally_possible
from missiontree.allocation.roster import Roster
from missiontree.allocation.writing import require_count
from missiontree.mission.alternative import Ranking
from missiontree.mission.control import Control, silent
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree

METHOD = "bottleneck"


@dataclass(frozen=True, slots=True)
class LeastKBest:
    """
    Ranks by the least utility of an action.

    Parameters
    ----------
    by_sum
        Finds the k best sums, exactly, equals in the order of their choices.
    """

    by_sum: Allocator

    def __call__(self, tree: GroundedTree | Flat, fleet: Fleet, weights: Weights, k: int, control: Control) -> Ranking:
        """See :class:`missiontree.allocation.allocator.Allocator`."""
        require_count(k)
        flat = flatten(tree, fleet, weights)
        idle, steps = idle_ways(flat), _Steps(flat)
        roster = Roster(flat, "min", k, METHOD, control)

        def in_order(problem: Flat) -> Ranking:
            quiet = replace(control.part(1.0), report=silent)
            return self.by_sum(valued(problem, lambda leaf: 0), fleet, weights, k + idle, quiet)

        if idle:
            ranking = in_order(idle_part(flat))
            roster.take(ranking)
            if ranking.certificate.claim != "proven":
                return roster.stopped(ranking, max(steps.bound, Fraction(0)))
        while not steps.settled:
            step = steps.next
            ranking = in_order(steps.problem(step))
            taken = roster.take(ranking)
            if ranking.certificate.claim != "proven":
                return roster.stopped(ranking, max(steps.bound, Fraction(0)) if idle else steps.bound)
            if step == 0 and not taken:
                return ranking
            acting = sorted((entry.worth for entry in taken if entry.leaves), reverse=True)
            if len(acting) >= k:
                steps.reach(step, acting[k - 1])
            elif step == 0:
                break  # these are all there are
            else:
                steps.exhaust(step)
        return roster.finished(ranking)


class _Steps:
    """Thresholds, and what is known of them."""

    def __init__(self, flat: Flat) -> None:
        possible = structurally_possible(flat)
        top = highest_least(flat, possible)
        acting = (node for node, kind in enumerate(flat.kind) if kind == "action")
        self._flat = flat
        self._levels = sorted({flat.utility[node] for node in acting if possible[node] and flat.utility[node] <= top})
        self._reached, self._exhausted = 0, max(1, len(self._levels))
        self._listed: set[int] = set()

    @property
    def settled(self) -> bool:
        """Whether the highest threshold that k alternatives reach is known, and which of those come first."""
        return self._exhausted - self._reached == 1 and self._reached in self._listed

    @property
    def next(self) -> int:
        """Index of the threshold to search at; first the lowest, which tells whether there are k at all."""
        return (self._reached + self._exhausted) // 2 if self._listed else 0

    def problem(self, step: int) -> Flat:
        """All alternatives that reach a threshold."""
        if not step:
            return self._flat
        return kept(self._flat, lambda leaf: self._flat.utility[leaf] >= self._levels[step])

    def reach(self, step: int, kth: Fraction) -> None:
        """At least k reach a threshold, and the first of them are known; the k-th best known is worth so much."""
        self._listed.add(step)
        self._reached = max(self._reached, step, bisect_left(self._levels, kth))

    def exhaust(self, step: int) -> None:
        """Fewer than k reach a threshold, and all of them are known."""
        self._exhausted = step

    @property
    def bound(self) -> Fraction:
        """Whatever is not known is worth no more."""
        return Fraction(self._levels[self._exhausted - 1]) if self._levels else Fraction(0)
