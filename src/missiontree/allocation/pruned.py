"""
The paper's Algorithm 1 (Gupta et al., arXiv 2501.16539, section III-C), kept faithful as the baseline.

From the leaves up, every node keeps its best ``rho`` ways. An XOR pools those of its children; an AND combines them child by
child, drops each combination that uses more than the declared budgets of a type or of the whole mission hold, and keeps ``rho``
after each child. *As printed* the AND forms the full product first and prunes once. Robots are reused, never used up.

Where the print differs from its intent, this code follows the intent: an AND with an impossible child is impossible (as printed
it returns one empty alternative), and resources are tested per combination, not once for the whole product.

Without coupling the result is exact: the best ``rho`` sums need only the best ``rho`` terms. With coupling a combination that
was pruned early may have been the one that fits later. And Algorithm 1 knows neither which robot of a type fills which role,
nor teams, nor links, nor how many robots may be in use, nor who must take part: what breaks those is dropped from its final list,
so the list is sound but may be short or empty, and nothing is claimed of what it lacks.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import product

from missiontree.allocation.coupling import couples
from missiontree.allocation.feasibility import Feasibility, Verdict
from missiontree.allocation.flat import Flat, flatten
from missiontree.allocation.item import Item, choices_of
from missiontree.allocation.possible import structurally_possible
from missiontree.allocation.refusals import Refusals
from missiontree.allocation.selection import select
from missiontree.allocation.writing import FREE, Writer, impossible, no_robot_able, require_count
from missiontree.mission.alternative import Alternative, Ranking
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control, Progress
from missiontree.mission.estimate import MICRO, Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.reason import Reason
from missiontree.mission.search_limit import SearchLimit

METHOD = "algorithm_1"

Uses = Mapping[int, int]
"""By number of the purse, in billionths."""


class Way(Item):
    """One way of doing a subtree, and what it uses of the declared budgets."""

    __slots__ = ("uses",)

    def __init__(self, utility: int, uses: Uses, first: Item | None = None, second: Item | None = None) -> None:
        super().__init__(utility, first, second)
        self.uses = uses


class _Stopped(Exception):
    """The work was ended from outside, or grew beyond its cap."""

    def __init__(self, reason: Reason, limit: SearchLimit) -> None:
        super().__init__(reason.message)
        self.reason, self.limit = reason, limit


@dataclass(frozen=True, slots=True)
class Pruned:
    """
    Algorithm 1 as an allocator.

    Parameters
    ----------
    rho
        Ways kept at every node; None (default) means k.
    as_printed
        Form the full product at every AND before pruning. Default false.
    max_product
        Combinations of one AND beyond which the printed form is given up. Default 200,000.
    """

    rho: int | None = None
    as_printed: bool = False
    max_product: int = 200_000

    def __call__(self, tree: GroundedTree | Flat, fleet: Fleet, weights: Weights, k: int, control: Control) -> Ranking:
        """See :class:`missiontree.allocation.allocator.Allocator`."""
        require_count(k)
        flat = flatten(tree, fleet, weights)
        if not structurally_possible(flat)[0]:
            return impossible(METHOD, "A part of the mission has no way of being done.", no_robot_able(flat))
        rho = self.rho or k
        try:
            ways = _Combiner(flat, rho, self, control).ways_of_root()
        except _Stopped as stopped:
            detail = "Given up before there was a complete alternative."
            certificate = Certificate(
                claim="unproven", method=METHOD, detail=detail, limit=stopped.limit, seed=control.seed
            )
            return Ranking(alternatives=(), status="unknown", certificate=certificate, reasons=(stopped.reason,))
        complete = rho >= k or len(ways) < rho
        return _ranked(flat, ways, k, complete, control)


def kept_ways(flat: Flat, rho: int, control: Control) -> list[Way]:
    """What Algorithm 1 keeps of a tree that can be done, best first; none if it was ended before the root."""
    try:
        return _Combiner(flat, rho, Pruned(), control).ways_of_root()
    except _Stopped:
        return []


class _Combiner:
    """The sweep from the leaves up."""

    def __init__(self, flat: Flat, rho: int, settings: Pruned, control: Control) -> None:
        self.flat, self.rho, self.settings, self.control = flat, rho, settings, control
        self.charges = flat.charges
        self.limits = [flat.held(purse) for purse in self.charges.purses]

    def ways_of_root(self) -> list[Way]:
        """The ways kept at the root, best first."""
        flat, kept = self.flat, dict[int, list[Way]]()
        for node in range(len(flat.kind) - 1, -1, -1):
            below = [kept.pop(child) for child in flat.children[node]]
            if flat.kind[node] == "action":
                kept[node] = self._best([self._leaf(node)])
            elif flat.kind[node] == "xor":
                kept[node] = self._best(self._pool(node, below))
            elif self.settings.as_printed:
                kept[node] = self._whole_product(below)
            else:
                kept[node] = self._child_by_child(below)
        return kept[0]

    def _leaf(self, leaf: int) -> Way:
        return Way(self.flat.utility[leaf], dict(self.charges.of_leaf[leaf]))

    def _pool(self, xor: int, below: list[list[Way]]) -> Iterator[Way]:
        for place, ways in enumerate(below):
            for way in ways:
                chosen = Way(way.utility, way.uses, way)
                chosen.xor, chosen.place = xor, place
                yield chosen

    def _child_by_child(self, below: list[list[Way]]) -> list[Way]:
        kept = below[0] if below else self._best([Way(0, {})])
        for ways in below[1:]:
            self._ask_to_go_on()
            kept = self._best(_joined(first, second) for first, second in product(kept, ways))
        return kept

    def _whole_product(self, below: list[list[Way]]) -> list[Way]:
        size, most = 1, self.settings.max_product
        for ways in below:
            size *= len(ways)
            if size > most:
                raise _Stopped(_too_large(most), SearchLimit("combinations", most))
        whole = below[0] if below else _ranks([Way(0, {})])
        for ways in below[1:]:
            self._ask_to_go_on()
            whole = _ranks(sorted(_joined(first, second) for first, second in product(whole, ways)))
        return self._best(whole)

    def _best(self, ways: Iterable[Way]) -> list[Way]:
        return _ranks(sorted(way for way in ways if self._within(way.uses))[: self.rho])

    def _within(self, uses: Uses) -> bool:
        for purse, used in uses.items():
            limit = self.limits[purse]
            if limit is not None and used > limit:
                return False
        return True

    def _ask_to_go_on(self) -> None:
        limit = self.control.ended_by()
        if limit is not None:
            said = Reason(rule="stopped", message="Time was up, or somebody said stop.", severity="notice")
            raise _Stopped(said, limit)


def _ranks(ways: list[Way]) -> list[Way]:
    for rank, way in enumerate(ways):
        way.rank = rank
    return ways


def _joined(first: Way, second: Way) -> Way:
    uses = first.uses
    if second.uses:
        uses = {purse: uses.get(purse, 0) + second.uses.get(purse, 0) for purse in (*uses, *second.uses)}
    return Way(first.utility + second.utility, uses, first, second)


def _too_large(cap: int) -> Reason:
    return Reason(
        rule="product_too_large",
        message=f"The printed algorithm would form a product of more than {cap} combinations at one AND.",
        severity="notice",
        hint="Use the allocator exact, or pruned, which keeps rho ways after each child.",
    )


def _ranked(flat: Flat, ways: list[Way], k: int, complete: bool, control: Control) -> Ranking:
    coupled = couples(flat)
    referee, writer, refusals = Feasibility(flat), Writer(flat), Refusals()
    exact = complete and not coupled
    found: list[Alternative] = []
    possible = structurally_possible(flat)
    for way in ways:
        if len(found) == k:
            break
        selection = select(flat, choices_of(way), possible)
        verdict: Verdict = referee.decide(selection) if coupled else FREE
        if verdict.answer == "no":
            refusals.add(verdict.reason)
            continue
        found.append(
            writer.alternative(len(found) + 1, way.utility, selection, verdict, _certificate(exact, way.utility))
        )
    bound = found[-1].utility if found else None
    control.report(Progress("allocation", len(ways), len(found), bound if exact else None))
    return Ranking(
        alternatives=tuple(found),
        status=("exact" if exact else "partial") if found else "unknown",
        certificate=_of_the_rest(exact, bound if len(found) == k else None),
        examined=len(ways),
        reasons=refusals.summary("notice") if found or ways else (_nothing_left(),),
    )


def _certificate(exact: bool, utility: int) -> Certificate:
    if exact:
        return Certificate(claim="proven", method=METHOD, bound=utility / MICRO)
    return Certificate(
        claim="unproven", method=METHOD, detail="Found by pruning; a better one may have been pruned away."
    )


def _of_the_rest(exact: bool, bound: float | None) -> Certificate:
    if not exact:
        return Certificate(claim="unproven", method=METHOD, detail="Nothing is known of what was pruned away.")
    detail = "Nothing couples the choices, so pruning loses nothing."
    return Certificate(claim="proven", method=METHOD, bound=bound, detail=detail)


def _nothing_left() -> Reason:
    return Reason(
        rule="all_pruned",
        message="Every combination of what was kept breaks a budget; others were pruned away unseen.",
        severity="notice",
        hint="Use the allocator exact, or a larger rho.",
    )
