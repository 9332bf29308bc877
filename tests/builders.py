"""Small builders that tests of every floor share: the paper's fleet and missions, and grounded trees written as nested calls."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from missiontree.mission.brief import MissionBrief
from missiontree.mission.entity import Entity
from missiontree.mission.estimate import Estimate
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.grounded import (
    Action,
    GroundedLink,
    GroundedNode,
    GroundedTree,
    Grounding,
    NodeKind,
    Role,
)
from missiontree.mission.routine import RoutineLibrary
from missiontree.mission.tree import Link, LinkKind, MissionNode, MissionTree
from missiontree.routines.ground import ground
from missiontree.routines.library import built_in

PERSON, ANIMAL, PLACE = "person", "animal", "place"


def paper_fleet() -> Fleet:
    """The paper's Table I: five robots of four types, qualities only."""
    return Fleet(
        (
            RobotType(id="mobile_scooter", label="Mobile Scooter", capabilities={"follow": 0.5, "reach": 1.0}, count=1),
            RobotType(
                id="tele_robot",
                label="Tele-Robot",
                capabilities={"search": 1.0, "follow": 0.5, "reach": 1.0},
                count=2,
            ),
            RobotType(
                id="transportation_robot",
                label="Transportation Robot",
                capabilities={"search": 0.3, "follow": 0.3, "reach": 0.3, "carry": 1.0},
                count=1,
            ),
            RobotType(
                id="social_robot",
                label="Social Robot",
                capabilities={"follow": 0.3, "reach": 0.3, "message_display": 1.0},
                count=1,
            ),
        ),
        label="Sample fleet",
    )


def reunite_tree() -> MissionTree:
    """The paper's first mission: search the child, then bring it to its mother."""
    return MissionTree(
        objective="Reunite mom with her lost child",
        nodes=(
            MissionNode(id="root", label="Reunite mom with her lost child", gate="and", children=("locate", "reunite")),
            MissionNode(id="locate", label="Locate the Lost Child", gate="and", children=("search",)),
            routine_node("search", "Search", agent="Child"),
            MissionNode(id="reunite", label="Reunite the Child with Mom", gate="and", children=("transport",)),
            routine_node("transport", "ReachAndTransport", agent="Child", location="Mom"),
        ),
        links=(Link("locate", "reunite"),),
        entities=(Entity(id="Child", kind=PERSON), Entity(id="Mom", kind=PERSON)),
    )


def rescue_tree() -> MissionTree:
    """The paper's second mission: search firefighter and cat in parallel, bring the cat to safety."""
    return MissionTree(
        objective="Rescue cat trapped in a building on fire",
        nodes=(
            MissionNode(id="root", label="Rescue the cat", gate="and", children=("firefighter", "cat", "bring")),
            routine_node("firefighter", "Search", agent="firefighter"),
            routine_node("cat", "Search", agent="cat"),
            routine_node("bring", "ReachAndTransport", agent="cat", location="safe_area"),
        ),
        links=(Link("cat", "bring"),),
        entities=(
            Entity(id="firefighter", kind=PERSON),
            Entity(id="cat", kind=ANIMAL),
            Entity(id="safe_area", kind=PLACE, label="safe area"),
        ),
    )


def routine_node(node_id: str, routine: str, resources: tuple[str, ...] | None = None, **arguments: str) -> MissionNode:
    """A leaf of a mission tree."""
    label = f"{routine}({', '.join(arguments.values())})"
    return MissionNode(id=node_id, label=label, routine=routine, arguments=arguments, resources=resources)


def flat_tree(*leaves: MissionNode, links: tuple[Link, ...] = (), entities: tuple[Entity, ...] = ()) -> MissionTree:
    """A mission tree with an AND root (id ``root``) right over the leaves."""
    root = MissionNode(id="root", label="Mission", gate="and", children=tuple(leaf.id for leaf in leaves))
    return MissionTree(objective="Mission", nodes=(root, *leaves), links=links, entities=entities)


def brief_of(
    tree: MissionTree | str = "Mission",
    fleet: Fleet | None = None,
    routines: RoutineLibrary | None = None,
    **others: Any,
) -> MissionBrief:
    """A brief with the paper's fleet and the built-in routines, unless others are given."""
    return MissionBrief(
        text=tree if isinstance(tree, str) else tree.objective,
        fleet=fleet or paper_fleet(),
        routines=routines or built_in(),
        **others,
    )


def grounding_of(tree: MissionTree, **brief: Any) -> Grounding:
    """The tree grounded over :func:`brief_of` it."""
    return ground(tree, brief_of(tree, **brief))


def actions_of(tree: GroundedTree) -> list[Action]:
    """All actions, in order of the leaves."""
    return [node.action for node in tree.nodes if node.action is not None]


def people(*names: str) -> tuple[Entity, ...]:
    """Persons of those names, of whom nothing else is known."""
    return tuple(Entity(id=name, kind=PERSON) for name in names)


def trivial_fleet(types: Mapping[str, int] | Iterable[str] = ("r",), **common: Any) -> Fleet:
    """Robot types with a count each (default 1), alike in all else: ``trivial_fleet({"a": 2, "b": 1}, limits={"energy_j": 5})``."""
    counts = types if isinstance(types, Mapping) else dict.fromkeys(types, 1)
    return Fleet(tuple(RobotType(id=name, count=count, **common) for name, count in counts.items()))


@dataclass(frozen=True)
class Spec:
    """A grounded subtree, not yet numbered."""

    kind: NodeKind
    label: str
    children: tuple[Spec, ...] = ()
    role: str = ""
    source: str | None = None
    action: Mapping[str, Any] = field(default_factory=dict)


def leaf(
    label: str = "act",
    robot_type: str = "r",
    role: str = "",
    *,
    quality: float = 1.0,
    duration_s: float = 0.0,
    cost: float = 0.0,
    **fields: Any,
) -> Spec:
    """
    An action.

    Leaves with the same role name share a role; without one, each label has a role of its own. Uses count as certain unless
    ``uses_at_least`` is given.
    """
    action = {
        "name": "act",
        "text": label,
        "robot_type": robot_type,
        "capability": "any",
        "estimate": Estimate(quality, duration_s, cost),
        "duration_s": duration_s,
        "uses_at_least": fields.get("uses", {}),
        **fields,
    }
    return Spec("action", label, role=role or label, action=action)


def and_(*children: Spec, label: str = "and", source: str | None = None) -> Spec:
    """All children."""
    return Spec("and", label, children, source=source)


def xor_(*children: Spec, label: str = "xor", source: str | None = None) -> Spec:
    """One child; without children, impossible."""
    return Spec("xor", label, children, source=source)


def grounded(
    root: Spec,
    links: Iterable[tuple[str, str] | tuple[str, str, LinkKind]] = (),
    teams: Mapping[str, int] | None = None,
    objective: str = "Mission",
) -> GroundedTree:
    """
    Number a nested spec in preorder.

    Links name nodes by label, which must then stand once. ``teams`` gives a team to roles by name.
    """
    nodes: list[GroundedNode] = []
    roles: dict[str, int] = {}
    stack: list[tuple[Spec, int]] = [(root, -1)]
    while stack:
        spec, parent = stack.pop()
        action = None
        if spec.kind == "action":
            action = Action(role=roles.setdefault(spec.role, len(roles)), **spec.action)
        stack += [(child, len(nodes)) for child in reversed(spec.children)]
        nodes.append(GroundedNode(parent=parent, kind=spec.kind, label=spec.label, source=spec.source, action=action))
    return GroundedTree(
        objective=objective,
        nodes=tuple(nodes),
        roles=tuple(Role(label=name, team=(teams or {}).get(name)) for name in roles),
        links=tuple(_numbered(link, nodes) for link in links),
    )


def index_of(nodes: Iterable[GroundedNode], label: str) -> int:
    """Index of the one node with that label."""
    found = [index for index, node in enumerate(nodes) if node.label == label]
    assert len(found) == 1, f"{len(found)} nodes are labelled {label!r}"
    return found[0]


def _numbered(link: tuple[str, str] | tuple[str, str, LinkKind], nodes: list[GroundedNode]) -> GroundedLink:
    first, second, *kind = link
    return GroundedLink(index_of(nodes, first), index_of(nodes, second), *kind)


def with_type(fleet: Fleet, type_id: str, **changes: Any) -> Fleet:
    """The fleet with fields of one robot type changed."""
    return replace(fleet, types=tuple(replace(kind, **changes) if kind.id == type_id else kind for kind in fleet.types))
