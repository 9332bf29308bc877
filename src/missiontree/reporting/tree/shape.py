"""Authored and grounded trees in one form, with all that outlines and pictures show of them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

from missiontree.mission.grounded import GroundedTree
from missiontree.mission.times import words_of_times
from missiontree.mission.tree import Gate, LinkKind, MissionNode, MissionTree
from missiontree.reporting.escape import one_line
from missiontree.reporting.palette import Livery

ShapeKind = Literal["task", "routine", "action", "impossible", "more"]
State = Literal["plain", "lit", "quiet"]


@dataclass(frozen=True, slots=True)
class Badge:
    """
    A robot's name on a node.

    Parameters
    ----------
    text
        Name of the robot or of its type, on one line and harmless in a terminal.
    livery
        How the robot's surfaces look.
    """

    text: str
    livery: Livery


@dataclass(frozen=True, slots=True)
class ShapeNode:
    """
    A node to be shown.

    Parameters
    ----------
    name
        What tells it from others of the same label: its id, or its number.
    label
        What people read, on one line and harmless in a terminal.
    note
        What is added to the label; empty if nothing is.
    kind
        ``task``, ``routine`` (a subtree not expanded), ``action``, ``impossible``: nobody can do it, or ``more``: it stands for
        siblings that are not shown.
    gate
        Over its children; None for a leaf.
    role
        Number of the role that an action is part of; None for everything else. Actions of one role are done in their order.
    team
        Who does it, as far as that is to be shown.
    state
        ``lit``: part of the chosen alternative; ``quiet``: not part of it; ``plain`` (default): none is chosen.
    hidden
        How many nodes are folded into it.
    """

    name: str
    label: str
    note: str
    kind: ShapeKind
    gate: Gate | None
    role: int | None = None
    team: tuple[Badge, ...] = ()
    state: State = "plain"
    hidden: int = 0


@dataclass(frozen=True, slots=True)
class Shape:
    """
    A tree to be shown.

    Parameters
    ----------
    nodes
        Parents before children, the root first.
    children
        Children of each node, in order.
    links
        First node, second node and kind of every link.
    frames
        Nodes whose subtrees are attached routines.
    """

    nodes: tuple[ShapeNode, ...]
    children: tuple[tuple[int, ...], ...]
    links: tuple[tuple[int, int, LinkKind], ...]
    frames: tuple[int, ...] = ()

    @property
    def sizes(self) -> list[int]:
        """How many nodes each subtree has, its root included."""
        sizes = [1] * len(self.nodes)
        for node in reversed(range(len(sizes))):
            sizes[node] += sum(sizes[child] for child in self.children[node])
        return sizes


@dataclass(frozen=True, slots=True)
class Names:
    """
    What people call what a mission tree names by id.

    Parameters
    ----------
    entities, robot_types
        Labels by id.
    """

    entities: Mapping[str, str] = field(default_factory=dict)
    robot_types: Mapping[str, str] = field(default_factory=dict)


NO_NAMES = Names()


def shape_of(tree: MissionTree | GroundedTree, names: Names = NO_NAMES) -> Shape:
    """What there is to show of a tree. Linear. The names are those that the tree itself does not know."""
    return _authored(tree, names) if isinstance(tree, MissionTree) else _grounded(tree)


def link_words(shape: Shape) -> Iterator[str]:
    """Every link as a sentence; nodes whose label stands more than once are told apart by their names."""
    counts = Counter(node.label for node in shape.nodes)

    def called(index: int) -> str:
        node = shape.nodes[index]
        return f'"{node.label}"' if counts[node.label] == 1 else f'"{node.label}" ({node.name})'

    for first, second, kind in shape.links:
        yield _SENTENCES[kind].format(called(first), called(second))


_SENTENCES: dict[LinkKind, str] = {
    "precedence": "{} ends before {} starts",
    "same_robot": "{} and {} are done by one and the same robot",
    "different_robot": "{} and {} are done by different robots",
    "until": "{} lasts until {} ends",
    "hand_over": "{} hands over to {}, which starts just then",
}


def _authored(tree: MissionTree, names: Names) -> Shape:
    number = {node.id: index for index, node in enumerate(tree.nodes)}
    known = replace(names, entities={**names.entities, **{entity.id: entity.label for entity in tree.entities}})
    return Shape(
        nodes=tuple(_authored_node(node, known) for node in tree.nodes),
        children=tuple(tuple(number[child] for child in node.children) for node in tree.nodes),
        links=tuple((number[link.first], number[link.second], link.kind) for link in tree.links),
    )


def _authored_node(node: MissionNode, names: Names) -> ShapeNode:
    label, times = one_line(node.label), words_of_times(node.release_s, node.deadline_s)
    if node.routine is None:
        note = ", ".join(times) if node.children else "no routine yet"
        return ShapeNode(node.id, label, note, "task", node.gate)
    arguments = node.arguments.values()
    call = f"{node.routine}({', '.join(arguments)})"
    called = f"{node.routine}({', '.join(names.entities.get(name, name) for name in arguments)})"
    # A label that already reads as the call says it all: "Search(Red crate)" for Search(red_crate); of any other call it would lie.
    notes = [] if folded_name(label) in {folded_name(call), folded_name(called)} else [call]
    if node.resources is not None:
        notes.append(f"only {_listed([one_line(names.robot_types.get(name, name)) for name in node.resources])}")
    return ShapeNode(node.id, label, ", ".join((*notes, *times)), "routine", None)


def folded_name(call: str) -> str:
    """A call or a name as they are compared: letters, digits and what parts arguments."""
    return "".join(sign for sign in call.casefold() if sign.isalnum() or sign in "(,")


def _listed(names: Sequence[str]) -> str:
    return " or ".join(names) if names else "nobody"


def _grounded(tree: GroundedTree) -> Shape:
    nodes = []
    for index, node in enumerate(tree.nodes):
        label, below = one_line(node.label), tree.children[index]
        times = words_of_times(node.release_s, node.deadline_s)
        if node.action is not None:
            joint = () if node.action.sync is None else (f"joint work {node.action.sync + 1}",)
            note = ", ".join((*joint, *times))
            nodes.append(ShapeNode(f"#{index}", label, note, "action", None, node.action.role))
        elif node.kind == "xor" and not below:
            nodes.append(ShapeNode(f"#{index}", label, "nobody can do it", "impossible", None))
        else:
            gate: Gate = "xor" if node.kind == "xor" else "and"
            nodes.append(ShapeNode(f"#{index}", label, ", ".join(times), "task", gate if below else None))
    links = tuple((link.first, link.second, link.kind) for link in tree.links)
    return Shape(tuple(nodes), tree.children, links, tuple(_routine_roots(tree)))


def _routine_roots(tree: GroundedTree) -> Iterator[int]:
    """Topmost nodes of the subtrees that came from routines."""
    routines = {role.source for role in tree.roles if role.source is not None}
    for index, node in enumerate(tree.nodes):
        if node.source in routines and (index == 0 or tree.nodes[node.parent].source != node.source):
            yield index
