"""What several searches over one problem listed, in the order of its own aim, and what may be claimed of that when they end."""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction

from missiontree.allocation.flat import Flat
from missiontree.allocation.measure import leaves_of, places_of, told, told_bound, worth_of
from missiontree.mission.aim import Accumulate
from missiontree.mission.alternative import Alternative, Choice, Ranking
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control, Progress


@dataclass(frozen=True, slots=True)
class Entry:
    """
    One alternative.

    Parameters
    ----------
    worth
        In millionths.
    places
        Choice indices in preorder, which order equals.
    leaves
        How many actions it has.
    alternative
        As a search listed it; of it only choices, roles and robots still hold.
    decided
        Whether it is known that robots can fill it.
    """

    worth: Fraction
    places: tuple[int, ...]
    leaves: int
    alternative: Alternative
    decided: bool

    @property
    def order(self) -> tuple[Fraction, tuple[int, ...]]:
        """Higher worth first, then choice indices."""
        return -self.worth, self.places


class Roster:
    """
    Collects what searches list.

    Parameters
    ----------
    flat
        The problem with its own utilities.
    accumulate
        What an alternative is worth.
    k
        How many are wanted.
    method
        What stands in certificates.
    control
        Whom to tell of progress.
    """

    def __init__(self, flat: Flat, accumulate: Accumulate, k: int, method: str, control: Control) -> None:
        self.flat, self.accumulate, self.k, self.method = flat, accumulate, k, method
        self.examined = 0
        self._control, self._entries = control, dict[tuple[Choice, ...], Entry]()

    def take(self, ranking: Ranking) -> list[Entry]:
        """Take up what a search lists; its entries, in that search's order."""
        taken = []
        for alternative in ranking.alternatives:
            if alternative.choices not in self._entries:
                self._entries[alternative.choices] = self.entry(alternative)
            taken.append(self._entries[alternative.choices])
        self.examined += ranking.examined
        self._control.report(Progress("allocation", self.examined, len(self._entries)))
        return taken

    def entry(self, alternative: Alternative) -> Entry:
        """An alternative as this problem sees it."""
        leaves = leaves_of(self.flat, alternative)
        worth = worth_of(self.flat, leaves, self.accumulate)
        decided = alternative.certificate.claim != "unproven"
        return Entry(worth, places_of(self.flat, alternative), len(leaves), alternative, decided)

    def best(self) -> list[Entry]:
        """The k best so far, in order."""
        return sorted(self._entries.values(), key=lambda entry: entry.order)[: self.k]

    @property
    def kth(self) -> Fraction | None:
        """Worth of the k-th best so far; None if there are fewer."""
        best = self.best()
        return best[-1].worth if len(best) == self.k else None

    def finished(self, last: Ranking) -> Ranking:
        """The list holds the k best, or all there are; ``last`` is the search that showed it."""
        best = self.best()
        decided = all(entry.decided for entry in best)
        full = len(best) == self.k
        detail = "Nothing that is not listed is better than the bound." if full else "There are no more alternatives."
        certificate = replace(
            last.certificate,
            claim="proven",
            method=self.method,
            bound=told(best[-1].worth) if full else None,
            detail=detail,
        )
        return Ranking(
            alternatives=tuple(self._written(best, None)),
            status="exact" if decided else "partial",
            certificate=certificate,
            examined=self.examined,
            reasons=last.reasons,
        )

    def stopped(self, last: Ranking, bound: Fraction) -> Ranking:
        """Stopped early in the search ``last``; nothing that no search listed is worth more than the bound."""
        best = self.best()
        if len(best) == self.k and best[-1].worth > bound:
            return self.finished(replace(last, certificate=Certificate(claim="proven", method=self.method)))
        left = max(bound, best[-1].worth) if len(best) == self.k else bound
        detail = "Stopped early; nothing that is not listed is better than the bound."
        certificate = replace(
            last.certificate, claim="bounded", method=self.method, bound=told_bound(left), detail=detail
        )
        return Ranking(
            alternatives=tuple(self._written(best, bound)),
            status="partial" if best else "unknown",
            certificate=certificate,
            examined=self.examined,
            reasons=last.reasons,
        )

    def _written(self, best: list[Entry], bound: Fraction | None) -> list[Alternative]:
        """The list; without a bound everything that is not in it stands behind it."""
        alternatives, proven = [], True
        for rank, entry in enumerate(best, start=1):
            proven = proven and entry.decided and (bound is None or entry.worth > bound)
            alternatives.append(
                replace(
                    entry.alternative,
                    rank=rank,
                    utility=told(entry.worth),
                    certificate=self._certificate(entry, proven, bound),
                )
            )
        return alternatives

    def _certificate(self, entry: Entry, proven: bool, bound: Fraction | None) -> Certificate:
        above = entry.worth if bound is None else max(bound, entry.worth)
        if proven:
            return Certificate(claim="proven", method=self.method, bound=told(entry.worth))
        if not entry.decided:
            detail = "Whether the robots' budgets can be kept was not decided."
            return replace(entry.alternative.certificate, method=self.method, bound=told_bound(above), detail=detail)
        if bound is None:
            detail = "Feasible, and nothing better is missing from the list; an undecided one stands before it."
        else:
            detail = f"Feasible; what is not listed is better by {told_bound(above - entry.worth):g} at most."
        return Certificate(claim="bounded", method=self.method, bound=told_bound(above), detail=detail)
