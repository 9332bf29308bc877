"""
Every alternative there is, written plainly and slowly: the oracle that the other allocators are tested against.

It shares the flat form with them and nothing else. Choice vectors are counted up like an odometer; each is judged by trying
every assignment of its roles to robots and reading the rules off it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import islice, pairwise, product
from math import prod

from missiontree.allocation.feasibility import Verdict
from missiontree.allocation.flat import Flat, Stock, flatten
from missiontree.allocation.selection import Selection
from missiontree.allocation.writing import Writer, impossible, require_count
from missiontree.mission.alternative import Ranking
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control, Progress
from missiontree.mission.estimate import MICRO, Weights
from missiontree.mission.fleet import Fleet
from missiontree.mission.grounded import GroundedTree
from missiontree.mission.reason import Reason
from missiontree.mission.search_limit import SearchLimit

METHOD = "enumeration"


@dataclass(frozen=True, slots=True)
class Exhaustive:
    """
    Enumerates all alternatives.

    Parameters
    ----------
    max_examined
        Alternatives, feasible or not, beyond which it gives up. Default 200,000.
    max_assignments
        Assignments of roles to the robots of one type beyond which an alternative stays undecided. Default 200,000.
    """

    max_examined: int = 200_000
    max_assignments: int = 200_000

    def __call__(self, tree: GroundedTree | Flat, fleet: Fleet, weights: Weights, k: int, control: Control) -> Ranking:
        """See :class:`missiontree.allocation.allocator.Allocator`."""
        require_count(k)
        flat = flatten(tree, fleet, weights)
        judge, writer = _Judge(flat, self.max_assignments), Writer(flat)
        kept: list[tuple[int, Selection, Verdict]] = []
        examined, limit = 0, None
        for selection in every_selection(flat):
            limit = control.ended_by() or self._limit(examined)
            if limit is not None:
                break
            examined += selection is not None
            if selection is None or (verdict := judge.judge(selection)).answer == "no":
                continue
            kept.append((sum(flat.utility[leaf] for leaf in selection.leaves), selection, verdict))
        control.report(Progress("allocation", examined, len(kept)))
        if limit is None and not kept:
            reason = Reason(rule="none_feasible", message=f"All {examined} ways through the tree were tried in vain.")
            return impossible(METHOD, "Every way through the tree was tried.", (reason,), examined)
        kept.sort(key=lambda entry: -entry[0])  # stable: equal utilities stay in the order of their choices
        if limit is None and not all(verdict.answer == "yes" for _, _, verdict in kept):
            limit = SearchLimit("steps", self.max_assignments)
        decided = limit is None
        alternatives = tuple(
            writer.alternative(rank, utility, selection, verdict, _certificate(decided, utility))
            for rank, (utility, selection, verdict) in enumerate(islice(kept, k), start=1)
        )
        return Ranking(
            alternatives=alternatives,
            status="exact" if decided else "partial" if alternatives else "unknown",
            certificate=_of_the_rest(limit, control.seed, alternatives[-1].utility if len(kept) >= k else None),
            examined=examined,
        )

    def _limit(self, examined: int) -> SearchLimit | None:
        return SearchLimit("candidates", self.max_examined) if examined == self.max_examined else None


def _certificate(decided: bool, utility: int) -> Certificate:
    return Certificate(
        claim="proven" if decided else "unproven", method=METHOD, bound=utility / MICRO if decided else None
    )


def _of_the_rest(limit: SearchLimit | None, seed: int, bound: float | None) -> Certificate:
    if limit is None:
        return Certificate(claim="proven", method=METHOD, bound=bound)
    return Certificate(claim="unproven", method=METHOD, limit=limit, seed=seed)


def every_selection(flat: Flat) -> Iterator[Selection | None]:
    """Every way through the tree, by choice indices in preorder; None for each that runs into an XOR without children."""
    odometer: list[tuple[int, int]] = []  # position taken and number of children, per reached XOR
    while True:
        selection, odometer = _walk(flat, [position for position, _ in odometer])
        yield selection
        while odometer and odometer[-1][0] + 1 == odometer[-1][1]:
            odometer.pop()
        if not odometer:
            return
        position, width = odometer.pop()
        odometer.append((position + 1, width))


def _walk(flat: Flat, positions: list[int]) -> tuple[Selection | None, list[tuple[int, int]]]:
    """Follow the positions, then first children, until all is selected or an XOR has no child."""
    met: list[tuple[int, int]] = []
    choices, nodes, leaves, stack = [], [], [], [0]
    while stack:
        node = stack.pop()
        below = flat.children[node]
        nodes.append(node)
        if flat.kind[node] == "action":
            leaves.append(node)
        if flat.kind[node] != "xor":
            stack += reversed(below)
            continue
        if not below:
            return None, met
        position = positions[len(met)] if len(met) < len(positions) else 0
        met.append((position, len(below)))
        choices.append((node, below[position]))
        stack.append(below[position])
    return Selection(tuple(choices), tuple(nodes), tuple(leaves)), met


class _Judge:
    """Tries every assignment of roles to robots."""

    def __init__(self, flat: Flat, max_assignments: int) -> None:
        self.flat = flat
        self.max_assignments = max_assignments

    def judge(self, selection: Selection) -> Verdict:
        """Whether some assignment keeps all rules."""
        flat = self.flat
        types: dict[int, str] = {}
        for leaf in selection.leaves:
            if types.setdefault(flat.role[leaf], flat.robot_type[leaf]) != flat.robot_type[leaf]:
                return Verdict("no")
        if not set(flat.required) <= set(types.values()):
            return Verdict("no")
        if not self._shared_kept(selection) or not self._in_time(selection):
            return Verdict("no")
        same = [self._roles_under(link, selection) for link in flat.same_robot if set(link) <= set(selection.nodes)]
        apart = [
            self._roles_under(link, selection) for link in flat.different_robot if set(link) <= set(selection.nodes)
        ]
        if any(len({types[role] for role in first | second}) > 1 for first, second in same):
            return Verdict("no")
        witness: dict[int, str] = {}
        for type_id in sorted(set(types.values())):
            roles = sorted(role for role in types if types[role] == type_id)
            robots = range(len(flat.stocks[type_id].robots))
            found = None
            for tried in islice(product(robots, repeat=len(roles)), self.max_assignments):
                asked = _as_many_as_asked(flat.stocks[type_id], set(tried))
                if asked and self._keeps(type_id, dict(zip(roles, tried, strict=True)), selection, same, apart):
                    found = tried
                    break
            if found is None:
                too_many = prod([len(robots)] * len(roles)) > self.max_assignments
                return Verdict("undecided" if too_many else "no")
            witness.update((role, flat.stocks[type_id].robots[at]) for role, at in zip(roles, found, strict=True))
        return Verdict("yes", tuple(sorted(witness.items())))

    def _shared_kept(self, selection: Selection) -> bool:
        """Whether the whole mission keeps what all robots share, whoever does what."""
        for name, shared in self.flat.shared.items():
            if sum(self.flat.uses[leaf].get(name, 0) for leaf in selection.leaves) > shared.limit:
                return False
        return True

    def _in_time(self, selection: Selection) -> bool:
        """Push every action as late as its release, its role, links and joint work say, again and again, until nothing moves."""
        timing = self.flat.timing
        if timing is None:
            return True
        last = max(window.deadline for window in timing.windows if window.deadline is not None)
        leaves, nodes = selection.leaves, set(selection.nodes)
        start = {leaf: timing.windows[leaf].release for leaf in leaves}
        end = dict(start)
        until = [link for link in timing.until if set(link) <= nodes]
        under = {node: [leaf for leaf in leaves if self._above(node, leaf)] for link in until for node in link}
        ends_with: dict[int, list[int]] = {}
        for first, second in until:
            for leaf in under[first] if under[second] else ():
                if leaf in timing.open_ended:
                    ends_with.setdefault(leaf, []).extend(under[second])
        order = [(a, b, timing.lag[b]) for a, b in self._neighbours_in_roles(leaves)]
        for first, second in timing.precedence:
            if {first, second} <= nodes:
                order += [(a, b, 0) for a in leaves for b in leaves if self._above(first, a) and self._above(second, b)]
        joint = [[leaf for leaf in leaves if timing.sync.get(leaf) == number] for number in set(timing.sync.values())]
        while True:
            before = dict(start), dict(end)
            for a, b, lag in order:
                start[b] = max(start[b], end[a] + lag)
            for leaf in leaves:
                length = 0 if leaf in ends_with else timing.length[leaf]
                end[leaf] = max(end[leaf], start[leaf] + length, *(end[one] for one in ends_with.get(leaf, ())))
            for group in joint:
                start.update(dict.fromkeys(group, max((start[leaf] for leaf in group), default=0)))
                end.update(dict.fromkeys(group, max((end[leaf] for leaf in group), default=0)))
            start = {
                leaf: min(time, last + 1) for leaf, time in start.items()
            }  # what waits for itself would never rest
            end = {leaf: min(time, last + 1) for leaf, time in end.items()}
            if (start, end) == before:
                break
        deadlines = ((leaf, timing.windows[leaf].deadline) for leaf in leaves)
        return all(deadline is None or end[leaf] <= deadline for leaf, deadline in deadlines)

    def _neighbours_in_roles(self, leaves: tuple[int, ...]) -> Iterator[tuple[int, int]]:
        for role in dict.fromkeys(self.flat.role[leaf] for leaf in leaves):
            yield from pairwise(leaf for leaf in leaves if self.flat.role[leaf] == role)

    def _roles_under(self, link: tuple[int, int], selection: Selection) -> tuple[set[int], set[int]]:
        first, second = ({self.flat.role[leaf] for leaf in selection.leaves if self._above(end, leaf)} for end in link)
        return first, second

    def _above(self, end: int, node: int) -> bool:
        while node > end:  # parents come before children
            node = self.flat.parent[node]
        return node == end

    def _keeps(
        self,
        type_id: str,
        robot_of: Mapping[int, int],
        selection: Selection,
        same: list[tuple[set[int], set[int]]],
        apart: list[tuple[set[int], set[int]]],
    ) -> bool:
        """Read the rules off an assignment of one type's roles."""
        flat, stock = self.flat, self.flat.stocks[type_id]
        for first, second in same:
            if len({robot_of[role] for role in first | second if role in robot_of}) > 1:
                return False
        for first, second in apart:
            left = {robot_of[role] for role in first if role in robot_of}
            if left & {robot_of[role] for role in second if role in robot_of}:
                return False
        for role in robot_of:
            for mate in robot_of:
                if role != mate and flat.team[role] is not None and flat.team[role] == flat.team[mate]:  # noqa: SIM102
                    if robot_of[role] == robot_of[mate]:
                        return False
        spent: dict[tuple[int, str], int] = {}
        together: dict[str, int] = {}
        for leaf in selection.leaves:
            if flat.role[leaf] in robot_of:
                for name, used in flat.uses[leaf].items():
                    robot = robot_of[flat.role[leaf]]
                    spent[robot, name] = spent.get((robot, name), 0) + used
                    together[name] = together.get(name, 0) + used
        if any(used > stock.totals.get(name, used) for name, used in together.items()):
            return False
        return all(used <= stock.budgets[robot].get(name, used) for (robot, name), used in spent.items())


def _as_many_as_asked(stock: Stock, busy: set[int]) -> bool:
    """Whether no more robots work than may be in use, and all that must."""
    few = stock.max_in_use is None or len(busy) <= stock.max_in_use
    return few and all(robot in busy for robot in stock.required)
