"""Authored and grounded trees in one form, with all that outlines and pictures show of them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from missiontree.mission.grounded import GroundedTree
from missiontree.mission.tree import Gate, LinkKind, MissionNode, MissionTree
from missiontree.reporting.escape import one_line

ShapeKind = Literal["task", "routine", "action", "impossible"]


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
        ``task``, ``routine`` (a subtree not expanded), ``action``, or ``impossible``: nobody can do it.
    gate
        Over its children; None for a leaf.
    """

    name: str
    label: str
    note: str
    kind: ShapeKind
    gate: Gate | None


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


def shape_of(tree: MissionTree | GroundedTree) -> Shape:
    """What there is to show of a tree. Linear."""
    return _authored(tree) if isinstance(tree, MissionTree) else _grounded(tree)


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
}


def _authored(tree: MissionTree) -> Shape:
    number = {node.id: index for index, node in enumerate(tree.nodes)}
    labels = {entity.id: entity.label for entity in tree.entities}
    return Shape(
        nodes=tuple(_authored_node(node, labels) for node in tree.nodes),
        children=tuple(tuple(number[child] for child in node.children) for node in tree.nodes),
        links=tuple((number[link.first], number[link.second], link.kind) for link in tree.links),
    )


def _authored_node(node: MissionNode, labels: Mapping[str, str]) -> ShapeNode:
    label = one_line(node.label)
    if node.routine is None:
        return ShapeNode(node.id, label, "" if node.children else "no routine yet", "task", node.gate)
    names = node.arguments.values()
    call = f"{node.routine}({', '.join(names)})"
    called = f"{node.routine}({', '.join(labels.get(name, name) for name in names)})"
    # A label that already reads as the call says it all: "Search(Red crate)" for Search(red_crate); of any other call it would lie.
    notes = [] if _folded(label) in {_folded(call), _folded(called)} else [call]
    if node.resources is not None:
        notes.append(f"only {_listed(node.resources)}")
    return ShapeNode(node.id, label, ", ".join(notes), "routine", None)


def _folded(call: str) -> str:
    """A call as calls are compared: letters, digits and what parts its arguments."""
    return "".join(sign for sign in call.casefold() if sign.isalnum() or sign in "(,")


def _listed(names: Sequence[str]) -> str:
    return " or ".join(names) if names else "nobody"


def _grounded(tree: GroundedTree) -> Shape:
    nodes = []
    for index, node in enumerate(tree.nodes):
        label, below = one_line(node.label), tree.children[index]
        if node.action is not None:
            nodes.append(ShapeNode(f"#{index}", label, "", "action", None))
        elif node.kind == "xor" and not below:
            nodes.append(ShapeNode(f"#{index}", label, "nobody can do it", "impossible", None))
        else:
            gate: Gate = "xor" if node.kind == "xor" else "and"
            nodes.append(ShapeNode(f"#{index}", label, "", "task", gate if below else None))
    links = tuple((link.first, link.second, link.kind) for link in tree.links)
    return Shape(tuple(nodes), tree.children, links, tuple(_routine_roots(tree)))


def _routine_roots(tree: GroundedTree) -> Iterator[int]:
    """Topmost nodes of the subtrees that came from routines."""
    routines = {role.source for role in tree.roles if role.source is not None}
    for index, node in enumerate(tree.nodes):
        if node.source in routines and (index == 0 or tree.nodes[node.parent].source != node.source):
            yield index
