"""
The k best by mean utility, exactly, by searches for the k best sums.

A mean is a ratio, and Dinkelbach ("On nonlinear fractional programming", 1967) makes sums of it: with a guess p/q at the k-th best mean,
an action of utility u counts q * u - p, and an alternative of n actions then q * n * (its mean - p/q). If the k-th best such sum is above
0, k alternatives have a better mean than the guess, and the worst of them is the next guess. If it is 0, fewer than k are better than the
guess and all of them are listed, and those that are equal to it stand in the order of their choices: the list is proven. Guesses rise after
the second, so there are few of them. They are fractions, so that nothing hangs on rounding.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction

from missiontree.allocation.allocator import Allocator
from missiontree.allocation.flat import Flat, flatten
from missiontree.allocation.idleness import idle_part, idle_ways
from missiontree.allocation.measure import bound_of
from missiontree.allocation.narrowing import fewest_leaves, valued
from missiontree.allocation.possible import structurally_possible
from missiontree.allocation.roster import Roster
from missiontree.allocation.writing import require_count
from missiontree.mission.alternative import Ranking
from missiontree.mission.control import Control, silent
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree

METHOD = "dinkelbach"
FIRST_SHARE = 0.5  # of the time, for the first guess


@dataclass(frozen=True, slots=True)
class MeanKBest:
    """
    Ranks by mean utility.

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
        search = _Search(flat, k, control)

        def k_best(problem: Flat, share: float) -> Ranking:
            quiet = replace(control.part(share), report=silent)
            return self.by_sum(problem, fleet, weights, k + search.idle, quiet)

        if search.idle:
            ranking = k_best(idle_part(flat), 1.0)
            search.roster.take(ranking)
            if ranking.certificate.claim != "proven":
                return search.roster.stopped(ranking, max(search.bound, Fraction(0)))
        guess, share = Fraction(0), FIRST_SHARE
        while True:
            ranking = k_best(around(flat, guess), share)
            taken = search.roster.take(ranking)
            if ranking.certificate.claim != "proven":
                search.bound_by(guess, ranking)
                again = search.next_guess if share == FIRST_SHARE and not control.ended() else None
                if again is None or again == guess:
                    return search.roster.stopped(ranking, search.bound)
                guess = again
            elif not taken:
                return ranking
            elif len(taken) < k + search.idle or search.roster.kth == guess:
                return search.roster.finished(ranking)
            else:
                assert search.next_guess is not None
                guess = search.next_guess
            share = 1.0


def around(flat: Flat, guess: Fraction) -> Flat:
    """The problem whose sums are above 0 where the mean is above the guess, in millionths, and 0 where it is equal to it."""
    return valued(flat, lambda leaf: guess.denominator * flat.utility[leaf] - guess.numerator)


class _Search:
    """What is known of one problem."""

    def __init__(self, flat: Flat, k: int, control: Control) -> None:
        self.roster = Roster(flat, "mean", k, METHOD, control)
        self.idle = idle_ways(flat)
        self.bound = Fraction(_highest(flat))
        self._fewest = fewest_leaves(flat)

    @property
    def next_guess(self) -> Fraction | None:
        """The k-th best mean so far, or the worst if there are fewer; None if there is none."""
        best = self.roster.best()
        return best[-1].worth if best else None

    def bound_by(self, guess: Fraction, ranking: Ranking) -> None:
        """What the bound on the sums of a search that was stopped says of means."""
        bound = ranking.certificate.bound
        if bound is not None:
            over = max(Fraction(0), bound_of(bound)) / (guess.denominator * self._fewest)
            self.bound = min(self.bound, max(guess + over, Fraction(0)) if self.idle else guess + over)


def _highest(flat: Flat) -> int:
    """No mean is above the highest utility of an action that can be done; 0 if there is none."""
    possible = structurally_possible(flat)
    return max(
        (flat.utility[node] for node, kind in enumerate(flat.kind) if kind == "action" and possible[node]), default=0
    )
