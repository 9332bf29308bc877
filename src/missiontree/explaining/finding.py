"""
Which changes are enough: single ones, cheapest first; if none is, sets none of which can be spared.

A change with a number is first tried as far as it can go, then made as small as can be. All changes of one kind are tried together before
each by itself: if even all are not enough, none is. Sets are found by a deletion filter, as allocation finds limits that clash.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import groupby

from missiontree.explaining.case import Case
from missiontree.explaining.changes.families import applied, candidates
from missiontree.explaining.changes.needs import Needs, needs_of
from missiontree.explaining.changes.parts import routines_below
from missiontree.explaining.changes.robots import MOST_ADDED
from missiontree.explaining.grid import at_step, last_step, sized, step_of
from missiontree.explaining.guesses import guesses, used_in
from missiontree.explaining.pointless import Pointless
from missiontree.explaining.probing import NO, Answer, Prober
from missiontree.explaining.sizing import smallest
from missiontree.mission.change import Change, ChangeKind
from missiontree.mission.costs import Costs, Price
from missiontree.mission.explanation import Cheapest, Shortfall


@dataclass(frozen=True, slots=True)
class Found:
    """
    Changes that are enough.

    Parameters
    ----------
    changes
        With their numbers.
    cost
        Their cost.
    proven
        Whether nothing less of the same kind is enough.
    """

    changes: tuple[Change, ...]
    cost: float
    proven: bool


class Finder:
    """
    Looks for changes that make a mission possible.

    Parameters
    ----------
    case
        The mission, which cannot be done.
    prober
        Who is asked.
    costs
        What changes cost.
    known
        What falls short.
    """

    def __init__(self, case: Case, prober: Prober, costs: Costs, known: Sequence[Shortfall] = ()) -> None:
        self.case, self._prober, self._costs, self._known = case, prober, costs, known
        self._needs: Needs = needs_of(case)
        self._answers: dict[frozenset[Change], Answer] = {}
        as_it_is = self.ask(())
        self._order, self._pointless = order_of(as_it_is), Pointless(case, as_it_is.grounding, self._needs)
        order = enumerate(candidates(case))
        self.changes = [change for _, change in sorted(order, key=lambda pair: (self.cost([pair[1]]), pair[0]))]

    def cost(self, changes: Iterable[Change]) -> float:
        """What changes cost; one whose number is still to be found costs that much at least."""
        return round(sum(self._costs.of(change, self._routines(change)) for change in changes), 6)

    def _routines(self, change: Change) -> int:
        """How many routines or cells a change is about."""
        if change.kind == "clear_cells":
            return len(change.target.split())
        return routines_below(self.case, change.target) if change.kind == "drop_part" else 1

    def unused_prices(self) -> list[tuple[str, str]]:
        """Kinds of change and names that have a cost of their own, and that no change looked at is about."""
        known = {(change.kind, name) for change in self.changes for name in (change.target, change.name)}
        prices = self._costs.prices.items()
        named = ((kind, name) for kind, price in prices if isinstance(price, Price) for name in price.of)
        return [pair for pair in named if pair not in known]

    def ask(self, changes: Iterable[Change]) -> Answer:
        """Whether the mission can be done with changes."""
        key = frozenset(changes)
        if key not in self._answers:
            ordered = [change for change in dict.fromkeys(changes) if change in key]
            try:
                case = applied(self.case, ordered)
            except ValueError:
                self._answers[key] = NO
            else:
                self._answers[key] = self._prober.ask(case)
        return self._answers[key]

    def singles(self, most: int) -> tuple[list[Found], Cheapest]:
        """Single changes that are enough, cheapest first, and whether the first is the cheapest."""
        hopeless = self._hopeless()
        found: list[Found] = []
        undecided: list[float] = []
        for change in self.changes:
            least = self.cost([change])
            if len(found) >= most and least >= sorted(one.cost for one in found)[most - 1]:
                break
            if any(_wider(change, one.changes[0]) for one in found):
                continue
            spared = change.kind in hopeless or self._pointless(change)
            answer = NO if spared else self.ask([change])
            if answer.possible is None or (sized(change) and answer.possible is False and not self._only_more(answer)):
                undecided.append(least)
            elif change.kind == "drop_part" and any(self._holds(change, one.changes[0]) for one in found):
                continue  # less of it is enough
            elif answer.possible and (one := self._sized((change,), True)) is not None:
                found.append(one)
        found.sort(key=lambda one: one.cost)
        if not found:
            return [], "none"
        open_below = any(least < found[0].cost for least in undecided) or not found[0].proven
        return found[:most], "found" if open_below else "proven"

    def _holds(self, outer: Change, inner: Change) -> bool:
        """Whether one part that is left out holds another one that is."""
        return inner.kind == "drop_part" and self.case.tree.contains(outer.target, inner.target)

    def _hopeless(self) -> set[ChangeKind]:
        """Kinds of change of which not even all together are enough."""
        kinds = sorted(self.changes, key=lambda change: change.kind)
        hopeless: set[ChangeKind] = set()
        for kind, group in groupby(kinds, key=lambda change: change.kind):
            together = [change for change in group if not self._pointless(change)]
            if kind == "drop_part" or len(together) < 2:
                continue
            answer = self.ask(together)
            if answer.possible is False and self._only_more(answer):
                hopeless.add(kind)
        return hopeless

    def _only_more(self, answer: Answer) -> bool:
        """
        Whether a changed mission has all ways of the mission as it is, and more.

        Who moves an entity and who uses it have an order, which is added to the mission. A new way that moves one may bring such an order
        along, and so be less. Everything else that is changed here adds ways, and takes none away.
        """
        return answer.grounding is None or order_of(answer) <= self._order

    def sets(self, most: int) -> list[Found]:
        """Sets of changes that are enough, none of which can be spared."""
        pool = [change for change in reversed(self.changes) if change.kind != "drop_part"]
        waiting, seen = [pool], set[frozenset[Change]]()
        found: dict[frozenset[Change], Found] = {}
        while waiting and len(found) < most and not self._prober.ended():
            tried = waiting.pop(0)
            if frozenset(tried) in seen or not self.ask(tried).possible:
                continue
            seen.add(frozenset(tried))
            kept, irreducible = self._filtered(tried)
            one = self._sized(tuple(reversed(kept)), irreducible)
            if one is not None:
                found.setdefault(frozenset(kept), one)
            waiting += [[change for change in tried if change != spared] for spared in kept]
        return sorted(found.values(), key=lambda one: one.cost)

    def _filtered(self, pool: Sequence[Change]) -> tuple[list[Change], bool]:
        """What is left of a pool that is enough once all that can be spared is gone, the dearest first; and whether that is proven."""
        kept: list[Change] = list(pool)
        irreducible = True
        waiting = [list(pool)]
        while waiting:
            chunk = waiting.pop()
            rest = [change for change in kept if change not in chunk]
            answer = self.ask(rest).possible if rest else False
            if answer:
                kept = rest
            elif len(chunk) == 1:
                irreducible = irreducible and answer is False
            else:
                half = len(chunk) // 2
                waiting += [chunk[half:], chunk[:half]]
        return kept, irreducible

    def _sized(self, changes: tuple[Change, ...], proven: bool) -> Found | None:
        """Changes that are enough as far as they can go, with numbers that are as small as can be, one after the other."""
        for place, change in enumerate(changes):
            if not sized(change):
                continue
            free = self.ask(changes)
            others = (changes[:place], changes[place + 1 :])

            def with_step(
                step: int, change: Change = change, others: Sequence[tuple[Change, ...]] = others
            ) -> bool | None:
                return self.ask((*others[0], at_step(change, step), *others[1])).possible

            def reached(step: int, change: Change = change, others: Sequence[tuple[Change, ...]] = others) -> int:
                with_it = (*others[0], at_step(change, step), *others[1])
                used = used_in(change, applied(self.case, with_it), self.ask(with_it))
                return step if used is None else max(1, min(step, step_of(change, used)))

            numbers = guesses(change, applied(self.case, changes), self._needs, free, self._known)
            steps = [step_of(change, number) for number in numbers]
            size = smallest(with_step, steps, last_step(change, MOST_ADDED), reached)
            if size is None:
                return None
            proven = proven and size.proven and self._only_more(free)
            changes = (*others[0], at_step(change, size.step), *others[1])
        return Found(changes, self.cost(changes), proven)


def order_of(answer: Answer) -> frozenset[tuple[str | None, str | None, str]]:
    """Links of a grounded mission between nodes of its tree."""
    if answer.grounding is None:
        return frozenset()
    tree = answer.grounding.tree
    return frozenset((tree.nodes[link.first].source, tree.nodes[link.second].source, link.kind) for link in tree.links)


def _wider(change: Change, found: Change) -> bool:
    """Whether a change lets any robot type do a routine for which it is enough to let a certain one."""
    return change.kind == "allow_type" == found.kind and change.target == found.target and not change.name
