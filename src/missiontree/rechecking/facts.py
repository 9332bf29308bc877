"""One alternative and its schedule, looked up once: which nodes are selected, which robot does what, and when, in milliseconds."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from missiontree.mission.alternative import Alternative
from missiontree.mission.brief import MissionBrief
from missiontree.mission.grounded import Action, GroundedLink, GroundedTree
from missiontree.mission.position import Position
from missiontree.mission.reason import Reason
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.mission.tree import LinkKind, MissionTree
from missiontree.rechecking.shortest import Ways

TICK_MS = 1

Places = tuple[Position | None, ...]
"""Where something may be, None where that is unknown; more than one where the times do not tell which."""


def milliseconds(seconds: float) -> int:
    """A time of a schedule as a whole number of milliseconds."""
    return round(seconds * 1000)


def broken(rule: str, message: str, *, node: object = "", robot: str = "") -> Reason:
    """What is wrong, as every finding is told."""
    return Reason(rule=rule, message=message, node=str(node), robot=robot)


@dataclass(frozen=True)
class Facts:
    """
    What the rules look at.

    Parameters
    ----------
    brief, mission, tree
        Mission and trees of the plan.
    alternative
        The alternative.
    schedule
        Its schedule; None if the plan has none for it, or nothing is scheduled in it.
    ways
        How long ways are at least, in the scene with all entities that the plan knows of.
    """

    brief: MissionBrief
    mission: MissionTree | None
    tree: GroundedTree
    alternative: Alternative
    schedule: Schedule | None
    ways: Ways

    @cached_property
    def selected(self) -> list[int]:
        """Nodes that the choices select, in preorder. Below an XOR without a proper choice nothing is selected."""
        taken = {choice.xor: choice.child for choice in self.alternative.choices}
        found: list[int] = []
        waiting = [0]
        while waiting:
            node = waiting.pop()
            found.append(node)
            children = self.tree.children[node]
            if self.tree.nodes[node].kind == "xor":
                waiting.extend(child for child in children if child == taken.get(node))
            else:
                waiting.extend(reversed(children))
        return found

    @cached_property
    def leaves(self) -> dict[int, Action]:
        """Selected actions by leaf, in preorder."""
        kept = {}
        for node in self.selected:
            action = self.tree.nodes[node].action
            if action is not None:
                kept[node] = action
        return kept

    @cached_property
    def offered(self) -> dict[int, Action]:
        """All actions of the tree by leaf, selected or not: what is offered to a type at all."""
        return {leaf: node.action for leaf, node in enumerate(self.tree.nodes) if node.action is not None}

    @cached_property
    def leaves_of_role(self) -> dict[int, list[int]]:
        """Selected leaves of each reached role, in the order in which they are done."""
        kept: dict[int, list[int]] = {}
        for leaf, action in self.leaves.items():
            kept.setdefault(action.role, []).append(leaf)
        return kept

    @cached_property
    def spans(self) -> dict[int, tuple[int, int]]:
        """By selected node, which of the selected leaves stand below it, itself included: from one number up to another, in preorder."""
        begin, count = dict[int, int](), 0
        for node in self.selected:
            begin[node] = count
            count += node in self.leaves
        end = {node: begin[node] + (node in self.leaves) for node in self.selected}
        for node in reversed(self.selected):
            above = self.tree.nodes[node].parent
            if above in end:
                end[above] = max(end[above], end[node])
        return {node: (begin[node], end[node]) for node in self.selected}

    @cached_property
    def in_order(self) -> list[int]:
        """Selected leaves, in preorder."""
        return list(self.leaves)

    def below(self, node: int) -> list[int]:
        """Selected leaves below a node; none if the node is not selected."""
        first, last = self.spans.get(node, (0, 0))
        return self.in_order[first:last]

    @cached_property
    def joint(self) -> dict[int, list[int]]:
        """Selected leaves by the sync label that they share."""
        kept: dict[int, list[int]] = {}
        for leaf, action in self.leaves.items():
            if action.sync is not None:
                kept.setdefault(action.sync, []).append(leaf)
        return kept

    @cached_property
    def bringing(self) -> dict[str, list[int]]:
        """Selected leaves by the entity that they bring along."""
        kept: dict[str, list[int]] = {}
        for leaf, action in self.leaves.items():
            for entity in action.brings:
                kept.setdefault(entity, []).append(leaf)
        return kept

    @cached_property
    def places(self) -> dict[int, Places]:
        """Where actions may be done, as far as :func:`missiontree.rechecking.places.places_of` was asked."""
        return {}

    def together(self, leaf: int) -> list[int]:
        """The leaf, and what is joint with it."""
        sync = self.leaves[leaf].sync
        return [leaf] if sync is None else self.joint[sync]

    def links(self, kind: LinkKind) -> list[GroundedLink]:
        """Links of a kind that bind: both of their nodes are selected, and work stands below both."""
        return [
            link for link in self.tree.links if link.kind == kind and self.below(link.first) and self.below(link.second)
        ]

    @cached_property
    def start_ms(self) -> dict[int, int]:
        """Start of each scheduled leaf."""
        return {one.leaf: milliseconds(one.start_s) for one in (self.schedule.actions if self.schedule else ())}

    @cached_property
    def end_ms(self) -> dict[int, int]:
        """End of each scheduled leaf."""
        return {one.leaf: milliseconds(one.end_s) for one in (self.schedule.actions if self.schedule else ())}

    @cached_property
    def robot_of_role(self) -> dict[int, str]:
        """Robot of each role, as the schedule assigns it."""
        return {one.role: one.robot for one in (self.schedule.assignments if self.schedule else ())}

    @cached_property
    def roles_of_robot(self) -> dict[str, list[int]]:
        """Reached roles of each robot, by start."""
        kept: dict[str, list[int]] = {}
        for role, robot in self.robot_of_role.items():
            if role in self.leaves_of_role:
                kept.setdefault(robot, []).append(role)
        return {robot: sorted(roles, key=self.hold_of) for robot, roles in kept.items()}

    def hold_of(self, role: int) -> tuple[int, int]:
        """From when to when a role holds its robot: from the start of its first action to the end of its last."""
        leaves = self.leaves_of_role[role]
        return min(self.start_ms[leaf] for leaf in leaves), max(self.end_ms[leaf] for leaf in leaves)

    @property
    def world(self) -> Scene:
        """The scene, with all entities that the plan knows of."""
        return self.ways.world

    def label(self, node: int) -> str:
        """Label and index of a node."""
        return f"{self.tree.nodes[node].label} [{node}]"
