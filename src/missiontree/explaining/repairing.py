"""Repairs: changes that were found to be enough, each with the plan that it leads to."""

from __future__ import annotations

from collections.abc import Sequence

from missiontree.briefing import Request
from missiontree.explaining.case import Case
from missiontree.explaining.changes.families import applied, in_words
from missiontree.explaining.finding import Finder, Found
from missiontree.explaining.grid import at_step, step_of
from missiontree.explaining.guesses import used_in
from missiontree.explaining.probing import Answer, Prober
from missiontree.mission.control import Control
from missiontree.mission.explanation import Cheapest, Repair, Shortfall
from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason

MOST_WORK, MOST_ASKED, LEAST_ASKED = 60_000, 2_000, 60
"""Questions to the planner for one explanation: so many times the nodes of the grounded tree, within bounds."""
MOST_SETS = 3
"""Sets of changes that are looked for where no single change is enough."""
MOST_TIGHTENED = 3
"""How often a number is brought down to what the plan of a repair does with."""
SEARCH_SHARE = 0.7
"""Share of the time for finding changes; the rest is for the plans that they lead to."""


class Repairs:
    """
    What would make a mission possible.

    Parameters
    ----------
    request
        How the mission is planned, and what changes cost.
    case
        The mission, which cannot be done.
    known
        What falls short in it.
    control
        How long it may take.
    """

    def __init__(self, request: Request, case: Case, known: Sequence[Shortfall], control: Control) -> None:
        self._request, self._case, self._control = request, case, control
        nodes = len(case.tree.nodes) * (
            1 + 4 * len(case.brief.fleet.types)
        )  # a routine has some four nodes for each type
        most = max(LEAST_ASKED, min(MOST_ASKED, MOST_WORK // nodes))
        self._prober = Prober(request, control.part(SEARCH_SHARE), most)
        self._finder = Finder(case, self._prober, request.costs, known)
        self.looked_at = len(self._finder.changes)
        self.cheapest: Cheapest = "none"

    def find(self, most: int) -> tuple[Repair, ...]:
        """The cheapest, at most so many; ``cheapest`` then says what is known of the first."""
        found, self.cheapest = self._finder.singles(most)
        if all(
            one.changes[0].kind == "drop_part" for one in found
        ):  # to give something up is no answer to what it would take
            found = sorted([*found, *self._finder.sets(min(most, MOST_SETS))], key=lambda one: one.cost)[:most]
            if found and (len(found[0].changes) > 1 or self.cheapest == "none"):
                self.cheapest = "found"
        kept: list[tuple[Found, Plan]] = []
        for one in found:
            plan = planned(self._request, self._case, one, self._control, 1)
            if plan is None:  # not seen so far; what was not planned is not offered
                self.cheapest = "found"
                continue
            kept.append(self._tightened(one, plan))
        if not kept:
            self.cheapest = "none"
        ranked = sorted(kept, key=lambda pair: pair[0].cost)
        if ranked and ranked[0] is not kept[0]:
            self.cheapest = "found"
        return tuple(self._repair(number, *pair) for number, pair in enumerate(ranked, 1))

    def _tightened(self, one: Found, plan: Plan) -> tuple[Found, Plan]:
        """A number that is the least found comes down to what its plan does with, as often as that leads to a plan with less."""
        for _ in range(MOST_TIGHTENED):
            change = one.changes[0]
            if one.proven or len(one.changes) > 1 or change.was is None or change.to is None:
                break
            answer = Answer(True, plan.grounding, plan.ranking, plan.schedules)
            used = used_in(change, applied(self._case, one.changes), answer)
            if used is None or step_of(change, used) >= step_of(change, change.to):
                break
            less = (at_step(change, step_of(change, used)),)
            cheaper = Found(less, self._finder.cost(less), False)
            again = planned(self._request, self._case, cheaper, self._control, 1)
            if again is None:
                break
            one, plan = cheaper, again
        return one, plan

    def notices(self) -> tuple[Reason, ...]:
        """What else to know: that the search was cut short, and costs that are about nothing here."""
        found = [_unused(kind, name) for kind, name in self._finder.unused_prices()]
        return (*((TIME_UP,) if self._prober.ended() else ()), *found)

    def _repair(self, number: int, found: Found, plan: Plan) -> Repair:
        assert plan.ranking is not None, "a delivered plan has a ranking"
        best = next(one for one in plan.schedules if one.status in {"optimal", "feasible"})
        return Repair(
            number=number,
            changes=found.changes,
            cost=found.cost,
            claim="smallest_proven" if found.proven else "smallest_found",
            words=in_words(self._case, found.changes),
            utility=plan.ranking.alternatives[best.rank - 1].utility,
            makespan_s=best.makespan_s,
            plan=plan,
        )


TIME_UP = Reason(
    rule="repairs_cut_short",
    severity="notice",
    message="Not every change was looked at, since time was up or the mission is large; there may be more repairs, and less costly ones.",
)


def _unused(kind: str, name: str) -> Reason:
    return Reason(
        rule="cost_unused",
        severity="notice",
        message=f"The costs of {kind} name {name!r}, and no change of that kind is about it.",
        found=name,
        hint="A name is that of a robot type, a capability, a limit or a node of the tree.",
    )


def planned(request: Request, case: Case, found: Found | Repair, control: Control, k: int) -> Plan | None:
    """The plan of a repaired mission, checked; None if none is delivered."""
    words = in_words(case, found.changes)
    notice = Reason(
        rule="repair_applied",
        severity="notice",
        message=f"This is not the mission as it was stated, but with a change: {words}",
        found=", ".join(change.kind for change in found.changes),
    )
    return Prober(request, control, 0).plan(applied(case, found.changes), notice, k)
