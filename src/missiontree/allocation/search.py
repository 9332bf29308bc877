"""What a search for the k best found and refused so far, and what may be claimed of it whenever it ends."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.allocation.feasibility import Feasibility, Verdict
from missiontree.allocation.flat import Flat
from missiontree.allocation.pool import Pool, Pooled
from missiontree.allocation.possible import Possibility, reasons_of
from missiontree.allocation.refusals import Refusals
from missiontree.allocation.selection import Selection
from missiontree.allocation.writing import FREE, Parts, Writer, impossible
from missiontree.mission.alternative import Alternative, Ranking, RankingStatus
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control, Progress
from missiontree.mission.estimate import MICRO
from missiontree.mission.search_limit import SearchLimit

METHOD = "lazy_k_best"
BY_BOUNDS = "branch_and_bound"
POOLED = "pool"
REPORT_EVERY = 256


class Search:
    """
    One search; candidates must be shown in the order of alternatives, without a gap.

    Parameters
    ----------
    flat, possibility
        The problem.
    referee
        Who decides candidates; None if nothing couples the choices.
    k
        How many are wanted.
    control
        Whom to tell of progress.
    """

    def __init__(
        self, flat: Flat, possibility: Possibility, referee: Feasibility | None, k: int, control: Control
    ) -> None:
        self.flat, self.possibility, self.referee, self.k, self.control = flat, possibility, referee, k, control
        self.pool = Pool(flat, possibility.possible, referee, k)
        self.found: list[Alternative] = []
        self.examined = 0
        self.method = METHOD
        self.bound: int | None = None
        self._writer, self._refusals, self._undecided = Writer(flat), Refusals(), 0

    @property
    def full(self) -> bool:
        """Whether k are found."""
        return len(self.found) == self.k

    @property
    def refused(self) -> int:
        """How many candidates the referee refused."""
        return self.examined - len(self.found)

    def bound_by(self, utility: int | None) -> None:
        """Nothing that was not looked at has more utility (millionths); None if that is not known."""
        if utility is not None:
            self.bound = utility if self.bound is None else min(self.bound, utility)

    def look_at(self, utility: int, selection: Selection) -> None:
        """Let the referee decide the next candidate."""
        self._take(utility, selection, self.referee.decide(selection) if self.referee is not None else FREE)

    def list_next(self, utility: int, parts: Parts) -> None:
        """Take up the next candidate of a problem that nothing couples; its choices and roles are written already."""
        self.examined += 1
        certificate = self._certificate(utility, FREE)
        self.found.append(self._writer.of_parts(len(self.found) + 1, utility, parts, FREE, certificate))
        if self.examined % REPORT_EVERY == 0:
            self._report(utility)

    def look_at_all(self, entries: Sequence[Pooled]) -> None:
        """Take up candidates that were decided already, in their order; those that were looked at before are known."""
        listed = {tuple((choice.xor, choice.child) for choice in alternative.choices) for alternative in self.found}
        for entry in entries:
            if self.full:
                return
            if entry.selection.choices not in listed:
                self._take(entry.utility, entry.selection, entry.verdict)

    def _take(self, utility: int, selection: Selection, verdict: Verdict) -> None:
        self.examined += 1
        if verdict.answer == "no":
            self._refusals.add(verdict.reason)
        else:
            certificate = self._certificate(utility, verdict)
            rank = len(self.found) + 1
            self.found.append(self._writer.alternative(rank, utility, selection, verdict, certificate))
            self.pool.add(utility, selection, verdict)
        if self.examined % REPORT_EVERY == 0:
            self._report(utility)

    def _certificate(self, utility: int, verdict: Verdict) -> Certificate:
        bound = utility / MICRO
        if verdict.answer == "undecided":
            self._undecided += 1
            detail = "Whether the robots' budgets can be kept was not decided; nothing better is missing from the list."
            limit = SearchLimit("steps", self.referee.steps) if self.referee is not None else None
            return Certificate(claim="unproven", method=self.method, bound=bound, detail=detail, limit=limit)
        if self._undecided:
            detail = "Feasible, and nothing better is missing from the list; an undecided one stands before it."
            return Certificate(claim="bounded", method=self.method, bound=bound, detail=detail)
        return Certificate(claim="proven", method=self.method, bound=bound)

    def _report(self, utility: int) -> None:
        self.control.report(Progress("allocation", self.examined, len(self.found), utility / MICRO))

    def stopped(self, limit: SearchLimit) -> Ranking:
        """Stopped before the end by a limit; the list goes on with the pool, and the bound holds for what is not listed."""
        assert self.bound is not None
        self._go_on_with_the_pool(self.bound)
        detail = "Stopped early; nothing that is not listed is better than the bound."
        certificate = Certificate(
            claim="bounded",
            method=self.method,
            bound=self.bound / MICRO,
            detail=detail,
            limit=limit,
            seed=self.control.seed,
        )
        self._report(self.bound)
        return self._ranking("partial" if self.found else "unknown", certificate)

    def _go_on_with_the_pool(self, bound: int) -> None:
        """What was looked at comes first in the order of alternatives, so that the pool's others stand below it."""
        listed = {tuple((choice.xor, choice.child) for choice in alternative.choices) for alternative in self.found}
        for entry in self.pool.listed():
            if self.full:
                return
            if entry.selection.choices not in listed and entry.verdict.answer == "yes":
                above = max(bound, entry.utility)
                gap = (above - entry.utility) / MICRO
                detail = f"Feasible; what is not listed is better by {gap:g} at most."
                certificate = Certificate(claim="bounded", method=POOLED, bound=above / MICRO, detail=detail)
                rank = len(self.found) + 1
                self.found.append(
                    self._writer.alternative(rank, entry.utility, entry.selection, entry.verdict, certificate)
                )

    def finished(self) -> Ranking:
        """K are found, or there are no more."""
        if not self.found:
            detail = f"All {self.examined} candidates were refused."
            if self.method == BY_BOUNDS:
                detail = f"No other way stays within the budgets, and all {self.examined} candidates were refused."
            reasons = reasons_of(self.flat, self.possibility, "error") + self._refusals.summary("error")
            return impossible(self.method, detail, reasons, self.examined)
        last = round(self.found[-1].utility * MICRO)
        self._report(last)
        bound = last / MICRO if self.full else None
        detail = (
            "Nothing that is not listed is better than the bound." if self.full else "There are no more alternatives."
        )
        certificate = Certificate(claim="proven", method=self.method, bound=bound, detail=detail)
        return self._ranking("partial" if self._undecided else "exact", certificate)

    def _ranking(self, status: RankingStatus, certificate: Certificate) -> Ranking:
        return Ranking(
            alternatives=tuple(self.found),
            status=status,
            certificate=certificate,
            examined=self.examined,
            reasons=reasons_of(self.flat, self.possibility, "notice") + self._refusals.summary("notice"),
        )
