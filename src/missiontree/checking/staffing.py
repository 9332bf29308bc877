"""What an alternative selects, derived from its choices by a plain walk that survives any damage."""

from __future__ import annotations

from functools import cached_property
from typing import NamedTuple

from missiontree.mission.alternative import Alternative
from missiontree.mission.grounded import Action, GroundedTree
from missiontree.mission.tree import LinkKind, MissionTree


class Bond(NamedTuple):
    """A link whose two nodes are both selected, with the selected leaves below each."""

    first: int
    second: int
    kind: LinkKind
    first_leaves: tuple[int, ...]
    second_leaves: tuple[int, ...]


class Staffing:
    """
    One alternative and what follows from it.

    Parameters
    ----------
    tree
        The grounded tree.
    mission_tree
        The tree as authored; its links bind even where grounding lost them. None in foreign instances.
    alternative
        The alternative; only its choices are believed.
    """

    def __init__(self, tree: GroundedTree, mission_tree: MissionTree | None, alternative: Alternative) -> None:
        self.tree = tree
        self.mission_tree = mission_tree
        self.alternative = alternative

    @cached_property
    def taken(self) -> dict[int, int]:
        """Child by XOR node, of the choices that make sense; the first counts where a node is chosen for twice."""
        taken: dict[int, int] = {}
        for choice in self.alternative.choices:
            if choice.xor < len(self.tree.nodes) and choice.child in self.tree.children[choice.xor]:
                taken.setdefault(choice.xor, choice.child)
        return taken

    @cached_property
    def reached(self) -> tuple[int, ...]:
        """Selected nodes in preorder; the walk ends at an XOR without a choice."""
        reached, stack = [], [0]
        while stack:
            node = stack.pop()
            reached.append(node)
            if self.tree.nodes[node].kind == "xor":
                stack.extend([self.taken[node]] if node in self.taken else [])
            else:
                stack.extend(reversed(self.tree.children[node]))
        return tuple(reached)

    @cached_property
    def actions(self) -> dict[int, Action]:
        """Selected actions by leaf, in preorder."""
        found = ((node, self.tree.nodes[node].action) for node in self.reached)
        return {node: action for node, action in found if action is not None}

    @cached_property
    def leaves_of_role(self) -> dict[int, tuple[int, ...]]:
        """Selected leaves of every reached role, in tree order, by role in order of index."""
        leaves: dict[int, list[int]] = {}
        for leaf, action in self.actions.items():
            leaves.setdefault(action.role, []).append(leaf)
        return {role: tuple(leaves[role]) for role in sorted(leaves)}

    @cached_property
    def type_of_role(self) -> dict[int, str]:
        """Robot type that the first leaf of every reached role names."""
        return {role: self.actions[leaves[0]].robot_type for role, leaves in self.leaves_of_role.items()}

    @cached_property
    def teams(self) -> dict[int, tuple[int, ...]]:
        """Reached roles by team number."""
        teams: dict[int, list[int]] = {}
        for role in self.leaves_of_role:
            if (team := self.tree.roles[role].team) is not None:
                teams.setdefault(team, []).append(role)
        return {team: tuple(roles) for team, roles in teams.items()}

    @cached_property
    def joint(self) -> dict[int, tuple[int, ...]]:
        """Selected leaves by sync number."""
        joint: dict[int, list[int]] = {}
        for leaf, action in self.actions.items():
            if action.sync is not None:
                joint.setdefault(action.sync, []).append(leaf)
        return {sync: tuple(leaves) for sync, leaves in joint.items()}

    @cached_property
    def leaves_below(self) -> dict[int, tuple[int, ...]]:
        """Selected leaves below every selected node at an end of a link, itself included."""
        ends = {end for pair in self._linked for end in pair[:2]}
        below: dict[int, list[int]] = {node: [] for node in self.reached if node in ends}
        for leaf in self.actions if below else ():
            node = leaf
            while node >= 0:
                if node in below:
                    below[node].append(leaf)
                node = self.tree.nodes[node].parent
        return {node: tuple(leaves) for node, leaves in below.items()}

    @cached_property
    def _linked(self) -> tuple[tuple[int, int, LinkKind], ...]:
        """Links of the grounded tree and those of the mission tree, each once."""
        pairs = dict.fromkeys((link.first, link.second, link.kind) for link in self.tree.links)
        return tuple(pairs | dict.fromkeys(self._authored_links()))

    @cached_property
    def bonds(self) -> tuple[Bond, ...]:
        """Links that bind: those of the grounded tree and those of the mission tree, each once."""
        below = self.leaves_below
        return tuple(
            Bond(first, second, kind, below[first], below[second])
            for first, second, kind in self._linked
            if below.get(first) and below.get(second)
        )

    def _authored_links(self) -> list[tuple[int, int, LinkKind]]:
        if self.mission_tree is None:
            return []
        top: dict[str, int] = {}
        for index, node in enumerate(self.tree.nodes):
            if node.source is not None:
                top.setdefault(node.source, index)
        return [
            (top[link.first], top[link.second], link.kind)
            for link in self.mission_tree.links
            if link.first in top and link.second in top
        ]

    def roles_below(self, leaves: tuple[int, ...]) -> frozenset[int]:
        """Roles of some selected leaves."""
        return frozenset(self.actions[leaf].role for leaf in leaves)
