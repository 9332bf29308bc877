"""
The mission with every part made optional, for the exact allocator: what it proves of that bounds what can be done at all.

Each child of an AND that has others becomes an XOR of itself and of leaving it out, which costs its weight; nothing else counts. The
least cost is a lower bound on the weight that has to be left out: travel that is certain, limits, teams, links and deadlines are
those of the whole mission, where what is certain of each routine is no more than in any part of it. Orders that were added for the whole
mission are left aside, since in a part of it they may be others.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, replace

from missiontree.allocation.flat import flatten
from missiontree.allocation.kbest import ExactKBest
from missiontree.mission.brief import MissionBrief
from missiontree.mission.control import Control
from missiontree.mission.estimate import Estimate, Weights
from missiontree.mission.fleet import Capability, RobotType
from missiontree.mission.grounded import Action, GroundedLink, GroundedNode, GroundedTree, Role
from missiontree.mission.tree import MissionTree

LEAVING = "leaving_out"
_NAMES = tuple(f"{LEAVING}_{number}" for number in range(1_000))
MOST_PAIRS = 2_000

COUNTED = Weights(1.0, 0.0, 1.0)
"""Costs alone are counted, since all qualities are 0 here."""


@dataclass(frozen=True, slots=True)
class Fixed:
    """
    What is decided beforehand.

    Parameters
    ----------
    kept
        Parts that are not left out: done, or below what is left out or not chosen.
    left_out
        Parts that are left out, so that all they stand below is chosen and done.
    """

    kept: frozenset[str] = frozenset()
    left_out: frozenset[str] = frozenset()


@dataclass(frozen=True, slots=True)
class Bound:
    """
    What was found of the mission with optional parts.

    Parameters
    ----------
    decided
        Every part, in tree order, and whether it is left out.
    proven
        Whether it is proven that no less has to be left out.
    """

    decided: tuple[tuple[str, bool], ...]
    proven: bool


class Relaxed:
    """
    One mission, asked again and again with other things fixed.

    Parameters
    ----------
    mission, tree
        The mission tree and the same over the fleet.
    brief
        Fleet and rules.
    weights
        Weight of each part in whole steps, by node id.
    """

    def __init__(
        self, mission: MissionTree, tree: GroundedTree, brief: MissionBrief, weights: Mapping[str, int]
    ) -> None:
        self.mission, self.tree, self.brief, self.weights = mission, tree, brief, weights
        self.top: dict[str, int] = {}
        for index, node in enumerate(tree.nodes):
            if node.source is not None:
                self.top.setdefault(node.source, index)
        self.links = tuple(apart for link in tree.links if self._authored(link) for apart in self._taken_apart(link))
        self.leaver = next(name for name in _NAMES if name not in brief.fleet.by_id)
        leaver = RobotType(id=self.leaver, capabilities={LEAVING: Capability(0.0)}, count=1)
        self.fleet = replace(brief.fleet, types=(*brief.fleet.types, leaver))

    def _authored(self, link: GroundedLink) -> bool:
        """Whether a link is the author's, or of one routine."""
        first, second = (self.tree.nodes[end].source for end in (link.first, link.second))
        own = {(one.first, one.second, one.kind) for one in self.mission.links}
        return first == second or (first, second, link.kind) in own

    def _taken_apart(self, link: GroundedLink) -> Iterator[GroundedLink]:
        """
        A link about robots between the routines below its ends, so that it does not speak of who "does" what is left out.

        Hand-overs between tasks, and links between very many routines, are left aside, which only loosens the mission.
        """
        first, second = (self._routines(end) for end in (link.first, link.second))
        if link.kind in {"precedence", "until"} or (first == [link.first] and second == [link.second]):
            yield link
        elif link.kind != "hand_over" and len(first) * len(second) <= MOST_PAIRS:
            yield from (GroundedLink(one, other, link.kind) for one in first for other in second)

    def _routines(self, node: int) -> list[int]:
        """Tops of the routines at or below a node; a node inside a routine is its own."""
        source = self.tree.nodes[node].source
        if source is None or self.top[source] != node or self.mission.by_id[source].routine is not None:
            return [node]
        return [
            self.top[one.id]
            for one in self.mission.nodes
            if one.id in self.top and one.routine is not None and self.mission.contains(source, one.id)
        ]

    def least(self, optional: Collection[str], fixed: Fixed, control: Control) -> Bound | None:
        """
        What has to be left out at least.

        Returns
        -------
        Bound or None
            None if nothing can be done with what is fixed; a bound without decisions that is not proven if nothing was found out.
        """
        made = _Making(self, set(optional), fixed)
        flat = flatten(made.tree, self.fleet, COUNTED, self.brief.terms)
        ranking = ExactKBest(explain=False)(flat, self.fleet, COUNTED, 1, control)
        if ranking.status == "infeasible":
            return None
        if not ranking.alternatives:
            return Bound((), False)
        best = ranking.alternatives[0]
        taken = {choice.xor: choice.child for choice in best.choices}
        left_out = {
            part for part, xor in made.optional.items() if xor in taken and taken[xor] == made.leaving.get(part)
        }
        decided = tuple((part, part in left_out) for part in optional)
        return Bound(decided, best.certificate.claim == "proven")


class _Making:
    """The tree with optional parts, as it is made."""

    def __init__(self, relaxed: Relaxed, optional: set[str], fixed: Fixed) -> None:
        self.relaxed, self.fixed = relaxed, fixed
        self.done = {above for part in fixed.left_out for above in relaxed.mission.ancestors(part)}
        self.nodes: list[GroundedNode] = []
        self.roles = list(relaxed.tree.roles)
        self.optional: dict[str, int] = {}
        """XOR of every part that may be reached."""
        self.leaving: dict[str, int] = {}
        index: dict[int, int] = {}
        part_at = {relaxed.top[node]: node for node in optional}
        for old, node in enumerate(relaxed.tree.nodes):
            parent = index.get(node.parent, -1) if node.parent >= 0 else -1
            if node.parent >= 0 and node.parent not in index:
                continue  # below something that is left out or not chosen for sure
            if self._not_chosen(node):
                continue
            if old in part_at:
                parent = self._optional(part_at[old], parent)
                if part_at[old] in fixed.left_out:
                    continue
            index[old] = self._add(replace(node, parent=parent, action=_worthless(node.action)))
        self.tree = GroundedTree(
            objective=relaxed.tree.objective,
            nodes=tuple(self.nodes),
            roles=tuple(self.roles),
            links=tuple(
                replace(link, first=index[link.first], second=index[link.second])
                for link in relaxed.links
                if link.first in index and link.second in index
            ),
        )

    def _not_chosen(self, node: GroundedNode) -> bool:
        """Whether another child of the same XOR must be chosen, since something below that is left out."""
        mission, source = self.relaxed.mission, node.source
        above = mission.parent.get(source) if source is not None else None
        if above is None or source is None or mission.by_id[above].gate != "xor" or source in self.done:
            return False
        return any(other in self.done or other in self.fixed.left_out for other in mission.by_id[above].children)

    def _add(self, node: GroundedNode) -> int:
        self.nodes.append(node)
        return len(self.nodes) - 1

    def _optional(self, part: str, parent: int) -> int:
        """An XOR of a part and of leaving it out; of one of them where that is fixed. The part itself comes first."""
        label = self.relaxed.mission.by_id[part].label
        xor = self._add(GroundedNode(parent=parent, kind="xor", label=label))
        self.optional[part] = xor
        if part in self.fixed.kept or part in self.done:
            return xor
        self.roles.append(Role(label=label))
        leaving = Action(
            name=LEAVING,
            text=label,
            role=len(self.roles) - 1,
            robot_type=self.relaxed.leaver,
            capability=LEAVING,
            estimate=Estimate(0.0, 0.0, float(self.relaxed.weights[part])),
        )
        held = self._add(GroundedNode(parent=xor, kind="and", label=label))
        self._add(GroundedNode(parent=held, kind="action", label=label, action=leaving))
        self.leaving[part] = held
        return xor


def _worthless(action: Action | None) -> Action | None:
    return None if action is None else replace(action, estimate=Estimate(0.0, 0.0, 0.0))
