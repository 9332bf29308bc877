"""
The largest part of a mission that can be done, where the whole cannot.

Sets of parts to leave out are looked at in order of their weight, lightest first, and each is planned: grounded, allocated, scheduled and
checked as any mission. Which set is the lightest that may do is asked of the exact allocator, on the mission with every part made
optional (:mod:`relaxed`). A set whose plan fails is taken apart as Lawler does it ("A procedure for computing the K best solutions to
discrete optimization problems", Management Science 18, 1972): one question for each of its decisions, that one turned round and those
before it kept. So the first set that can be done is the lightest, and that is the proof.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from heapq import heappop, heappush
from itertools import count

from missiontree.authoring.outcome import Authored
from missiontree.briefing import Request
from missiontree.checking import check
from missiontree.errors import InternalError
from missiontree.explaining.lost import lost_uses
from missiontree.explaining.relaxed import Fixed, Relaxed
from missiontree.explaining.weighing import in_steps, parts_of, topmost, weights_of, without_parts
from missiontree.explaining.whole import as_given, wholly_authored, wholly_understood
from missiontree.mission.control import Control
from missiontree.mission.explanation import Nearest
from missiontree.mission.grounded import GroundedNode, GroundedTree
from missiontree.mission.partial import LeftOut, Partial
from missiontree.mission.plan import Plan
from missiontree.mission.reason import Reason
from missiontree.mission.tree import MissionTree
from missiontree.planner import plan_authored
from missiontree.reporting.left_out import known_of_larger, parts_left_out
from missiontree.routines.ground import ground

LEAST_EXAMINED, MOST_EXAMINED, MOST_WORK = 8, 64, 4_000
"""Parts that are planned before the search is given up: within bounds, so many as fit into that many nodes of the grounded tree."""

SHARE = 0.3
"""Of the time that is left, for one question or one plan."""

UNDONE = ("cannot_be_done", "exhausted")
"""Outcomes of missions that may still be done in part."""


def nearest_part(whole: Plan, request: Request, authored: Authored, control: Control) -> Plan | None:
    """
    Plan the largest part of a mission that can be done.

    Parameters
    ----------
    whole
        What planning the whole mission came to.
    request, authored
        What it was planned from.
    control
        Time limit and stop token; a search that is ended early proves nothing.

    Returns
    -------
    Plan or None
        A plan whose outcome is ``partial``, checked; None if the whole mission can be done, was not authored, or if no part of it was
        found that can be done.

    Raises
    ------
    InputError
        If ``parts`` of the mission name what is no part of it.
    """
    if whole.outcome not in UNDONE or (made := wholly_authored(request, authored)) is None:
        return None
    return None if made.tree is None else _searched(whole, request, made, made.tree, control)


def _searched(whole: Plan, request: Request, made: Authored, tree: MissionTree, control: Control) -> Plan | None:
    if tree.open_leaves:  # nothing serves them: they are parts that cannot be done, whoever is there
        rest = without_parts(tree, [leaf.id for leaf in tree.open_leaves], request.brief.routines)
        grounding = ground(rest, request.brief, request.estimator)
        grounded = grounding.tree
        whole = replace(whole, reasons=tuple(dict.fromkeys((*whole.reasons, *grounding.not_offered))))
        nobody = (GroundedNode(parent=0, kind="xor", label=leaf.label, source=leaf.id) for leaf in tree.open_leaves)
        grounded = replace(grounded, nodes=(*grounded.nodes, *nobody))
        return _Search(whole, request, made, tree, grounded, control).run()
    if whole.grounding is None:
        whole = plan_authored(request, made, control.part(SHARE))
    if whole.grounding is None:
        return None
    return _Search(whole, request, made, tree, whole.grounding.tree, control).run()


def nearest_of(whole: Plan, request: Request, tree: MissionTree | None, control: Control) -> Nearest | None:
    """The largest part of a mission, in words and with its plan; None if there is none. Without its tree the mission is read anew."""
    if whole.outcome not in UNDONE:
        return None
    made = as_given(tree, request.brief) if tree is not None else wholly_understood(request)
    found = None if made is None else nearest_part(whole, request, made, control)
    if found is None or found.partial is None:
        return None
    left_out = [one.message for one in parts_left_out(found.partial)]
    return Nearest(
        words=" ".join((known_of_larger(found.partial), *left_out)),
        dropped=tuple(one.node for one in found.partial.left_out),
        proven=found.partial.claim == "proven",
        plan=found,
    )


@dataclass(frozen=True, slots=True)
class _Set:
    """A set of parts to leave out, what was fixed when it was found, and what was decided."""

    left_out: tuple[str, ...]
    fixed: Fixed
    decided: tuple[tuple[str, bool], ...]


class _Search:
    """One search."""

    def __init__(
        self,
        whole: Plan,
        request: Request,
        authored: Authored,
        tree: MissionTree,
        grounded: GroundedTree,
        control: Control,
    ) -> None:
        self.whole, self.request, self.authored, self.tree, self.control = whole, request, authored, tree, control
        self.weights = weights_of(tree, request.brief.weighed)
        self.steps = in_steps(self.weights, tree.root.id)
        self.parts = [part.id for part in parts_of(tree)]
        self.relaxed = Relaxed(tree, grounded, request.brief, self.steps)
        self.proven = whole.outcome == "cannot_be_done" and not request.brief.terms.judged_by_estimator
        self.lost = lost_uses(self._rest([leaf.id for leaf in tree.open_leaves]), request.brief)
        self.examined = 0
        self.most = max(LEAST_EXAMINED, min(MOST_EXAMINED, MOST_WORK // len(grounded.nodes)))
        self.waiting: list[tuple[int, int, int, _Set]] = []
        self.number = count()

    def run(self) -> Plan | None:
        """Look at one set after another."""
        if not self.parts:
            return None
        self._ask(Fixed())
        lightest = self.waiting[0][-1] if self.waiting else None
        seen: set[tuple[str, ...]] = set()
        while self.waiting and self.examined < self.most and not self.control.ended():
            *_, one = heappop(self.waiting)
            if one.left_out and one.left_out not in seen and one.left_out != (self.tree.root.id,):
                seen.add(one.left_out)
                self.examined += 1
                found = self._planned(one.left_out)
                if found.outcome == "delivered":
                    return self._told(found, one.left_out)
                self.proven = self.proven and found.outcome == "cannot_be_done"
            for fixed in _others(one):
                self._ask(fixed)
        return None if lightest is None or not self.waiting else self._shrunk(lightest)

    def _shrunk(self, one: _Set) -> Plan | None:
        """
        Give up a set and more, by bisection, until the rest can be done; then take back one after the other what fits in.

        The lightest parts are given up first, and of equal ones the last. Nothing is known of other sets then.
        """
        self.proven = False
        contains = self.tree.contains
        units = [part for part in self.parts if not any(contains(part, other) for other in self.parts if other != part)]
        first = [unit for unit in units if any(unit == out or contains(out, unit) for out in one.left_out)]
        more = sorted((unit for unit in reversed(units) if unit not in first), key=lambda unit: self.steps[unit])
        told, low, high = None, 0, len(more)
        while high - low > 1 and (found := self._tried([*first, *more[: (low + high) // 2]])) is not None:
            told, low, high = (found, low, (low + high) // 2) if found[0] else (told, (low + high) // 2, high)
        gone = [*first, *more[:high]]
        for unit in reversed(gone):
            found = self._tried([other for other in gone if other != unit])
            if found is not None and found[0]:
                told, gone = found, [other for other in gone if other != unit]
        return None if told is None or told[0] is None else self._told(told[0], told[1])

    def _tried(self, left_out: Sequence[str]) -> tuple[Plan | None, tuple[str, ...]] | None:
        """The plan without some parts, None if there is none, and what is left out; None in all if nothing more may be tried."""
        upmost = topmost(self.tree, left_out)
        if self.control.ended() or self.examined >= self.most + 2 * len(self.parts) or upmost == (self.tree.root.id,):
            return None
        self.examined += 1
        found = self._planned(upmost)
        return (found if found.outcome == "delivered" else None), upmost

    def _ask(self, fixed: Fixed) -> None:
        """The lightest set that may do, with something fixed, joins those that wait."""
        bound = self.relaxed.least(self.parts, fixed, self.control.part(SHARE))
        if bound is None:
            return
        self.proven = self.proven and bound.proven
        if not bound.decided:
            return
        left_out = topmost(self.tree, {part for part, out in bound.decided if out})
        cost = sum(self.steps[part] for part in left_out)
        heappush(self.waiting, (cost, len(left_out), next(self.number), _Set(left_out, fixed, bound.decided)))

    def _rest(self, left_out: Collection[str]) -> MissionTree:
        return without_parts(self.tree, left_out, self.request.brief.routines)

    def _planned(self, left_out: tuple[str, ...]) -> Plan:
        """The plan of what is left; the whole, which cannot be done, where somebody would be fetched whom nobody finds first."""
        if not lost_uses(self._rest(left_out), self.request.brief) <= self.lost:
            return self.whole
        kept = replace(self.authored, tree=self._rest(left_out))
        return plan_authored(self.request, kept, self.control.part(SHARE))

    def _why_not_whole(self, left_out: tuple[str, ...]) -> tuple[Reason, ...]:
        """Why the whole cannot be done, without what was not offered for parts that are done."""
        done = self._rest(left_out).by_id
        needed = tuple(reason for reason in self.whole.reasons if reason.node not in done)
        return needed or self.whole.reasons

    def _told(self, found: Plan, left_out: tuple[str, ...]) -> Plan:
        """The plan, marked as one of a part."""
        total = self.weights[self.tree.root.id]
        kept = total - sum(self.weights[part] for part in left_out)
        made = replace(
            found,
            outcome="partial",
            reasons=self._why_not_whole(left_out),
            partial=Partial(
                whole=self.tree,
                left_out=tuple(LeftOut(part, float(self.weights[part])) for part in left_out),
                total=float(total),
                kept=float(kept),
                claim="proven" if self.proven else "found",
                examined=self.examined,
            ),
        )
        if faults := check(made):
            raise InternalError(f"the checker refuses a part of our own making: {faults[0].rule}: {faults[0].message}")
        return made


def _others(one: _Set) -> Iterator[Fixed]:
    """What else there is beside a set: each decision turned round, those before it as they are. What is fixed already stays."""
    kept, left_out = set(one.fixed.kept), set(one.fixed.left_out)
    for part, out in one.decided:
        if part in one.fixed.kept or part in one.fixed.left_out:
            continue
        turned = (kept | {part}, left_out) if out else (kept, left_out | {part})
        yield Fixed(frozenset(turned[0]), frozenset(turned[1]))
        (left_out if out else kept).add(part)
