"""
The best alternatives of which no two have the same team, exactly: the best; the best of another team than that; and so on.

Each further rank is the best of the sets of teams that are left (:mod:`teams`). What the best of a set is worth bounds the parts into which
that set falls, and so does the best that they would have if nothing coupled the robots (:mod:`ceilings`). A part is searched only when
its bound comes up; where two are worth the same, the part is searched first, since its best may stand before in the order of choices.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import count

from missiontree.allocation.allocator import Allocator
from missiontree.allocation.ceilings import ceiling, ceilings
from missiontree.allocation.flat import Flat, flatten
from missiontree.allocation.measure import bound_of, team_of, told, told_bound
from missiontree.allocation.roster import Entry, Roster
from missiontree.allocation.teams import Team, Teams
from missiontree.allocation.writing import require_count
from missiontree.mission.aim import Accumulate
from missiontree.mission.alternative import Alternative, Ranking
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control, silent
from missiontree.mission.estimate import Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree

METHOD = "team_partition"
SHARES = (0.5, 0.25)  # of the time that is left, for the first search and for each further one


@dataclass(frozen=True, slots=True)
class Diverse:
    """
    Ranks alternatives that differ in team.

    Parameters
    ----------
    best
        Finds the best alternative, exactly.
    accumulate
        What that is the best of.
    """

    best: Allocator
    accumulate: Accumulate = "sum"

    def __call__(self, tree: GroundedTree | Flat, fleet: Fleet, weights: Weights, k: int, control: Control) -> Ranking:
        """See :class:`missiontree.allocation.allocator.Allocator`."""
        require_count(k)
        flat = flatten(tree, fleet, weights)
        roster = Roster(flat, self.accumulate, k, METHOD, control)

        def search(teams: Teams, share: float) -> Ranking:
            quiet = replace(control.part(share), report=silent)
            return self.best(teams.problem(flat), fleet, weights, 1, quiet)

        return _Partition(roster, search, k, control).ranking()


@dataclass(order=True, slots=True)
class _Part:
    """
    A set of teams in the heap, the most promising first.

    Parameters
    ----------
    order
        Bound on the worth of its alternatives, and the choices of the best where it was searched; where it was not, none, so that it
        stands before those that are worth the same.
    number
        Settles what is left.
    teams
        The set.
    best
        Its best alternative, or the best that a search found before it was stopped; None before the search.
    bound
        No alternative of these teams is worth more.
    """

    order: tuple[Fraction, tuple[int, ...]]
    number: int
    teams: Teams = field(compare=False)
    best: Entry | None = field(compare=False)
    bound: Fraction = field(compare=False)


class _Partition:
    """The sets of teams that are left, and the list so far."""

    def __init__(self, roster: Roster, search: Callable[[Teams, float], Ranking], k: int, control: Control) -> None:
        self._roster, self._search, self._k, self._control = roster, search, k, control
        self._types = list(dict.fromkeys(name for name in roster.flat.robot_type if name))
        self._heap: list[_Part] = []
        self._number = count()
        self._listed: list[tuple[Entry, bool]] = []
        self._open: list[Fraction] = []  # bounds of sets whose best is not known, and will not be
        self._ended: Certificate | None = None  # of the last search that was stopped

    def ranking(self) -> Ranking:
        """All ranks, as far as the time allows."""
        whole = self._search(Teams(), SHARES[0])
        if not whole.alternatives:
            return whole
        self._take(Teams(), whole, None)
        while self._heap and len(self._listed) < self._k:
            part = heapq.heappop(self._heap)
            if part.best is not None:
                self._list(part.best)
                self._split(part.teams, team_of(part.best.alternative), part.bound)
            elif self._control.ended():
                self._open.append(part.bound)
            else:
                self._take(part.teams, self._search(part.teams, SHARES[1]), part.bound)
        return self._told(whole)

    def _push(self, teams: Teams, best: Entry | None, bound: Fraction) -> None:
        order = (-bound, ()) if best is None else best.order
        heapq.heappush(self._heap, _Part(order, next(self._number), teams, best, bound))

    def _split(self, teams: Teams, team: Team, bound: Fraction) -> None:
        """Put the parts without a team into the heap, each with a bound of its own as long as there is time for it."""
        flat, accumulate = self._roster.flat, self._roster.accumulate
        with_more: dict[str, Fraction] | None = None
        for part in teams.around(team, self._types):
            above: Fraction | None = bound
            if not self._control.ended():
                if part.within <= team:  # it lacks a type of the team
                    found = ceilings(flat, part.without, accumulate, bound)
                else:  # it has the whole team and more
                    with_more = with_more or ceilings(flat, teams.without, accumulate, bound)
                    found = with_more
                above = ceiling(found, part, bound)
            if above is not None:
                self._push(part, None, above)

    def _take(self, teams: Teams, found: Ranking, above: Fraction | None) -> None:
        """Take up what a search among some teams found; ``above`` is the bound that was known before."""
        entries = self._roster.take(found)
        stopped = found.certificate.claim != "proven"
        if stopped:
            bounds = [] if above is None else [above]
            if found.certificate.bound is not None:
                bounds.append(bound_of(found.certificate.bound))
            self._open.append(min(bounds))
            self._ended = found.certificate
        if entries:
            self._push(teams, entries[0], self._open[-1] if stopped else entries[0].worth)

    def _list(self, entry: Entry) -> None:
        """Whether a rank is proven shows when it comes up: whatever is left by then, and may come up yet, stands behind it."""
        self._listed.append((entry, entry.decided and all(bound < entry.worth for bound in self._open)))

    def _told(self, whole: Ranking) -> Ranking:
        self._listed.sort(key=lambda listed: listed[0].order)
        full = len(self._listed) == self._k
        last = self._listed[-1][0].worth
        complete = all(bound < last for bound in self._open) if full else not self._open
        left = max([*self._open, *(part.bound for part in self._heap)], default=last)
        if complete:
            detail = "No other team has a better one than the bound." if full else "There are no more teams."
            certificate = Certificate(claim="proven", method=METHOD, bound=told(last) if full else None, detail=detail)
        else:
            detail = "Stopped early; no other team has a better one than the bound."
            limit, seed = self._control.ended_by(), self._control.seed
            ended = self._ended or Certificate(claim="bounded", method=METHOD, limit=limit, seed=seed)
            certificate = replace(ended, method=METHOD, bound=told_bound(left), detail=detail)
        decided = all(entry.decided for entry, _ in self._listed)
        return Ranking(
            alternatives=tuple(self._written(last if complete else left)),
            status="exact" if complete and decided else "partial",
            certificate=certificate,
            examined=self._roster.examined,
            reasons=whole.reasons,
        )

    def _written(self, left: Fraction) -> Iterator[Alternative]:
        above = True
        for rank, (entry, proven) in enumerate(self._listed, start=1):
            above = above and proven
            certificate = self._certificate(entry, above, max(left, entry.worth))
            yield replace(entry.alternative, rank=rank, utility=told(entry.worth), certificate=certificate)

    def _certificate(self, entry: Entry, proven: bool, bound: Fraction) -> Certificate:
        if proven:
            detail = "No team but those above has a better one."
            return Certificate(claim="proven", method=METHOD, bound=told(entry.worth), detail=detail)
        if not entry.decided:
            detail = "Whether the robots' budgets can be kept was not decided."
            return replace(entry.alternative.certificate, method=METHOD, bound=told_bound(bound), detail=detail)
        more = told_bound(bound - entry.worth)
        detail = f"Feasible; another team that is not listed has one that is better by {more:g} at most."
        return Certificate(claim="bounded", method=METHOD, bound=told_bound(bound), detail=detail)
