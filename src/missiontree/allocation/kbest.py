"""
The k best alternatives, exactly: a stream of candidates, best first, and a referee who sees them in order.

The first k of the stream that keep all rules are the k best, and that is their proof. Whatever stops the search earlier, the
next candidate's utility is a bound on everything not listed.
"""

from __future__ import annotations

from dataclasses import dataclass

from missiontree.allocation.coupling import couples
from missiontree.allocation.feasibility import DEFAULT_STEPS, Feasibility, Verdict
from missiontree.allocation.flat import Flat, flatten
from missiontree.allocation.item import Item, choices_of
from missiontree.allocation.possible import Possibility, possible_nodes, reasons_of
from missiontree.allocation.refusals import Refusals
from missiontree.allocation.selection import select
from missiontree.allocation.streams import best_first, stream_of
from missiontree.allocation.writing import FREE, Writer, impossible, no_robot_able, require_count
from missiontree.mission.alternative import Alternative, Ranking, RankingStatus
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control, Progress
from missiontree.mission.estimate import MICRO, Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree

METHOD = "lazy_k_best"
REPORT_EVERY = 256


@dataclass(frozen=True, slots=True)
class ExactKBest:
    """
    The default allocator.

    Parameters
    ----------
    max_examined
        Candidates looked at before the search is given up. Default 200,000.
    packing_steps
        Steps of packing per candidate and robot type before a candidate is kept as undecided. Default 20,000.
    """

    max_examined: int = 200_000
    packing_steps: int = DEFAULT_STEPS

    def __call__(self, tree: GroundedTree, fleet: Fleet, weights: Weights, k: int, control: Control) -> Ranking:
        """See :class:`missiontree.allocation.allocator.Allocator`."""
        require_count(k)
        flat = flatten(tree, fleet, weights)
        possibility = possible_nodes(flat)
        stream = stream_of(flat, possibility.possible)
        if stream is None:
            reasons = reasons_of(flat, possibility, "error") or no_robot_able(flat)
            return impossible("least_use", "No selection stays within what there is.", reasons)
        search = _Search(flat, possibility, k, self.packing_steps, control)
        for item in best_first(stream):
            if control.ended() or search.examined == self.max_examined:
                return search.stopped(item.utility)
            search.look_at(item)
            if search.full:
                break
        return search.finished()


class _Search:
    """What was found and refused so far."""

    def __init__(self, flat: Flat, possibility: Possibility, k: int, steps: int, control: Control) -> None:
        self.flat, self.possibility, self.k, self.control = flat, possibility, k, control
        self.referee = Feasibility(flat, steps) if couples(flat) else None
        self.writer = Writer(flat)
        self.found: list[Alternative] = []
        self.refusals = Refusals()
        self.examined = 0
        self.undecided = 0

    @property
    def full(self) -> bool:
        """Whether k are found."""
        return len(self.found) == self.k

    def look_at(self, item: Item) -> None:
        """Let the referee decide the next candidate."""
        selection = select(self.flat, choices_of(item), self.possibility.possible)
        verdict = self.referee.decide(selection) if self.referee is not None else FREE
        self.examined += 1
        if verdict.answer == "no":
            self.refusals.add(verdict.reason)
        else:
            certificate = self._certificate(item, verdict)
            rank = len(self.found) + 1
            self.found.append(self.writer.alternative(rank, item.utility, selection, verdict, certificate))
        if self.examined % REPORT_EVERY == 0:
            self._report(item.utility)

    def _certificate(self, item: Item, verdict: Verdict) -> Certificate:
        bound = item.utility / MICRO
        if verdict.answer == "undecided":
            self.undecided += 1
            detail = "Whether the robots' budgets can be kept was not decided; nothing better is missing from the list."
            return Certificate(claim="unproven", method=METHOD, bound=bound, detail=detail)
        if self.undecided:
            detail = "Feasible, and nothing better is missing from the list; an undecided one stands before it."
            return Certificate(claim="bounded", method=METHOD, bound=bound, detail=detail)
        return Certificate(claim="proven", method=METHOD, bound=bound)

    def _report(self, utility: int) -> None:
        self.control.report(Progress("allocation", self.examined, len(self.found), utility / MICRO))

    def stopped(self, next_utility: int) -> Ranking:
        """Stopped before the end; the next candidate bounds what is not listed."""
        detail = "Stopped early; nothing that is not listed is better than the bound."
        certificate = Certificate(claim="bounded", method=METHOD, bound=next_utility / MICRO, detail=detail)
        self._report(next_utility)
        return self._ranking("partial" if self.found else "unknown", certificate)

    def finished(self) -> Ranking:
        """K are found, or there are no more."""
        if not self.found:
            detail = f"All {self.examined} candidates were refused."
            reasons = reasons_of(self.flat, self.possibility, "error") + self.refusals.summary("error")
            return impossible(METHOD, detail, reasons, self.examined)
        last = round(self.found[-1].utility * MICRO)
        self._report(last)
        bound = last / MICRO if self.full else None
        detail = (
            "Nothing that is not listed is better than the bound." if self.full else "There are no more alternatives."
        )
        certificate = Certificate(claim="proven", method=METHOD, bound=bound, detail=detail)
        return self._ranking("partial" if self.undecided else "exact", certificate)

    def _ranking(self, status: RankingStatus, certificate: Certificate) -> Ranking:
        return Ranking(
            alternatives=tuple(self.found),
            status=status,
            certificate=certificate,
            examined=self.examined,
            reasons=reasons_of(self.flat, self.possibility, "notice") + self.refusals.summary("notice"),
        )
