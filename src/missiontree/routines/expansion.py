"""One routine call becomes a subtree: an XOR over its ways and the robot types that can go them, down to actions."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations_with_replacement, product

from missiontree.errors import InputError
from missiontree.estimation.estimator import Estimator
from missiontree.mission.entity import Entity
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.frozen_map import FrozenMap
from missiontree.mission.grounded import Action, GroundedLink, GroundedNode, NodeKind, Role
from missiontree.mission.scene import Scene
from missiontree.mission.tree import MissionNode
from missiontree.routines.calls import Call, Way
from missiontree.routines.compose import FlatAction, FlatRole, Order
from missiontree.routines.estimates import said_of
from missiontree.routines.itinerary import Travel
from missiontree.routines.sharing import held_by

MAX_TEAMS = 10_000
_FIELD = re.compile(r"\{([^{}]*)\}")


@dataclass(slots=True)
class Expansion:
    """
    A grounded tree as it grows, in preorder.

    Parameters
    ----------
    fleet
        Whose types fill the roles.
    estimator
        What says how well, how long and how dear.
    world
        The scene, whose shared resources actions hold.
    """

    fleet: Fleet
    estimator: Estimator
    world: Scene
    nodes: list[GroundedNode] = field(default_factory=list)
    roles: list[Role] = field(default_factory=list)
    links: list[GroundedLink] = field(default_factory=list)
    _teams: int = 0
    _syncs: int = 0
    _prototypes: dict[tuple[int, int, str], tuple[Way, tuple[Action, ...]]] = field(default_factory=dict)

    def add(self, parent: int, kind: NodeKind, label: str, source: str, action: Action | None = None) -> int:
        """Add a node below another; its index."""
        self.nodes.append(GroundedNode(parent=parent, kind=kind, label=label, source=source, action=action))
        return len(self.nodes) - 1

    def time(self, index: int, release_s: float, deadline_s: float | None) -> None:
        """Give a node its times."""
        if release_s or deadline_s is not None:
            self.nodes[index] = replace(self.nodes[index], release_s=release_s, deadline_s=deadline_s)

    def add_call(self, parent: int, node: MissionNode, call: Call) -> int:
        """Add a routine call below a node; the index of its XOR. Without a way the XOR stays empty: it cannot be done."""
        top = self.add(parent, "xor", node.label, node.id)
        for way in call.ways:
            roles = way.offer.branch.roles
            if len(roles) == 1 and roles[0].robots == 1:
                self._add_single(top, node, call, way)
            else:
                self._add_team(top, node, call, way)
        return top

    def _add_single(self, top: int, node: MissionNode, call: Call, way: Way) -> None:
        role = self._new_role(node.label, node.id, None)
        syncs = self._new_syncs(way)
        for type_id in way.offer.types[0]:
            label = f"{way.offer.branch.name} by {self.fleet.by_id[type_id].label}"
            held = self.add(top, "and", label, node.id)
            self._add_actions(held, node, self._actions(call, way, 0, type_id), role, syncs[0])

    def _add_team(self, top: int, node: MissionNode, call: Call, way: Way) -> None:
        """Several robots: an AND of roles, each an XOR over types; alike ones an XOR over multisets of types."""
        branch = way.offer.branch
        together = self.add(top, "and", branch.name, node.id)
        teams: dict[int, int] = {}
        syncs = self._new_syncs(way)
        tops: list[int] = []
        leaves: dict[tuple[int, int], list[int]] = {}
        for index, flat in enumerate(branch.roles):
            team = None if flat.team is None else teams.setdefault(flat.team, self._teams + len(teams))
            choice = self.add(together, "xor", flat.name, node.id)
            tops.append(choice)
            roles = [
                self._new_role(f"{node.label}: {flat.name}{_number(copy, flat.robots)}", node.id, team)
                for copy in range(flat.robots)
            ]
            for types in self._staffings(flat, way.offer.types[index], node):
                labels = [self.fleet.by_id[type_id].label for type_id in types]
                held = self.add(choice, "and", f"{flat.name} by {', '.join(labels)}", node.id)
                for copy, (role, type_id) in enumerate(zip(roles, types, strict=True)):
                    own = held
                    if len(types) > 1:
                        own = self.add(
                            held, "and", f"{flat.name}{_number(copy, flat.robots)} by {labels[copy]}", node.id
                        )
                    added = self._add_actions(own, node, self._actions(call, way, index, type_id), role, syncs[index])
                    for position, leaf in enumerate(added):
                        leaves.setdefault((index, position), []).append(leaf)
        self._teams += len(teams)
        for order in branch.order:
            self._link(order, branch.roles, tops, leaves)
        # parts whose robots merge have one role each, so that a hand-over is always at the edges of its roles
        self.links += [
            GroundedLink(tops[one.first_role], tops[one.second_role], "hand_over") for one in branch.hand_overs
        ]

    def _staffings(self, role: FlatRole, types: Sequence[str], node: MissionNode) -> Iterator[tuple[str, ...]]:
        """Multisets of types for robots that are alike; as many of a type as there are."""
        if math.comb(len(types) + role.robots - 1, role.robots) > MAX_TEAMS:
            raise InputError(
                f"role {role.name!r} can be filled by {role.robots} robots of {len(types)} types in too many ways.",
                where=node.id,
                accepted=f"at most {MAX_TEAMS}",
                hint="Name fewer robot types as its resources.",
            )
        for types_taken in combinations_with_replacement(types, role.robots):
            if all(count <= self.fleet.by_id[name].usable for name, count in Counter(types_taken).items()):
                yield types_taken

    def _add_actions(
        self, parent: int, node: MissionNode, actions: Sequence[Action], role: int, syncs: Sequence[int | None]
    ) -> list[int]:
        return [
            self.add(parent, "action", action.text, node.id, replace(action, role=role, sync=sync))
            for action, sync in zip(actions, syncs, strict=True)
        ]

    def _link(
        self, order: Order, roles: Sequence[FlatRole], tops: Sequence[int], leaves: Mapping[tuple[int, int], list[int]]
    ) -> None:
        """Order two roles: as wholes where the action is at the role's edge, else action by action for every type."""
        ends_role = order.first_action == len(roles[order.first_role].actions) - 1
        firsts = [tops[order.first_role]] if ends_role else leaves[order.first_role, order.first_action]
        starts_role = order.second_action == 0
        seconds = [tops[order.second_role]] if starts_role else leaves[order.second_role, order.second_action]
        self.links += [GroundedLink(first, second) for first, second in product(firsts, seconds)]

    def _new_role(self, label: str, source: str, team: int | None) -> int:
        self.roles.append(Role(label=label, source=source, team=team))
        return len(self.roles) - 1

    def _new_syncs(self, way: Way) -> list[list[int | None]]:
        """A number of its own in the tree for each label of joint work in the branch, by role and action."""
        numbers: dict[str, int] = {}
        flat = [[action.sync for action in role.actions] for role in way.offer.branch.roles]
        for label in (label for labels in flat for label in labels if label is not None):
            numbers.setdefault(label, self._syncs + len(numbers))
        self._syncs += len(numbers)
        return [[None if label is None else numbers[label] for label in labels] for labels in flat]

    def _actions(self, call: Call, way: Way, index: int, type_id: str) -> tuple[Action, ...]:
        """The actions of a type in a role; role and joint number are still to be set. Calls that are alike share them."""
        key = (id(way), index, type_id)
        if key not in self._prototypes:
            role, travels = way.offer.branch.roles[index], way.travels[index, type_id]
            robot_type = self.fleet.by_id[type_id]
            actions = tuple(
                _action(flat, robot_type, travel, call.entities, self.estimator, self.world)
                for flat, travel in zip(role.actions, travels, strict=True)
            )
            self._prototypes[key] = (way, actions)  # the way is kept, so that its id stays its own
        return self._prototypes[key][1]


def _action(
    flat: FlatAction,
    robot_type: RobotType,
    travel: Travel,
    entities: Mapping[str, Entity],
    estimator: Estimator,
    world: Scene,
) -> Action:
    step = flat.step
    target = step.goes_to or step.at
    said = said_of(flat, robot_type, travel, entities, estimator)
    return Action(
        name=step.name,
        text=_text(flat, robot_type, entities),
        role=0,
        robot_type=robot_type.id,
        capability=flat.rating,
        estimate=said.estimate,
        duration_s=said.alone_s,
        uses=step.uses,
        uses_at_least=_certain_uses(step.uses, robot_type, travel.certain_m),
        at=None if target is None else entities[target].id,
        moves=step.goes_to is not None,
        brings=tuple(dict.fromkeys(entities[name].id for name in step.brings)),
        finds=None if step.finds is None else entities[step.finds].id,
        open_ended=step.open_ended,
        holds=held_by(step, entities, world),
        travel_at_least_s=said.alone_s if step.goes_to is not None and travel.nominal else travel.certain_s,
    )


def _certain_uses(uses: Mapping[str, float], robot_type: RobotType, certain_m: float) -> Mapping[str, float]:
    if not certain_m or not robot_type.uses_per_m:
        return uses
    names = dict.fromkeys((*uses, *robot_type.uses_per_m))
    return FrozenMap({name: uses.get(name, 0.0) + robot_type.uses_per_m.get(name, 0.0) * certain_m for name in names})


def _text(flat: FlatAction, robot_type: RobotType, entities: Mapping[str, Entity]) -> str:
    def filled(match: re.Match[str]) -> str:
        name = match[1]
        return robot_type.label if name == "robot" else entities[flat.fields[name]].label

    return _FIELD.sub(filled, flat.step.text)


def _number(copy: int, robots: int) -> str:
    return f" {copy + 1}" if robots > 1 else ""
