"""Small scheduling instances written by hand: parts of robots, missions over them, and a plain validator of schedules."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from missiontree.mission.alternative import Alternative, Assignment, Choice, RoleType
from missiontree.mission.certificate import Certificate
from missiontree.mission.control import Control
from missiontree.mission.entity import Entity
from missiontree.mission.estimate import Estimate
from missiontree.mission.fleet import Fleet, RobotType
from missiontree.mission.grounded import Action, GroundedLink, GroundedNode, GroundedTree, Role
from missiontree.mission.position import Position
from missiontree.mission.scene import Scene
from missiontree.mission.schedule import Schedule
from missiontree.scheduling.greedy import greedy


def work(duration_s: float = 0, **more: Any) -> dict[str, Any]:
    """An action of a part; ``more`` as in :class:`Action`."""
    return {"duration_s": duration_s, **more}


def move(at: str, *brings: str, nominal_s: float = 0, **more: Any) -> dict[str, Any]:
    """A move to a place, with what it brings."""
    return {"duration_s": nominal_s, "at": at, "moves": True, "brings": brings, **more}


@dataclass(frozen=True)
class Part:
    """A role: the robot type that fills it and its actions. Its node in the mission carries its name."""

    name: str
    robot_type: str
    actions: Sequence[Mapping[str, Any]]
    team: int | None = None


@dataclass(frozen=True)
class Group:
    """An inner node over parts and groups; an ``xor`` takes its first child."""

    name: str
    below: Sequence[Part | Group]
    kind: str = "and"


@dataclass
class Instance:
    """A mission ready to be scheduled."""

    tree: GroundedTree
    alternative: Alternative
    node: dict[str, int]

    def timed(self, **times: tuple[float, float | None]) -> Instance:
        """The same with a release time and a deadline at nodes by name, ``_`` for the dot in an action's."""
        of = {self.node[name.replace("_", ".")]: given for name, given in times.items()}
        nodes = tuple(
            replace(node, release_s=of[index][0], deadline_s=of[index][1]) if index in of else node
            for index, node in enumerate(self.tree.nodes)
        )
        return Instance(replace(self.tree, nodes=nodes), self.alternative, self.node)


@dataclass
class _Building:
    nodes: list[GroundedNode] = field(default_factory=list)
    roles: list[Role] = field(default_factory=list)
    named: dict[str, int] = field(default_factory=dict)


def mission(
    below: Sequence[Part | Group],
    links: Sequence[tuple[str, str] | tuple[str, str, str]] = (),
    witness: Mapping[str, str] | None = None,
) -> Instance:
    """Parts and groups under one root; links between their names. An action's node is named ``<part>.<index>``."""
    made = _Building([GroundedNode(parent=-1, kind="and", label="root")], [], {"root": 0})
    role_of: dict[str, int] = {}
    waiting: list[tuple[int, Part | Group]] = [(0, item) for item in reversed(below)]
    while waiting:
        parent, item = waiting.pop()
        index = made.named[item.name] = len(made.nodes)
        kind = item.kind if isinstance(item, Group) else "and"
        made.nodes.append(GroundedNode(parent=parent, kind=kind, label=item.name))  # type: ignore[arg-type]
        if isinstance(item, Group):
            waiting.extend((index, inner) for inner in reversed(item.below))
            continue
        role = role_of[item.name] = len(made.roles)
        made.roles.append(Role(label=item.name, team=item.team))
        for number, given in enumerate(item.actions):
            name = f"{item.name}.{number}"
            action = Action(
                name=f"a{number}",
                text=name,
                role=role,
                robot_type=item.robot_type,
                capability="work",
                estimate=Estimate(1.0),
                **given,
            )
            made.named[name] = len(made.nodes)
            made.nodes.append(GroundedNode(parent=index, kind="action", label=name, action=action))
    tree = GroundedTree(
        objective="test",
        nodes=tuple(made.nodes),
        roles=tuple(made.roles),
        links=tuple(
            GroundedLink(made.named[link[0]], made.named[link[1]], link[2] if len(link) > 2 else "precedence")  # type: ignore[arg-type]
            for link in links
        ),
    )
    return Instance(
        tree, _alternative(tree, {role_of[part]: robot for part, robot in (witness or {}).items()}), made.named
    )


def _alternative(tree: GroundedTree, witness: Mapping[int, str]) -> Alternative:
    """The alternative that takes the first child of every reached XOR."""
    choices: list[Choice] = []
    types: dict[int, str] = {}
    stack = [0]
    while stack:
        node = stack.pop()
        action = tree.nodes[node].action
        if action is not None:
            types[action.role] = action.robot_type
        below = tree.children[node]
        if tree.nodes[node].kind == "xor":
            choices.append(Choice(node, below[0]))
            below = below[:1]
        stack.extend(reversed(below))
    return Alternative(
        rank=1,
        utility=0.0,
        choices=tuple(choices),
        roles=tuple(RoleType(role, kind) for role, kind in sorted(types.items())),
        witness=tuple(Assignment(role, robot) for role, robot in sorted(witness.items())),
        certificate=Certificate(claim="unproven", method="by_hand"),
    )


def robots(name: str, count: int = 1, speed: float | None = None, **more: Any) -> RobotType:
    """A type of interchangeable robots that can work."""
    limits = dict(more.pop("limits", {}))
    if speed is not None:
        limits["max_speed_mps"] = speed
    if "robots" not in more:
        more["count"] = count
    return RobotType(id=name, capabilities={"work": 1.0}, limits=limits, **more)


def at(x_m: float, y_m: float = 0.0) -> Position:
    """A point of the plane."""
    return Position(x_m, y_m)


def scene(speeds: Mapping[str, float] | None = None, **positions: float | None) -> Scene:
    """Entities on the x axis by name; None for an unknown position. ``speeds`` caps how fast some can be led."""
    return Scene(
        entities=tuple(
            Entity(
                id=name,
                position=None if x_m is None else at(x_m),
                max_speed_mps=(speeds or {}).get(name),
            )
            for name, x_m in positions.items()
        )
    )


def schedule(
    instance: Instance, *types: RobotType, world: Scene | None = None, control: Control | None = None
) -> Schedule:
    """The greedy schedule of an instance."""
    return greedy(instance.tree, instance.alternative, Fleet(types), world or Scene(), control or Control())


def times(instance: Instance, result: Schedule) -> dict[str, tuple[float, float]]:
    """Start and end by action name."""
    return {instance.tree.action(one.leaf).text: (one.start_s, one.end_s) for one in result.actions}


def robot_of(instance: Instance, result: Schedule) -> dict[str, str]:
    """Robot by part name."""
    return {instance.tree.roles[one.role].label: one.robot for one in result.assignments}
